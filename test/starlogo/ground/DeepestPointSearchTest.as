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
        private var _ground:GroundSearch = new GroundSearch();
        private var _planes:GroundPlanes = new GroundPlanes();
        private var _out:GroundPlane = _planes.planes[0];

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
                assertEquals(i + ": found", 1, find());
                assertClose(depth, _out.depth, 1e-8, i + ": depth");
                assertNormal(i + ": normal", normal.x, normal.y, normal.z);
                assertTrue(i + ": of the model", _out.isPointOfModel);
                assertExit(i + ": exit");
                assertEquals(i + ": under", depth > 0 && isLowestUnderMiddle(), isPointUnder());
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
            assertEquals("found", 1, find());
            assertNormal("normal", -0.5 / length, 0, 1 / length);
            assertClose(depth, _out.depth, 1e-8, "depth");
            assertExit("exit");
            assertTrue("under", isPointUnder());
            // its place is on the same side
            place(below, 5.5, 0, -0.25);
            assertEquals("found in the east", 1, find());
            assertNormal("normal in the east", 0.5 / length, 0, 1 / length);
            assertClose(depth, _out.depth, 1e-8, "depth in the east");
            assertTrue("under in the east", isPointUnder());
        }

        // What is deepest behind the plane of each side leaves the ground at the other side, again and again: the ridge is across the box.
        [Test]
        public function acrossARidgeTheExitIsOfBothEdges():void
        {
            makeGround(ridge);
            place(box(2, 2, 0.1), 0.25, 0, -0.1);
            assertEquals("found", 1, find());
            assertNormal("normal", 0, 0, 1);
            assertClose(0.2, _out.depth, 1e-8, "depth");
            assertExit("exit");
            assertTrue("of the model", _out.isPointOfModel);
            assertFalse("no corner is under", isPointUnder());
            // a box that is tilted less than the sides lies across it too
            var angle:Number = 10 * Math.PI / 180;
            place(new Box(new Vector3D(), new Vector3D(Math.cos(angle), 0, Math.sin(angle)), Vector3D.Y_AXIS, new Vector3D(-Math.sin(angle), 0, Math.cos(angle)), 2, 2,
                        0.1), 0, 0, 0.05);
            assertEquals("found tilted", 1, find());
            assertNormal("normal of the box", -Math.sin(angle), 0, Math.cos(angle));
            assertExit("exit tilted");
        }

        // Above the bottom of a valley each side leads to the other one.
        [Test]
        public function inAValleyBothSidesCount():void
        {
            makeGround(function(x:Number, y:Number):Number
                {
                    return Math.abs(x);
                });
            place(new Sphere(new Vector3D(), RADIUS), 0.02, 0, -0.5);
            assertEquals("found", 2, find());
            assertClose(0, _planes.planes[0].normal.x + _planes.planes[1].normal.x, 1e-9, "normals");
            assertTrue("under", isPointUnder());
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
            assertEquals("found", 1, find());
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
            assertEquals("found without a hole", 1, find());
            assertTrue("under without a hole", isPointUnder());
            // under the point
            setHole(1.65, 0.25);
            assertEquals("found", 0, find());
            assertFalse("under", isPointUnder());
            // under the place of the model
            place(point, 1.6, 0.25, 0);
            assertEquals("found from a hole", 0, find());
            assertTrue("under beside a hole", isPointUnder());
            // outside
            place(point, 100, 0, 0);
            assertEquals("found outside", 0, find());
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
            assertEquals("found", 1, find());
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

        private static function box(halfX:Number, halfY:Number, halfZ:Number):Box
        {
            return new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, halfX, halfY, halfZ);
        }

        private function find():int
        {
            setSearch();
            _model.findWholeBox();
            // begins at the model's place
            _model.box.x = _model.box.y = 0;
            _planes.clear();
            if (_search.beginUnder(_model, _ground, _planes.next))
            {
                _search.addExit(_model, _ground, _planes);
            }
            return _planes.count;
        }

        private function isPointUnder():Boolean
        {
            setSearch();
            return _search.isPointUnder(_model, _ground);
        }

        // On steep slopes the quick test leaves out models whose lowest height is not in the ground under their middle.
        private function isLowestUnderMiddle():Boolean
        {
            var box:GroundBox = _model.box;
            _model.findWholeBox();
            return _grid.heightAt(box.x + _origin.x, box.y + _origin.y) >= box.z - box.halfZ + _origin.z;
        }

        private function setSearch():void
        {
            _ground.grid = _grid;
            _ground.origin.copyFrom(_origin);
        }

        private function assertNormal(message:String, x:Number, y:Number, z:Number):void
        {
            assertClose(x, _out.normal.x, 1e-9, message + " x");
            assertClose(y, _out.normal.y, 1e-9, message + " y");
            assertClose(z, _out.normal.z, 1e-9, message + " z");
        }

        // The exit ends on the surface.
        private function assertExit(message:String):void
        {
            var normal:Vector3D = _out.normal;
            var x:Number = _out.point.x + _out.depth * normal.x;
            var y:Number = _out.point.y + _out.depth * normal.y;
            assertClose(_grid.heightAt(x + _origin.x, y + _origin.y), _out.point.z + _out.depth * normal.z + _origin.z, 1e-8, message);
        }
    }
}
