package docs
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import game.Cushion;
    import game.HoopCollider;
    import game.Ring;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collision;
    import starlogo.collision.TightestFitCollider;
    import starlogo.intersection.intersects;
    import starlogo.queries.AgentQueries;
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
            assertTrue("the cushion's end", new TightestFitCollider(greatLand).areColliding(ball, shown["pillow"]));
            ball.moveTo(1.7, 0, 1.9);
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

            checkCushion(shown["cushion"], shown["pillow"]);
            var ring:Ring = new Ring(new Vector3D(), Vector3D.Z_AXIS, 2, 0.5);
            assertTrue(ring.contains(new Vector3D(0, 2.5, 0)) && !ring.contains(new Vector3D(0, 1.4, 0)));
            var box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 1, 1);
            for each (var other:Object in [ring, new Sphere(new Vector3D(), 1), box])
            {
                assertThrows(ArgumentError, /no intersection test/, intersects, ring, other);
                assertThrows(ArgumentError, /no intersection test/, intersects, other, ring);
            }
        }

        // The cushion's centre is at (0, 0, 0.3), its rectangle is 2 by 1, its radius is 0.3.
        private function checkCushion(cushion:Cushion, pillow:Agent):void
        {
            var random:SeededRandom = new SeededRandom(7419);
            var inside:int = 0;
            for (var i:int = 0; i < 2000; i++)
            {
                var point:Vector3D = new Vector3D(random.between(-1.5, 1.5), random.between(-1, 1), random.between(-0.3, 0.9));
                var x:Number = Math.max(0, Math.abs(point.x) - 1);
                var y:Number = Math.max(0, Math.abs(point.y) - 0.5);
                var distance:Number = Math.sqrt(x * x + y * y + (point.z - 0.3) * (point.z - 0.3));
                assertEquals(distance <= 0.3, cushion.contains(point));
                assertEquals(distance <= 0.5, intersects(cushion, new Sphere(point, 0.2)));
                inside += distance <= 0.3 ? 1 : 0;
            }
            assertTrue("its volume", Math.abs(inside / 2000 * 3 * 2 * 1.2 - cushion.volume) < 0.3);
            var collider:TightestFitCollider = new TightestFitCollider(greatLand);
            pillow.size = 2;
            pillow.heading = 90;
            pillow.moveTo(10, 10, 1);
            ball.moveTo(10, 12.65, 1.5);
            assertTrue("turned, twice as large: its end is at 12.6", collider.areColliding(ball, pillow));
            ball.moveTo(10, 12.75, 1.5);
            assertFalse(collider.areColliding(ball, pillow));
            assertTrue(Math.abs(new AgentQueries(collider).distance(ball, pillow) - 0.05) < 1e-6);
            ball.moveTo(10, 12.65, 1.5);
            assertTrue(Math.abs(collider.contactOf(ball, pillow).depth - 0.05) < 1e-6);
        }
    }
}
