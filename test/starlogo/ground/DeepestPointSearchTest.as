package starlogo.ground
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexShape;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import support.assertClose;

    use namespace engine;

    /** The point of a model that is deepest in the ground, found along the normals of the ground. */
    public class DeepestPointSearchTest
    {
        private static const WIDTH:Number = 0.5;
        private static const SIDE:int = 41;

        // The radius of the spheres that stand for a point.
        private static const RADIUS:Number = 1e-3;

        private var _random:SeededRandom = new SeededRandom(2803);
        private var _search:DeepestPointSearch = new DeepestPointSearch();
        private var _model:ModelPiece = new ModelPiece();
        private var _origin:Placement = new Placement();
        private var _out:ContactPoint = new ContactPoint();

        // The ground, whose heights are a function of how far east and north of the middle they are. The middle is far from the origin.
        private var _grid:HeightGrid;
        private var _middleX:Number = 3000;
        private var _middleY:Number = -2000;
        private var _middleZ:Number = 700;

        // On a plane all of the depth is along its normal, for any structure.
        [Test]
        public function onAPlaneTheDepthIsBehindIt():void
        {
            var structures:RandomStructures = new RandomStructures(_random);
            var shape:ConvexShape = new ConvexShape();
            for (var i:int = 0; i < 200; i++)
            {
                var slopeX:Number = _random.between(-1, 1);
                var slopeY:Number = _random.between(-1, 1);
                makeGround(function(x:Number, y:Number):Number
                    {
                        return slopeX * x + slopeY * y;
                    });
                var structure:BoundingStructure = structures.ofKind(i % 4, 1, 1);
                var high:Number = _random.between(-2, 1);
                place(structure, 0.3, 0.2, slopeX * 0.3 + slopeY * 0.2 + high);
                var length:Number = Math.sqrt(1 + slopeX * slopeX + slopeY * slopeY);
                var normal:Vector3D = new Vector3D(-slopeX / length, -slopeY / length, 1 / length);
                structure.setShape(shape);
                var lowest:int = shape.support(normal, -1);
                var ofShape:Number = normal.x * (shape.origin.x + shape.points[lowest]) + normal.y * (shape.origin.y + shape.points[int(lowest + 1)])
                    + normal.z * (shape.origin.z + shape.points[int(lowest + 2)]) - shape.radius;
                var depth:Number = -ofShape - high * normal.z;
                assertTrue(i + ": found", find());
                assertClose(depth, _out.depth, 1e-8, i + ": depth");
                assertNormal(i + ": normal", normal.x, normal.y, normal.z);
                assertTrue(i + ": deepest", _out.isDeepestOfA);
                assertExit(i + ": exit");
                assertEquals(i + ": under", depth > 0, isPointUnder());
            }
        }

        // The model is beside the ridge that its place is on the other side of: the normal under its place does not lead to the surface.
        [Test]
        public function beyondARidgeTheNormalThereCounts():void
        {
            makeGround(ridge);
            var length:Number = Math.sqrt(1.25);
            var depth:Number = 0.25 / length + RADIUS;
            var below:BoundingStructure = new Sphere(new Vector3D(-3, 0, -1.25), RADIUS);
            place(below, 0.5, 0, -0.25);
            assertTrue("found", find());
            assertNormal("normal", -0.5 / length, 0, 1 / length);
            assertClose(depth, _out.depth, 1e-8, "depth");
            assertExit("exit");
            assertTrue("under", isPointUnder());
            // its place is on the same side
            place(below, 5.5, 0, -0.25);
            assertTrue("found in the east", find());
            assertNormal("normal in the east", 0.5 / length, 0, 1 / length);
            assertClose(depth, _out.depth, 1e-8, "depth in the east");
            assertTrue("under in the east", isPointUnder());
        }

        // What is deepest behind the plane of each side leaves the ground at the other side, again and again.
        [Test]
        public function acrossARidgeNoExitIsOnTheSurface():void
        {
            makeGround(ridge);
            place(new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 2, 2, 0.1), 0.25, 0, -0.1);
            assertFalse("found", find());
            assertFalse("under", isPointUnder());
        }

        // The exit is on the surface, but the point is on the other side of a narrow ridge, in the air.
        [Test]
        public function behindANarrowRidgeThePointIsNotUnder():void
        {
            makeGround(function(x:Number, y:Number):Number
                {
                    return x < 0 ? 5 * x : -x;
                });
            place(new Sphere(new Vector3D(-0.3, 0, -0.2), RADIUS), 0.2, 0, -0.2);
            assertTrue("found", find());
            assertClose(0.25 * Math.SQRT2 + RADIUS, _out.depth, 1e-8, "depth");
            assertExit("exit");
            assertFalse("under", isPointUnder());
        }

        [Test]
        public function inAHoleIsNoExit():void
        {
            makeGround(function(x:Number, y:Number):Number
                {
                    return 0;
                });
            var point:BoundingStructure = new Sphere(new Vector3D(1.25, 0, -0.2), RADIUS);
            place(point, 0.4, 0.25, 0);
            assertTrue("found without a hole", find());
            assertTrue("under without a hole", isPointUnder());
            // under the point
            setHole(1.65, 0.25);
            assertFalse("found", find());
            assertFalse("under", isPointUnder());
            // under the place of the model
            place(point, 1.6, 0.25, 0);
            assertFalse("found from a hole", find());
            assertFalse("under from a hole", isPointUnder());
            // outside
            place(point, 100, 0, 0);
            assertFalse("found outside", find());
            assertFalse("under outside", isPointUnder());
        }

        [Test]
        public function onBlocksTheWayIsUp():void
        {
            makeGround(function(x:Number, y:Number):Number
                {
                    return x > 1 ? 2 : 0;
                });
            _grid.isBlocky = true;
            place(new Sphere(new Vector3D(2, 0, 0.5), RADIUS), 0, 0, 0);
            assertTrue("found", find());
            assertNormal("normal", 0, 0, 1);
            assertClose(1.5 + RADIUS, _out.depth, 1e-8, "depth");
            assertTrue("under", isPointUnder());
        }

        // A ridge from south to north.
        private static function ridge(x:Number, y:Number):Number
        {
            return -Math.abs(x) / 2;
        }

        private function makeGround(heightOf:Function):void
        {
            var half:int = (SIDE - 1) / 2;
            _grid = new HeightGrid(SIDE, SIDE, WIDTH, _middleX - half * WIDTH, _middleY - half * WIDTH);
            var heights:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < SIDE * SIDE; i++)
            {
                heights.push(_middleZ + heightOf((i % SIDE - half) * WIDTH, (int(i / SIDE) - half) * WIDTH));
            }
            _grid.setHeights(0, 0, SIDE, SIDE, heights);
        }

        private function setHole(x:Number, y:Number):void
        {
            _grid.setHole(int((_middleX + x - _grid.x) / WIDTH), int((_middleY + y - _grid.y) / WIDTH), true);
        }

        // Places a structure relative to the middle of the ground.
        private function place(structure:BoundingStructure, x:Number, y:Number, z:Number):void
        {
            _origin.x = _middleX + x;
            _origin.y = _middleY + y;
            _origin.z = _middleZ + z;
            _model.setModel(null, structure, _origin, 1);
        }

        private function find():Boolean
        {
            return _search.find(_model, _grid, _origin, _out);
        }

        private function isPointUnder():Boolean
        {
            return _search.isPointUnder(_model, _grid, _origin);
        }

        private function assertNormal(message:String, x:Number, y:Number, z:Number):void
        {
            assertClose(x, _out.normalX, 1e-9, message + " x");
            assertClose(y, _out.normalY, 1e-9, message + " y");
            assertClose(z, _out.normalZ, 1e-9, message + " z");
        }

        // The contact's point is half of the depth before the exit, which is on the surface.
        private function assertExit(message:String):void
        {
            var way:Number = _out.depth / 2;
            assertClose(_grid.heightAt(_out.x + way * _out.normalX, _out.y + way * _out.normalY), _out.z + way * _out.normalZ, 1e-8, message);
        }
    }
}
