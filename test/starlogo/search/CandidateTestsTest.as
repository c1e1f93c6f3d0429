package starlogo.search
{
    import org.flexunit.asserts.assertEquals;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.models.BuiltInModel;
    import support.EachCollider;
    import support.landOf;

    /** The times at which agents that sweep first touch. */
    public class CandidateTestsTest
    {
        [Test]
        public function whatMovesAlikeTouchesFromTheBeginningOn():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                for each (var motion:Array in [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, -1]])
                {
                    assertEquals(name + ", moved by " + motion, 0, timeOf(name, motion));
                }
                assertEquals(name + ", not moved", 1, timeOf(name, [0, 0, 0]));
            }
        }

        // Two that touch both move by this and sweep.
        private static function timeOf(colliderName:String, motion:Array):Number
        {
            var agents:Vector.<Agent> = new <Agent>[new Agent("cube"), new Agent("cube")];
            agents[1].x = 0.5;
            var collider:Collider = EachCollider.make(colliderName, landOf(BuiltInModel.cube()));
            collider.findCollisions(agents);
            for each (var agent:Agent in agents)
            {
                agent.sweeps = true;
                agent.moveTo(agent.x + motion[0], agent.y + motion[1], agent.z + motion[2]);
            }
            assertEquals(colliderName, 2, collider.findCollisions(agents).length);
            return collider.contactOf(agents[0], agents[1]).time;
        }
    }
}
