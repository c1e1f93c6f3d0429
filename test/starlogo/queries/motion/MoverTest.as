package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.collision.TightestFitCollider;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.SeenAgents;
    import support.agentAt;
    import support.landOf;

    use namespace engine;

    /** What a motion says about itself, and nothing of an earlier one. */
    public class MoverTest
    {
        [Test]
        public function aSlideWithoutAMotionHasMetNoFloorAndNoWall():void
        {
            var seen:SeenAgents = new SeenAgents(new TightestFitCollider(landOf(BuiltInModel.cube())));
            var planner:MotionPlanner = new MotionPlanner(seen);
            var mover:Mover = new Mover(seen);
            var agent:Agent = agentAt("cube", 0, 0, 1.5);
            seen.update(new <Agent>[agent, agentAt("cube", 0.2, 0, 0)]);
            var planned:PlannedMotion = new PlannedMotion();
            var setup:MotionSetup = new MotionSetup();
            var result:SlideResult = new SlideResult();
            planner.readBody(agent, 0, planned.body);
            planner.planSlide(agent, 0, 0, -1, null, planned);
            mover.setBody(planned.body, planned.rows);
            mover.slide(planned.from, planned.motion, SlideLimits.NONE, setup, result);
            assertTrue("it met the cube below: " + result.floor.normalZ, Math.abs(result.floor.normalZ - 1) < 1e-9);
            mover.slide(planned.from, new Vector3D(), SlideLimits.NONE, setup, result);
            assertEquals(-1, result.floorRow);
            assertEquals(false, result.metWall);
        }
    }
}
