package starlogo.convex
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import support.PlainDistance;

    /** Two triangles against their distance: ConvexKernel is right about all that are not within 1e-11 of their size of touching. */
    public class ConvexKernelTrianglesTest
    {
        private static const TOLERANCE:Number = 1e-12;
        private static const BAND:Number = 1e-11;

        [Test]
        public function anyTriangles():void
        {
            compare(400, 61, function(random:SeededRandom):Array
                {
                    return [triangle(random, 1), triangle(random, 1)];
                });
        }

        [Test]
        public function closeOnes():void
        {
            // a corner, or the middle of an edge, of one is close to a corner, an edge or the inside of the other
            compare(500, 62, function(random:SeededRandom):Array
                {
                    var a:Array = triangle(random, 1);
                    var b:Array = triangle(random, 1);
                    var to:Array = mix(a, random.pick([[1, 0, 0], [0.5, 0.5, 0], [0.3, 0.3, 0.4], [0, 0.2, 0.8]]));
                    var from:Array = mix(b, random.pick([[1, 0, 0], [0.5, 0.5, 0]]));
                    var gap:Number = random.pick([1e-5, 1e-3, 3e-7, 0]);
                    return [a, moved(b, to[0] - from[0] + gap * random.normal(), to[1] - from[1] + gap * random.normal(), to[2] - from[2] + gap * random.normal())];
                });
        }

        [Test]
        public function inOnePlaneOrNearly():void
        {
            compare(900, 64, function(random:SeededRandom):Array
                {
                    var tilt:Number = random.pick([0, random.logBetween(1e-9, 1e-2)]);
                    var a:Array = flattened(triangle(random, 1), 0);
                    // some are in a plane beside the other
                    var b:Array = flattened(triangle(random, 0.7), random.pick([0, 0, 0, 1e-4]));
                    for (var i:int = 2; i < 9; i += 3)
                    {
                        b[i] += tilt * random.normal();
                    }
                    return turned(random, [a, moved(b, random.between(-1, 1), random.between(-1, 1), 0)]);
                });
        }

        [Test]
        public function withoutArea():void
        {
            compare(600, 65, function(random:SeededRandom):Array
                {
                    var isFlat:Boolean = random.chance();
                    var a:Array = random.chance(0.7) ? segment(random) : triangle(random, 1);
                    var b:Array = segment(random);
                    if (isFlat)
                    {
                        a = flattened(a, 0);
                        b = flattened(b, 0);
                    }
                    if (random.chance(0.3))
                    {
                        // they cross, or share a corner
                        var s:Number = random.pick([0, random.between(0, 1)]);
                        var t:Number = random.pick([0, random.between(0, 1)]);
                        var from:Array = mix(b, [1 - s, s, 0]);
                        var to:Array = mix(a, [1 - t, t, 0]);
                        b = moved(b, to[0] - from[0], to[1] - from[1], to[2] - from[2]);
                    }
                    return [a, b];
                });
        }

        [Test]
        public function needles():void
        {
            compare(400, 66, function(random:SeededRandom):Array
                {
                    var a:Array = segment(random);
                    var b:Array = random.chance() ? segment(random) : triangle(random, 1);
                    var width:Number = random.logBetween(1e-10, 1e-3);
                    for (var i:int = 0; i < 9; i++)
                    {
                        a[i] += width * random.normal();
                    }
                    if (random.chance())
                    {
                        b = moved(b, a[3] - b[0], a[4] - b[1], a[5] - b[2]);
                    }
                    return [a, b];
                });
        }

        [Test]
        public function neighboursOfOneModelMeet():void
        {
            var random:SeededRandom = new SeededRandom(67);
            for (var i:int = 0; i < 300; i++)
            {
                var a:Array = triangle(random, 1);
                var b:Array = triangle(random, 1);
                for (var shared:int = random.pick([3, 6, 9]) - 1; shared >= 0; shared--)
                {
                    b[shared] = a[shared];
                }
                assertTrue(meet(a, b));
            }
        }

        private static function compare(count:int, seed:uint, make:Function):void
        {
            var random:SeededRandom = new SeededRandom(seed);
            var hits:int = 0;
            var close:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var pair:Array = make(random);
                var distance:Number = PlainDistance.between(pair[0], pair[1]);
                var isHit:Boolean = meet(pair[0], pair[1]);
                var what:String = "pair " + i + ", " + distance + " apart";
                // rounding may turn 0 to 1e-16
                if (distance <= TOLERANCE / 10)
                {
                    hits++;
                    assertTrue(what, isHit);
                }
                else if (distance > BAND)
                {
                    assertTrue(what, !isHit);
                }
                else
                {
                    close++;
                }
                compareOrders(what, pair[0], pair[1], isHit);
            }
            assertTrue("hits: " + hits + " of " + count, hits > 0.05 * count && hits < 0.9 * count);
            assertTrue("too close to tell: " + close, close < 0.2 * count);
        }

        // Any order of corners and of the two, unless too close to tell.
        private static function compareOrders(what:String, a:Array, b:Array, isHit:Boolean):void
        {
            var nearby:Number = PlainDistance.between(a, b);
            if (nearby > TOLERANCE / 10 && nearby < BAND)
            {
                return;
            }
            var turnedA:Array = a.slice(3).concat(a.slice(0, 3));
            var mirroredB:Array = b.slice(3, 6).concat(b.slice(0, 3), b.slice(6));
            assertEquals(what, isHit, meet(b, a));
            assertEquals(what, isHit, meet(turnedA, b));
            assertEquals(what, isHit, meet(a, mirroredB));
            assertEquals(what, isHit, meet(mirroredB, turnedA));
        }

        private static function meet(a:Array, b:Array):Boolean
        {
            var first:ConvexShape = new ConvexShape();
            var second:ConvexShape = new ConvexShape();
            first.setTriangle(Vector.<Number>(a), 0);
            second.setTriangle(Vector.<Number>(b), 0);
            second.margin += TOLERANCE;
            return new ConvexKernel().areTouching(first, second);
        }

        private static function triangle(random:SeededRandom, size:Number):Array
        {
            var corners:Array = [];
            for (var i:int = 0; i < 9; i++)
            {
                corners.push(size * random.between(-1, 1));
            }
            return corners;
        }

        // A triangle without area: three points on a line, any of them between the others, or two or three of them the same.
        private static function segment(random:SeededRandom):Array
        {
            var corners:Array = triangle(random, 1);
            var t:Number = random.pick([0, 1, 0.5, 0.25, 2, -1]);
            for (var i:int = 0; i < 3; i++)
            {
                corners[6 + i] = corners[i] + t * (corners[3 + i] - corners[i]);
            }
            return random.chance(0.1) ? corners.slice(0, 3).concat(corners.slice(0, 3), corners.slice(0, 3)) : corners;
        }

        private static function mix(corners:Array, weights:Array):Array
        {
            var point:Array = [0, 0, 0];
            for (var i:int = 0; i < 9; i++)
            {
                point[i % 3] += weights[int(i / 3)] * corners[i];
            }
            return point;
        }

        private static function moved(corners:Array, x:Number, y:Number, z:Number):Array
        {
            var by:Array = [x, y, z];
            return corners.map(function(coordinate:Number, i:int, all:Array):Number
                {
                    return coordinate + by[i % 3];
                });
        }

        private static function flattened(corners:Array, z:Number):Array
        {
            return corners.map(function(coordinate:Number, i:int, all:Array):Number
                {
                    return i % 3 == 2 ? z : coordinate;
                });
        }

        // By one random rotation.
        private static function turned(random:SeededRandom, triangles:Array):Array
        {
            var angle:Number = random.between(0, 6);
            var other:Number = random.between(0, 6);
            return triangles.map(function(corners:Array, i:int, all:Array):Array
                {
                    var out:Array = [];
                    for (var k:int = 0; k < 9; k += 3)
                    {
                        var x:Number = corners[k] * Math.cos(angle) - corners[k + 2] * Math.sin(angle);
                        var z:Number = corners[k] * Math.sin(angle) + corners[k + 2] * Math.cos(angle);
                        var y:Number = corners[k + 1] * Math.cos(other) - z * Math.sin(other);
                        out.push(x, y, corners[k + 1] * Math.sin(other) + z * Math.cos(other));
                    }
                    return out;
                });
        }
    }
}
