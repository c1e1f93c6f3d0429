package starlogo.ground
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Placement;

    /** What planes alone tell about a touch with the ground. */
    public class GroundTouchSearchTest
    {
        // A valley of slopes, whose bottom is along y through the middle.
        private static const SIDE:int = 21;

        private var _touches:GroundTouchSearch = new GroundTouchSearch();
        private var _grid:HeightGrid;
        private var _model:ModelPiece = new ModelPiece();
        private var _search:GroundSearch = new GroundSearch();

        [Before]
        public function makeValley():void
        {
            var heights:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < SIDE * SIDE; i++)
            {
                heights.push(Math.abs(i % SIDE - 10));
            }
            _grid = new HeightGrid(SIDE, SIDE, 1, -10, -10);
            _grid.setHeights(0, 0, SIDE, SIDE, heights);
        }

        // A sphere at the middle is as far from each side as its middle is high, over the square root of 2.
        [Test]
        public function aSphereBetweenTwoSides():void
        {
            var radius:Number = 1 / Math.SQRT2;
            assertEquals("apart", GroundSeparation.SEPARATED, find(new Sphere(new Vector3D(), radius - 1e-9), 1));
            assertEquals("deep", GroundSeparation.BLOCKED, find(new Sphere(new Vector3D(), radius + 1e-3), 1));
            assertEquals("a touch is not told to be none", true, find(new Sphere(new Vector3D(), radius), 1) != GroundSeparation.SEPARATED);
        }

        // The lowest point along the normal under the middle is in the air, and an end is in a side.
        [Test]
        public function anEndInASide():void
        {
            var across:BoundingStructure = new Capsule(new Vector3D(-2, 0, 0), new Vector3D(2, 0, 0), 0.1);
            assertEquals("ends under", GroundSeparation.BLOCKED, find(across, 1.5));
            assertEquals("ends above", GroundSeparation.SEPARATED, find(across, 2.2));
        }

        // The ground ends at a wall: what is only beside it is apart, but not what comes as near as a touch.
        [Test]
        public function besideTheBorder():void
        {
            var sphere:BoundingStructure = new Sphere(new Vector3D(), 1);
            assertEquals("apart", GroundSeparation.SEPARATED, find(sphere, 2, 11.001));
            assertEquals("a touch", true, find(sphere, 2, 11) != GroundSeparation.SEPARATED);
        }

        [Test]
        public function aLargeModelIsNotLookedAtWhole():void
        {
            assertEquals("under", GroundSeparation.BLOCKED, find(new Sphere(new Vector3D(), 6), 5));
            assertEquals("above", GroundSeparation.UNKNOWN, find(new Sphere(new Vector3D(), 6), 100));
        }

        private function find(structure:BoundingStructure, z:Number, x:Number = 0):int
        {
            var at:Placement = new Placement();
            at.x = x;
            at.z = z;
            _search.grid = _grid;
            _search.origin.copyFrom(at);
            _model.setModel(null, structure, at, 1);
            return _touches.find(_model, _search);
        }
    }
}
