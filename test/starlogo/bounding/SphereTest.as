package starlogo.bounding
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;

    public class SphereTest
    {
        [Test]
        public function volumeIsThatOfABall():void
        {
            assertEquals("0.524", new Sphere(new Vector3D(5, 5, 5), 0.5).volume.toFixed(3));
            assertEquals(0, new Sphere(new Vector3D(), 0).volume);
        }

        [Test]
        public function scalesAboutTheOrigin():void
        {
            var sphere:Sphere = new Sphere(new Vector3D(1, 2, 3), 2);
            sphere.scale(3);
            assertTrue(sphere.center.equals(new Vector3D(3, 6, 9)));
            assertEquals(6, sphere.radius);
        }

        [Test]
        public function containsEndsAtTheRadius():void
        {
            var sphere:Sphere = new Sphere(new Vector3D(1, 0, 0), 2);
            assertTrue(sphere.contains(new Vector3D(3, 0, 0)));
            assertTrue(sphere.contains(new Vector3D(3 + 1e-6, 0, 0)));
            assertFalse(sphere.contains(new Vector3D(3 + 1e-5, 0, 0)));
        }

        [Test]
        public function aPointContainsItself():void
        {
            var point:Sphere = new Sphere(new Vector3D(1, 2, 3), 0);
            assertTrue(point.contains(new Vector3D(1, 2, 3)));
            assertFalse(point.contains(new Vector3D(1, 2, 3 + 1e-9)));
        }

        [Test]
        public function refusesWhatIsNoSphere():void
        {
            for each (var radius:Number in [-1, NaN, Infinity])
            {
                try
                {
                    new Sphere(new Vector3D(), radius);
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
        public function refusesNoCenter():void
        {
            new Sphere(null, 1);
        }

        [Test(expects="RangeError")]
        public function refusesACenterThatIsNotANumber():void
        {
            new Sphere(new Vector3D(0, NaN, 0), 1);
        }
    }
}
