package starlogo.fitting.minimal
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertTrue;
    import starlogo.geometry.ConvexHull;
    import support.PointSets;

    public class BoxAlongAxisTest
    {
        [Test]
        public function likeTryingEveryPairOfPoints():void
        {
            var random:SeededRandom = new SeededRandom(61);
            var sets:Array = PointSets.hard(random);
            for (var i:int = 0; i < sets.length; i += 2)
            {
                var hull:ConvexHull = new ConvexHull(sets[i + 1]);
                if (hull.dimension < 2 || hull.indices.length > 50)
                {
                    continue;
                }
                var box:BoxAlongAxis = new BoxAlongAxis(hull);
                for each (var direction:Vector.<Number> in directions(hull, random))
                {
                    var x:Number = direction[0];
                    var y:Number = direction[1];
                    var z:Number = direction[2];
                    var expected:Number = bruteForce(hull.convexPoints, x, y, z);
                    var volume:Number = box.measure(x, y, z);
                    var allowed:Number = 1e-6 * expected + 1e-9 * Math.pow(hull.extent, 3);
                    assertTrue(sets[i] + ", direction " + direction + ": " + volume + " instead of " + expected,
                            Math.abs(volume - expected) <= allowed);
                }
            }
        }

        private static function directions(hull:ConvexHull, random:SeededRandom):Vector.<Vector.<Number>>
        {
            var result:Vector.<Vector.<Number>> = new <Vector.<Number>>[new <Number>[1, 0, 0], new <Number>[0, 1, 0],
                    new <Number>[0, 0, 1]];
            for (var i:int = 0; i < 8; i++)
            {
                result.push(unit(random.normal(), random.normal(), random.normal()));
            }
            // across two edges: sides of the hull seen edge on, and straight
            for (i = 0; i < 6 && hull.triangles.length > 0; i++)
            {
                var t:int = 3 * random.integer(0, hull.triangles.length / 3 - 1);
                var a:int = 3 * hull.triangles[t];
                var b:int = 3 * hull.triangles[t + 1];
                var c:int = 3 * hull.triangles[t + 2];
                var p:Vector.<Number> = hull.convexPoints;
                var abX:Number = p[b] - p[a];
                var abY:Number = p[b + 1] - p[a + 1];
                var abZ:Number = p[b + 2] - p[a + 2];
                var acX:Number = p[c] - p[a];
                var acY:Number = p[c + 1] - p[a + 1];
                var acZ:Number = p[c + 2] - p[a + 2];
                result.push(unit(abX, abY, abZ));
                result.push(unit(abY * acZ - abZ * acY, abZ * acX - abX * acZ, abX * acY - abY * acX));
            }
            return result;
        }

        private static function unit(x:Number, y:Number, z:Number):Vector.<Number>
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            return new <Number>[x / length, y / length, z / length];
        }

        // A side of the best rectangle lies along two of the points, seen along the direction.
        private static function bruteForce(p:Vector.<Number>, x:Number, y:Number, z:Number):Number
        {
            var least:Number = Infinity;
            for (var i:int = 0; i < p.length; i += 3)
            {
                for (var j:int = 0; j < i; j += 3)
                {
                    var eX:Number = p[i] - p[j];
                    var eY:Number = p[i + 1] - p[j + 1];
                    var eZ:Number = p[i + 2] - p[j + 2];
                    var along:Number = eX * x + eY * y + eZ * z;
                    eX -= along * x;
                    eY -= along * y;
                    eZ -= along * z;
                    var length:Number = Math.sqrt(eX * eX + eY * eY + eZ * eZ);
                    if (length < 1e-8 * Math.abs(along) || length == 0)
                    {
                        continue;
                    }
                    eX /= length;
                    eY /= length;
                    eZ /= length;
                    var area:Number = span(p, eX, eY, eZ) * span(p, y * eZ - z * eY, z * eX - x * eZ, x * eY - y * eX);
                    least = Math.min(least, area);
                }
            }
            return least * span(p, x, y, z);
        }

        private static function span(p:Vector.<Number>, x:Number, y:Number, z:Number):Number
        {
            var low:Number = Infinity;
            var high:Number = -Infinity;
            for (var i:int = 0; i < p.length; i += 3)
            {
                var along:Number = p[i] * x + p[i + 1] * y + p[i + 2] * z;
                if (along < low)
                {
                    low = along;
                }
                if (along > high)
                {
                    high = along;
                }
            }
            return high - low;
        }
    }
}
