package starlogo.geometry
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;

    /** The shortest displacement out of half-spaces, against random ones. */
    public class HalfSpaceSolverTest
    {
        private static const CASES:int = 300;
        private static const TRIALS:int = 100;
        private static const CLOSE:Number = 1e-9;

        private var _solver:HalfSpaceSolver = new HalfSpaceSolver();
        private var _random:SeededRandom = new SeededRandom(72);
        private var _normals:Vector.<Vector3D> = new Vector.<Vector3D>();
        private var _depths:Vector.<Number> = new Vector.<Number>();

        [Before]
        public function begin():void
        {
            _solver.clear();
        }

        [Test]
        public function ofOneItIsTheNormal():void
        {
            _solver.add(0, 0, 1, 2);
            assertTrue(_solver.solve());
            assertEquals(2, _solver.distance);
            assertEquals(2, _solver.displacement.z);
            assertEquals(1, _solver.planeCount);
        }

        [Test]
        public function nothingIsRequiredOfWhatIsOut():void
        {
            _solver.add(0, 0, 1, -2);
            assertTrue(_solver.solve());
            assertEquals(0, _solver.distance);
            assertEquals(0, _solver.planeCount);
        }

        [Test]
        public function floorAndWallsAreLeftAtOnce():void
        {
            _solver.add(0, 0, 1, 2);
            _solver.add(1, 0, 0, 3);
            _solver.add(0, -1, 0, 6);
            assertTrue(_solver.solve());
            assertEquals(7, _solver.distance);
            assertEquals(3, _solver.planeCount);
            assertFalse("with two planes", _solver.solve(2, 0));
        }

        // The shortest one leads along x, to where both walls meet. It may go against the other normal, but farther than that is not shorter.
        [Test]
        public function noPlaneThatMayBeCrossedIsTheOnlyOne():void
        {
            for each (var isLast:Boolean in [false, true])
            {
                _solver.clear();
                if (!isLast)
                {
                    _solver.add(-1, 0, 0, -0.5);
                }
                _solver.add(0.8, 0.6, 0, 0.3);
                _solver.add(0.8, -0.6, 0, 0.3);
                if (isLast)
                {
                    _solver.add(-1, 0, 0, -0.5);
                }
                assertFalse("last: " + isLast, _solver.solve(1));
                assertTrue(_solver.solve(2));
                assertTrue("at " + _solver.distance, Math.abs(_solver.distance - 0.375) < CLOSE);
            }
        }

        [Test]
        public function betweenOppositeWallsThereIsNoExit():void
        {
            _solver.add(1, 0, 0, 1);
            _solver.add(-1, 0, 0, 1);
            assertFalse(_solver.solve());
            assertEquals(Infinity, _solver.distance);
        }

        // A ridge: the floor is bent about y, or about another axis, by very little. In half of the cases a wall stands across it.
        [Test]
        public function shallowRidgesHaveAnExit():void
        {
            var decided:Vector.<int> = new Vector.<int>(4, true);
            for (var exponent:Number = -9; exponent < -1; exponent += 0.05)
            {
                var bend:Number = Math.pow(10, exponent);
                for each (var hasWall:Boolean in [false, true])
                {
                    var name:String = "bent by " + bend + (hasWall ? ", with a wall" : "");
                    var turn:Number = _random.between(0, 2 * Math.PI);
                    _solver.clear();
                    _normals.length = _depths.length = 0;
                    addPlane(bend * Math.cos(turn), bend * Math.sin(turn), 1, 2);
                    addPlane(-bend * Math.cos(turn), -bend * Math.sin(turn), 1, 2 + bend * bend * _random.between(-1, 1));
                    if (hasWall)
                    {
                        addPlane(-Math.sin(turn + 0.3 * bend), Math.cos(turn + 0.3 * bend), 0.1, 1);
                    }
                    assertTrue(name, _solver.solve());
                    assertTrue(name + " leads out", leadsOut(_solver.displacement, 1e-11));
                    assertTrue(name + " is short: " + _solver.distance, _solver.distance < (hasWall ? 2.5 : 2.1));
                    decided[_solver.planeCount]++;
                }
            }
            assertTrue("all kinds: " + decided, decided[1] > 10 && decided[2] > 10 && decided[3] > 10);
        }

        [Test]
        public function nearlyOppositeWallsHaveNoExit():void
        {
            addPlane(1, 0, 1e-5, 1);
            addPlane(-1, 0, 1e-5, 1);
            assertFalse("it would be 100,000 long", _solver.solve());
        }

        [Test]
        public function noRandomDisplacementIsShorter():void
        {
            var decided:Vector.<int> = new Vector.<int>(4, true);
            for (var i:int = 0; i < CASES; i++)
            {
                addRandom(1 + i % 6);
                if (!_solver.solve())
                {
                    continue;
                }
                decided[_solver.planeCount]++;
                assertTrue("case " + i + " leads out", leadsOut(_solver.displacement, CLOSE * (1 + _solver.distance)));
                for (var j:int = 0; j < TRIALS && _solver.distance > 0; j++)
                {
                    var other:Vector3D = direction();
                    other.scaleBy(_solver.distance * _random.between(0.5, 1) * (1 - CLOSE));
                    assertFalse("case " + i + ": " + other + " is shorter", leadsOut(other, 0));
                }
            }
            assertTrue("all kinds: " + decided, decided[0] > 0 && decided[1] > 10 && decided[2] > 10 && decided[3] > 10);
        }

        private function addRandom(count:int):void
        {
            _solver.clear();
            _normals.length = _depths.length = 0;
            for (var i:int = 0; i < count; i++)
            {
                var normal:Vector3D = direction();
                addPlane(normal.x, normal.y, normal.z, _random.between(-0.5, 2));
            }
        }

        private function addPlane(x:Number, y:Number, z:Number, depth:Number):void
        {
            var normal:Vector3D = new Vector3D(x, y, z);
            normal.normalize();
            _normals.push(normal);
            _depths.push(depth);
            _solver.add(normal.x, normal.y, normal.z, depth);
        }

        private function leadsOut(displacement:Vector3D, slack:Number):Boolean
        {
            for (var i:int = 0; i < _normals.length; i++)
            {
                if (displacement.dotProduct(_normals[i]) < _depths[i] - slack)
                {
                    return false;
                }
            }
            return true;
        }

        private function direction():Vector3D
        {
            var found:Vector3D = new Vector3D(_random.between(-1, 1), _random.between(-1, 1), _random.between(-1, 1));
            found.normalize();
            return found;
        }
    }
}
