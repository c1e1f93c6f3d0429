package starlogo.ground
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.intersection.TriangleKernel;
    import support.Complaints;

    /** Which shapes are behind a triangle, and the contacts that lead out in front of it. */
    public class SurfaceKernelTest
    {
        private var _random:SeededRandom = new SeededRandom(3807);
        private var _structures:RandomStructures = new RandomStructures(_random);
        private var _wrong:Complaints = new Complaints();

        [Test]
        public function nothingIsBehindATriangleWithoutArea():void
        {
            var kernel:TriangleKernel = new TriangleKernel();
            var surface:SurfaceKernel = new SurfaceKernel(kernel);
            var out:ContactPoint = new ContactPoint();
            for (var i:int = 0; i < 300; i++)
            {
                kernel.setStructure(_structures.ofKind(i % 3, _random.logBetween(0.02, 2), 2), new Placement());
                var corners:Vector.<Number> = new Vector.<Number>(9, true);
                var share:Number = i % 5 / 4;
                for (var k:int = 0; k < 3; k++)
                {
                    corners[k] = _random.between(-5, 5);
                    corners[3 + k] = _random.between(-5, 5);
                    corners[6 + k] = corners[k] + share * (corners[3 + k] - corners[k]);
                }
                surface.setTriangle(corners);
                surface.findBehind(new RelativeMotion(0), out);
                _wrong.addIf(out.depth >= 0 || surface.isThroughTriangle(out), "behind", "triangle " + corners);
            }
            _wrong.assertNone();
        }

        /** Only what touches first on its motion may have a normal that points behind the triangle. */
        [Test]
        public function whatIsInTheGroundAtFirstIsLedOutside():void
        {
            var kernel:TriangleKernel = new TriangleKernel();
            var surface:SurfaceKernel = new SurfaceKernel(kernel);
            var corners:Vector.<Number> = new <Number>[-10, -10, 0, 10, -10, 0, 0, 10, 0];
            kernel.setStructure(new Sphere(new Vector3D(0, 0, -0.5), 1), new Placement());
            surface.setTriangle(corners);
            for (var up:int = -1; up <= 1; up++)
            {
                var motion:RelativeMotion = new RelativeMotion(0);
                motion.z = up;
                var out:ContactPoint = new ContactPoint();
                kernel.findContact(corners, 0, motion, out);
                assertEquals(-1, out.normalZ);
                surface.leadOutside(motion, out);
                assertEquals("moves by " + up, "1,1.5", [out.normalZ, out.depth].join());
            }
        }
    }
}
