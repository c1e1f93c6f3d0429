package starlogo.intersection
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertTrue;
    import starlogo.intersection.distance.DistanceResult;
    import support.Effort;
    import support.PlainDistance;

    /**
     * The closest points of triangles. That they are the closest is proved for each pair: no corner of one or the other is between the planes
     * through the points at right angles to the line between them. That each is on its triangle, by areas; that triangles meet, by
     * another reckoning.
     */
    public class TrianglePairDistanceTest
    {
        // of the triangles' size and their distance
        private static const PRECISION:Number = 1e-14;

        private var _triangles:TrianglePairDistance = new TrianglePairDistance();
        private var _random:SeededRandom = new SeededRandom(2201);
        private var _a:Vector.<Number>;
        private var _b:Vector.<Number>;
        private var _meeting:int = 0;
        private var _worst:Number = 0;

        [Test]
        public function anyTriangles():void
        {
            var count:int = Effort.choose(4000, 400000);
            for (var i:int = 0; i < count; i++)
            {
                var spread:Number = _random.pick([0.1, 0.3, 0.5, 1000]);
                _a = triangle(spread);
                _b = triangle(spread);
                check("pair " + i, true);
            }
            trace("  " + _meeting + " of " + count + " meet; worst error of the others " + _worst);
            assertTrue(_meeting + " meet", _meeting > count / 20 && _meeting < count / 2);
        }

        [Test]
        public function cornerEdgeAndFaceAtAnyGap():void
        {
            var count:int = Effort.choose(3000, 300000);
            for (var i:int = 0; i < count; i++)
            {
                // two that lie on either side of a plane, by one, two or all corners
                var gap:Number = _random.logBetween(1e-9, 10);
                _a = flat(i % 3, 1, gap / 2);
                _b = flat(int(i / 3) % 3, -1, -gap / 2);
                var distance:Number = check("pair " + i, false);
                assertTrue("pair " + i + ": " + distance + " of " + gap, distance >= gap - 1e-12);
            }
        }

        [Test]
        public function needlesAndTrianglesWithoutArea():void
        {
            var count:int = Effort.choose(3000, 300000);
            for (var i:int = 0; i < count; i++)
            {
                _a = needle();
                _b = _random.chance() ? needle() : triangle(1);
                check("pair " + i, false);
            }
        }

        [Test]
        public function longNeedlesAreAsExactAsTheirCorners():void
        {
            for (var i:int = 0; i < 300; i++)
            {
                // a wall a million high in the plane x = 0, and a point beside it
                _a = i % 2 == 0 ? new <Number>[0, 0, -3, 0, 1, -3, 0, 0, 1e6] : new <Number>[0, 0, -3, 0, 0, 1e6, 0, 1, -3];
                var point:Array = [_random.between(0.01, 1), _random.between(0, 0.9), _random.between(-2, 100)];
                _b = new <Number>[point[0], point[1], point[2], point[0], point[1], point[2], point[0], point[1], point[2]];
                _triangles.begin();
                _triangles.add(_a, 0, _b, 0);
                var points:DistanceResult = _triangles.points;
                assertTrue(i + ": distance", Math.abs(Math.sqrt(_triangles.squared) - point[0]) < 1e-9);
                assertTrue(i + ": place", Math.abs(points.aY - point[1]) < 1e-9 && Math.abs(points.aZ - point[2]) < 1e-9);
            }
        }

        // Proves the distance; returns it.
        private function check(what:String, areFat:Boolean):Number
        {
            var size:Number = _random.logBetween(1e-3, 1e3);
            var far:Number = _random.pick([0, 0, 10]);
            for (var i:int = 0; i < 9; i++)
            {
                _a[i] = size * (_a[i] + far);
                _b[i] = size * (_b[i] + far);
            }
            _triangles.begin();
            _triangles.add(_a, 0, _b, 0);
            var points:DistanceResult = _triangles.points;
            var distance:Number = Math.sqrt(_triangles.squared);
            var n:Array = [points.bX - points.aX, points.bY - points.aY, points.bZ - points.aZ];
            var between:Number = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            var slack:Number = PRECISION * (extent(_a) + extent(_b));
            assertTrue(what + ": as far apart as the points", Math.abs(distance - between) <= slack);
            assertTrue(what + ": the first point is on its triangle", offTriangle([points.aX, points.aY, points.aZ], _a) <= slack);
            assertTrue(what + ": the second point is on its triangle", offTriangle([points.bX, points.bY, points.bZ], _b) <= slack);
            if (distance <= slack)
            {
                _meeting++;
                if (areFat)
                {
                    assertTrue(what + ": they meet", PlainDistance.between(listed(_a), listed(_b)) <= slack);
                }
                return distance / size;
            }
            var far1:Number = -Infinity;
            var near2:Number = Infinity;
            for (i = 0; i < 9; i += 3)
            {
                far1 = Math.max(far1, along(n, _a, i, points) / between);
                near2 = Math.min(near2, along(n, _b, i, points) / between);
            }
            // a normal of which rounding turns the direction
            var unsure:Number = slack + 4 * PRECISION * (extent(_a) + extent(_b)) * (extent(_a) + extent(_b)) / distance;
            var error:Number = distance - (near2 - far1);
            _worst = Math.max(_worst, error / (extent(_a) + extent(_b)));
            assertTrue(what + ": nothing is nearer than " + distance + " but by " + error, error <= unsure);
            return distance / size;
        }

        private function along(n:Array, t:Vector.<Number>, at:int, points:DistanceResult):Number
        {
            return n[0] * (t[at] - points.aX) + n[1] * (t[at + 1] - points.aY) + n[2] * (t[at + 2] - points.aZ);
        }

        private function triangle(spread:Number):Vector.<Number>
        {
            var numbers:Vector.<Number> = new Vector.<Number>(9, true);
            var middle:Array = [_random.normal() * spread, _random.normal() * spread, _random.normal() * spread];
            var own:Number = _random.pick([1, 1, _random.logBetween(1e-3, 1)]);
            for (var i:int = 0; i < 9; i++)
            {
                numbers[i] = middle[i % 3] + own * _random.between(-1, 1);
            }
            return numbers;
        }

        // As near to the plane z = height as it gets in a corner, an edge or all over, the rest on one side; turned any way.
        private function flat(most:int, side:int, height:Number):Vector.<Number>
        {
            var numbers:Vector.<Number> = new Vector.<Number>(9, true);
            for (var i:int = 0; i < 3; i++)
            {
                numbers[3 * i] = _random.between(-1, 1);
                numbers[3 * i + 1] = _random.between(-1, 1);
                numbers[3 * i + 2] = height + (i > most ? side * _random.between(0.1, 1) : 0);
            }
            return numbers;
        }

        private function needle():Vector.<Number>
        {
            var numbers:Vector.<Number> = triangle(1);
            var share:Number = _random.pick([0, 1, _random.next(), _random.between(-1, 2)]);
            var width:Number = _random.pick([0, 1e-15, 1e-12, 1e-9, 1e-8, 1e-7, 1e-5]);
            var corner:int = 3 * _random.integer(0, 2);
            var p:int = (corner + 3) % 9;
            var q:int = (corner + 6) % 9;
            for (var k:int = 0; k < 3; k++)
            {
                numbers[corner + k] = numbers[p + k] + share * (numbers[q + k] - numbers[p + k]) + width * _random.normal();
            }
            return numbers;
        }

        private static function extent(t:Vector.<Number>):Number
        {
            var most:Number = 0;
            for (var i:int = 0; i < 9; i++)
            {
                most = Math.max(most, Math.abs(t[i]));
            }
            return most;
        }

        private static function offTriangle(p:Array, t:Vector.<Number>):Number
        {
            return PlainDistance.between(p.concat(p, p), listed(t));
        }

        private static function listed(t:Vector.<Number>):Array
        {
            var list:Array = [];
            for (var i:int = 0; i < 9; i++)
            {
                list.push(t[i]);
            }
            return list;
        }
    }
}
