package starlogo.intersection.ray
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;

    /** A ray along x, and a shape that it touches at 1. Rounding puts the shape's own surface a little beyond that. */
    public class RayCrossingTest
    {
        private static const SURFACE:Number = 1 + 1e-13;

        private var _ray:Ray = new Ray();
        private var _span:RaySpan = new RaySpan();
        private var _crossing:RayCrossing = new RayCrossing();

        [Before]
        public function aimAtTheShape():void
        {
            _ray.direction.setTo(1, 0, 0);
            _span.setPlaces(1, 3);
            _span.near.surfaceDistance = SURFACE;
            _span.near.normal.setTo(2, 0, 0);
        }

        [Test]
        public function aRayEntersAtTheSurface():void
        {
            _ray.to = SURFACE;
            assertTrue(_crossing.setToEntry(_ray, _span));
            assertEquals(SURFACE, _crossing.distance);
            assertEquals("against the ray", -1, _crossing.normal.x);
        }

        [Test]
        public function aRayThatEndsBeforeTheSurfaceEntersWhereItTouches():void
        {
            _ray.to = 1 + 5e-14;
            assertTrue(_crossing.setToEntry(_ray, _span));
            assertEquals(1, _crossing.distance);
            assertEquals("against the ray", -1, _crossing.normal.x);
        }

        [Test]
        public function aRayThatEndsBeforeTheTouchEntersNothing():void
        {
            _ray.to = 1 - 5e-14;
            assertFalse(_crossing.setToEntry(_ray, _span));
        }

        [Test]
        public function aRayThatBeginsInsideEntersWhereItBegins():void
        {
            _ray.from = 2;
            assertTrue(_crossing.setToEntry(_ray, _span));
            assertEquals(2, _crossing.distance);
            _ray.from = 4;
            assertFalse("beyond the shape", _crossing.setToEntry(_ray, _span));
        }

        [Test]
        public function aRayLeavesWhereItComesOut():void
        {
            _crossing.setToEntry(_ray, _span);
            var exit:RayCrossing = new RayCrossing();
            assertTrue(exit.setToExit(_ray, _span, _crossing));
            assertEquals(3, exit.distance);
            _ray.to = 2;
            assertFalse("it ends inside", exit.setToExit(_ray, _span, _crossing));
        }
    }
}
