package docs
{
    import flash.geom.Vector3D;
    import game.HoopCollider;
    import game.Ring;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collision;
    import starlogo.intersection.intersects;
    import support.assertThrows;

    /** For docs/adding-a-structure.md: what the hoop meets, and that the engine's tests refuse it. */
    public class AddingAStructurePage extends Page
    {
        public static const FIXTURES:Array = [];

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            var hoops:HoopCollider = shown["hoops"];
            var hoop:Agent = shown["hoop"];
            assertTrue("at the rim", hoops.areColliding(ball, hoop));
            ball.moveTo(0, 0, 1.9);
            assertFalse("in the middle", hoops.areColliding(hoop, ball));
            ball.moveTo(1.7, 1, 1.9);
            assertFalse("beside the rim: the hoop is turned", hoops.areColliding(ball, hoop));

            var collisions:Collision = new Collision(hoops);
            collisions.onCollision("paintballs", "hoops", function(ball:Agent, other:Agent):void
                {
                    other.color = 7;
                });
            ball.moveTo(1.7, 0, 1.9);
            collisions.update(agents);
            assertEquals(7, hoop.color);

            var ring:Ring = new Ring(new Vector3D(), Vector3D.Z_AXIS, 2, 0.5);
            assertTrue(ring.contains(new Vector3D(0, 2.5, 0)) && !ring.contains(new Vector3D(0, 1.4, 0)));
            var box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 1, 1);
            for each (var other:Object in [ring, new Sphere(new Vector3D(), 1), box])
            {
                assertThrows(ArgumentError, /no intersection test/, intersects, ring, other);
                assertThrows(ArgumentError, /no intersection test/, intersects, other, ring);
            }
        }
    }
}
