package starlogo.bounding
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;

    public class CylinderTest
    {
        [Test]
        public function volume():void
        {
            var cylinder:Cylinder = new Cylinder(new Vector3D(1, 1, 0), new Vector3D(1, 1, 1.25), 0.5);
            assertTrue(Math.abs(cylinder.volume - (1.25 * Math.PI * 0.25)) < 1e-12);
            assertEquals(0, new Cylinder(new Vector3D(), new Vector3D(1, 0, 0), 0).volume);
        }

        [Test]
        public function scalesAboutTheOrigin():void
        {
            var cylinder:Cylinder = new Cylinder(new Vector3D(1, 2, 3), new Vector3D(4, 5, 6), 2);
            cylinder.scale(2);
            assertTrue(cylinder.start.equals(new Vector3D(2, 4, 6)));
            assertTrue(cylinder.end.equals(new Vector3D(8, 10, 12)));
            assertEquals(4, cylinder.radius);
        }

        [Test]
        public function containsItsRimsAndNothingBeyondItsEnds():void
        {
            var cylinder:Cylinder = new Cylinder(new Vector3D(0, 0, 0), new Vector3D(0, 0, 2), 1);
            assertTrue(cylinder.contains(new Vector3D(1, 0, 0)));
            assertTrue(cylinder.contains(new Vector3D(0.6, -0.8, 2)));
            assertFalse(cylinder.contains(new Vector3D(0, 0, 2.0001)));
            assertFalse(cylinder.contains(new Vector3D(0, 0, -0.0001)));
            assertFalse(cylinder.contains(new Vector3D(0, 1.0001, 1)));
        }

        [Test]
        public function withoutLengthItIsAPoint():void
        {
            var cylinder:Cylinder = new Cylinder(new Vector3D(1, 1, 1), new Vector3D(1, 1, 1), 0.5);
            assertEquals(0, cylinder.volume);
            assertTrue(cylinder.contains(new Vector3D(1, 1, 1)));
            assertFalse(cylinder.contains(new Vector3D(1, 1.1, 1)));
        }

        [Test]
        public function refusesWhatIsNoCylinder():void
        {
            for each (var radius:Number in [-1, NaN, Infinity])
            {
                try
                {
                    new Cylinder(new Vector3D(), new Vector3D(1, 0, 0), radius);
                }
                catch (error:RangeError)
                {
                    assertTrue(error.message, error.message.indexOf(String(radius)) >= 0);
                    continue;
                }
                fail("no error for the radius " + radius);
            }
        }

        [Test(expects="ArgumentError")]
        public function refusesNoStart():void
        {
            new Cylinder(null, new Vector3D(), 1);
        }

        [Test(expects="ArgumentError")]
        public function refusesNoEnd():void
        {
            new Cylinder(new Vector3D(), null, 1);
        }

        [Test(expects="RangeError")]
        public function refusesAnEndThatIsNotANumber():void
        {
            new Cylinder(new Vector3D(), new Vector3D(0, 0, NaN), 1);
        }
    }
}
