package starlogo.queries
{
    import flash.geom.Vector3D;
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
            var asked:MotionQueries = new MotionQueries(seen);
            var agent:Agent = agentAt("cube", 0, 0, 1.5);
            seen.update(new <Agent>[agent, agentAt("cube", 0.2, 0, 0)]);
            var way:Way = new Way();
            var motion:Motion = new Motion();
            asked.moves.findWay(agent, asked.room.bodyOfMover(agent), 0, 0, -1, null, way);
            asked.moves.mover.begin(way.body, way.rows);
            asked.moves.mover.slide(way.from, way.motion, SlideLimits.NONE, motion);
            assertTrue("it met the cube below: " + motion.floor.normalZ, Math.abs(motion.floor.normalZ - 1) < 1e-9);
            asked.moves.mover.slide(way.from, new Vector3D(), SlideLimits.NONE, motion);
            assertEquals(-2, motion.floor.normalZ);
            assertEquals(false, motion.metWall);
        }
    }
}
