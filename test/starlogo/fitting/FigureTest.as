package starlogo.fitting
{
    import org.flexunit.asserts.assertTrue;
    import support.PointSets;

    /** Rows of the thesis's Figure 6-1, to the three decimals printed there. */
    public class FigureTest
    {
        // printed as 1.131; the printed sphere's 1.803 and box's 1.131 together leave 1.13136 to 1.1315
        private static const CYLINDER_HEIGHT:Number = 1.1314;

        [Test]
        public function cube():void
        {
            var cube:Vector.<Number> = PointSets.placed(PointSets.box(0.5, 0.5, 0.5), 1, 0, 0, 0.5);
            assertVolume("naive sphere", 2.721, new NaiveSphereFitter(), cube);
            assertVolume("axis-aligned box", 1, new AxisAlignedBoxFitter(), cube);
            assertVolume("z-aligned box", 1, new ZAlignedBoxFitter(10), cube);
            assertVolume("oriented box", 1, new OrientedBoxFitter(10), cube);
            assertVolume("oriented capsule", 3.052, new CapsuleFitter(new OrientedBoxFitter(10)), cube);
        }

        [Test]
        public function cylinder():void
        {
            var cylinder:Vector.<Number> = PointSets.cylinder(0.5, CYLINDER_HEIGHT, 64, 2);
            assertVolume("naive sphere", 1.803, new NaiveSphereFitter(), cylinder);
            assertVolume("axis-aligned box", 1.131, new AxisAlignedBoxFitter(), cylinder);
            assertVolume("oriented capsule", 1.412, new CapsuleFitter(new AxisAlignedBoxFitter()), cylinder);
            assertVolume("oriented capsule", 1.412, new CapsuleFitter(new OrientedBoxFitter(10)), cylinder);
            assertVolume("cylinder", Math.PI / 4 * CYLINDER_HEIGHT, new CylinderFitter(new OrientedBoxFitter(10)), cylinder);
        }

        private static function assertVolume(name:String, expected:Number, fitter:Fitter, vertices:Vector.<Number>):void
        {
            var volume:Number = fitter.fit(vertices).volume;
            assertTrue(name + ": " + volume + " instead of " + expected, Math.abs(volume - expected) <= 0.0005000001);
        }
    }
}
