package docs
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import game.Tetrahedron;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.collision.TightestFitCollider;
    import starlogo.intersection.intersects;
    import starlogo.queries.AgentQueries;
    import support.assertThrows;

    /** For docs/adding-a-structure.md: the tetrahedron is as the hull of its points. */
    public class AddingAStructurePage extends Page
    {
        public static const FIXTURES:Array = [];

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            var tent:Tetrahedron = shown["tent"];
            checkAgents(shown["camp"]);
            var random:SeededRandom = new SeededRandom(7419);
            var hull:Hull = new Hull(new <Number>[1, -1, 0, -1, -1, 0, 0, 1, 0, 0, 0, 2]);
            assertTrue(Math.abs(tent.volume - hull.volume) < 1e-12);
            var turn:Matrix3D = new Matrix3D();
            var inside:int = 0;
            for (var i:int = 0; i < 2000; i++)
            {
                if (i % 100 == 0)
                {
                    turn.appendRotation(i, Vector3D.X_AXIS);
                    turn.appendRotation(i / 3, Vector3D.Z_AXIS);
                    tent.rotate(turn);
                    hull.rotate(turn);
                }
                var point:Vector3D = new Vector3D(random.between(-2, 2), random.between(-2, 2), random.between(-2, 2));
                assertEquals(hull.contains(point), tent.contains(point));
                assertEquals(intersects(hull, new Sphere(point, 0.3)), intersects(tent, new Sphere(point, 0.3)));
                inside += hull.contains(point) ? 1 : 0;
            }
            assertTrue(inside + "", inside > 20 && inside < 200);
            tent.points[4] = NaN;
            assertThrows(RangeError, "the extent of a tetrahedron", tent.clone);
        }

        private function checkAgents(camp:Agent):void
        {
            var collider:TightestFitCollider = new TightestFitCollider(greatLand);
            assertTrue(collider.areColliding(ball, camp));
            camp.size = 2;
            camp.heading = 90;
            camp.moveTo(10, 10, 0);
            // The vertical side of the floor was at y = -1. A turn by 90 degrees takes it to x = 1, and the size doubles that.
            ball.moveTo(12.05, 10, -0.1);
            assertTrue(collider.areColliding(ball, camp));
            assertTrue(collider.contactOf(ball, camp).depth > 0.04);
            ball.moveTo(12.15, 10, -0.1);
            assertFalse(collider.areColliding(ball, camp));
            assertTrue(new AgentQueries(collider).distance(ball, camp) > 0.04);
        }
    }
}
