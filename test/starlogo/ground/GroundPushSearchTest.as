package starlogo.ground
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import support.assertClose;

    /** Pushes out of the ground that planes show: they end where the model just touches it. */
    public class GroundPushSearchTest
    {
        private static const SIDE:int = 21;
        private static const PROBE:Number = 1e-9;
        private static const RADIUS:Number = 0.3;

        private var _random:SeededRandom = new SeededRandom(1811);
        private var _query:GroundModelQuery = new GroundModelQuery();
        private var _search:GroundPushSearch = new GroundPushSearch();
        private var _model:ModelPiece = new ModelPiece();
        private var _ground:GroundSearch = new GroundSearch();
        private var _out:ContactPoint = new ContactPoint();

        [Test]
        public function outOfAValleyThePushIsAlongBothSides():void
        {
            makeGround(function(x:Number, y:Number):Number
                {
                    return 0.3 * Math.abs(x);
                });
            place(new Sphere(new Vector3D(), RADIUS), 0.01, 0.4, 0.2);
            assertTrue("found", find());
            assertTrue("free", _search.isFree);
            // where it touches both sides, its middle is this high
            var high:Number = RADIUS * Math.sqrt(1.09);
            assertClose(Math.sqrt(0.01 * 0.01 + (high - 0.2) * (high - 0.2)), _out.depth, 1e-8, "depth");
            assertClose(-0.01 / _out.depth, _out.normalX, 1e-7, "normal");
            assertTrue("deepest", _out.isDeepestOfA);
        }

        // A terrace beside the sphere is higher than its lowest point, but not under it.
        [Test]
        public function aTerraceBesideASphereIsSeparatedByAPlaneBetweenThem():void
        {
            makeGround(function(x:Number, y:Number):Number
                {
                    return x < 1 ? 0 : 0.05;
                });
            place(new Sphere(new Vector3D(), RADIUS), -0.2, 0.4, 0.2);
            assertTrue("found", find());
            assertTrue("free", _search.isFree);
            assertClose(0.1, _out.depth, 1e-8, "depth");
            assertClose(1, _out.normalZ, 1e-9, "normal");
        }

        [Test]
        public function whatIsNotInTheGroundHasNoPush():void
        {
            makeGround(function(x:Number, y:Number):Number
                {
                    return 0;
                });
            place(new Sphere(new Vector3D(), RADIUS), 0, 0, RADIUS);
            assertFalse("touches", find());
            place(new Sphere(new Vector3D(), RADIUS), 0, 0, 1);
            assertFalse("apart", find());
            place(new Sphere(new Vector3D(), RADIUS), 100, 0, -1);
            assertFalse("outside", find());
        }

        // What planes say is what the test of the pieces says.
        [Test]
        public function pushesOnRandomGroundEndWhereTheTwoTouch():void
        {
            var structures:RandomStructures = new RandomStructures(_random);
            var free:int = 0;
            for (var i:int = 0; i < 400; i++)
            {
                var rise:Number = _random.pick([0.05, 0.3, 1]);
                makeGround(function(x:Number, y:Number):Number
                    {
                        return _random.between(0, rise);
                    });
                var structure:BoundingStructure = structures.ofKind(i % 4, 1, 1);
                place(structure, _random.between(-3, 3), _random.between(-3, 3), _random.between(-0.5, 1));
                var isFound:Boolean = find();
                if (isFound)
                {
                    assertTrue(i + ": touches before the end", touchesAfter(structure, -PROBE));
                }
                if (isFound && _search.isFree)
                {
                    free++;
                    assertTrue(i + ": is free behind the end", !touchesAfter(structure, PROBE));
                }
            }
            assertTrue(free + " are free", free > 60);
        }

        private function makeGround(heightOf:Function):void
        {
            var half:int = (SIDE - 1) / 2;
            var heights:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < SIDE * SIDE; i++)
            {
                heights.push(heightOf(i % SIDE - half, int(i / SIDE) - half));
            }
            _ground.grid = new HeightGrid(SIDE, SIDE, 1, -half, -half);
            _ground.grid.setHeights(0, 0, SIDE, SIDE, heights);
        }

        private function place(structure:BoundingStructure, x:Number, y:Number, z:Number):void
        {
            var at:Placement = new Placement();
            at.x = x;
            at.y = y;
            at.z = z;
            _ground.origin.copyFrom(at);
            _model.setModel(null, structure, at, 1);
        }

        private function find():Boolean
        {
            return _search.find(_model, _ground, PROBE, _out);
        }

        private function touchesAfter(structure:BoundingStructure, farther:Number):Boolean
        {
            var motion:RelativeMotion = new RelativeMotion();
            motion.startX = (_out.depth + farther) * _out.normalX;
            motion.startY = (_out.depth + farther) * _out.normalY;
            motion.startZ = (_out.depth + farther) * _out.normalZ;
            _query.setTo(_ground.grid, null, structure, _ground.origin, 1);
            return _query.areTouchingAt(motion, 0);
        }
    }
}
