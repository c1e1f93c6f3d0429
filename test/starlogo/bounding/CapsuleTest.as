package starlogo.bounding
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;

    public class CapsuleTest
    {
        [Test]
        public function volume():void
        {
            var capsule:Capsule = new Capsule(new Vector3D(1, 1, 0), new Vector3D(1, 1, 1.25), 0.5);
            assertTrue(Math.abs(capsule.volume - (1.25 * Math.PI * 0.25 + 4 / 3 * Math.PI * 0.125)) < 1e-12);
            assertEquals(0, new Capsule(new Vector3D(), new Vector3D(1, 0, 0), 0).volume);
        }

        [Test]
        public function scalesAboutTheOrigin():void
        {
            var capsule:Capsule = new Capsule(new Vector3D(1, 2, 3), new Vector3D(4, 5, 6), 2);
            capsule.scale(2);
            assertTrue(capsule.start.equals(new Vector3D(2, 4, 6)));
            assertTrue(capsule.end.equals(new Vector3D(8, 10, 12)));
            assertEquals(4, capsule.radius);
        }

        [Test]
        public function containsItsCapsAndNotTheCornersBeside():void
        {
            var capsule:Capsule = new Capsule(new Vector3D(0, 0, 0), new Vector3D(0, 0, 2), 1);
            assertTrue(capsule.contains(new Vector3D(0, 0, 3)));
            assertTrue(capsule.contains(new Vector3D(0, 0, -1)));
            assertTrue(capsule.contains(new Vector3D(1, 0, 1)));
            assertTrue(capsule.contains(new Vector3D(0.6, 0, 2.8)));
            assertFalse(capsule.contains(new Vector3D(0.61, 0, 2.81)));
            assertFalse(capsule.contains(new Vector3D(0, 0, 3.0001)));
        }

        [Test]
        public function withoutLengthItIsASphere():void
        {
            var capsule:Capsule = new Capsule(new Vector3D(1, 1, 1), new Vector3D(1, 1, 1), 0.5);
            assertTrue(capsule.contains(new Vector3D(1, 1.5, 1)));
            assertFalse(capsule.contains(new Vector3D(1, 1.51, 1)));
            assertEquals(new Sphere(new Vector3D(), 0.5).volume.toFixed(12), capsule.volume.toFixed(12));
        }

        [Test]
        public function refusesWhatIsNoCapsule():void
        {
            for each (var radius:Number in [-1, NaN, Infinity])
            {
                try
                {
                    new Capsule(new Vector3D(), new Vector3D(1, 0, 0), radius);
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
            new Capsule(null, new Vector3D(), 1);
        }

        [Test(expects="ArgumentError")]
        public function refusesNoEnd():void
        {
            new Capsule(new Vector3D(), null, 1);
        }

        [Test(expects="RangeError")]
        public function refusesAnEndThatIsNotANumber():void
        {
            new Capsule(new Vector3D(), new Vector3D(0, 0, NaN), 1);
        }
    }
}
