package starlogo.queries
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.collision.TightestFitCollider;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import support.agentAt;
    import support.landOf;

    use namespace engine;

    /** What a motion says about itself, and nothing of an earlier one. */
    public class MoverTest
    {
        [Test]
        public function aSlideWithoutAMotionHasMetNoFloorAndNoWall():void
        {
            var seen:QueryWorld = new QueryWorld(new TightestFitCollider(landOf(BuiltInModel.cube())));
            var moves:MoveQueries = new QuerySet(seen).moves;
            var agent:Agent = agentAt("cube", 0, 0, 1.5);
            seen.update(new <Agent>[agent, agentAt("cube", 0.2, 0, 0)]);
            moves.slide(agent, 0, 0, -1, null);
            assertTrue("it met the cube below: " + moves.mover.floor.normalZ, Math.abs(moves.mover.floor.normalZ - 1) < 1e-9);
            moves.slide(agent, 0, 0, 0, null);
            assertEquals(-2, moves.mover.floor.normalZ);
            assertEquals(false, moves.mover.metWall);
        }
    }
}
