package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import support.EachCollider;
    import support.agentAt;
    import support.landOf;

    /** Answers at borders: the first of several overlaps, the ground's largest cells. */
    public class BordersTest
    {
        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube());

        // What the motion enters at its beginning is met at time 0. If there are several, the first in the list is named.
        [Test]
        public function castsNameTheFirstOfSeveralOverlaps():void
        {
            var random:SeededRandom = new SeededRandom(733);
            var several:int = 0;
            for each (var name:String in ["bins", "tightest fits"])
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, _greatLand));
                for (var i:int = 0; i < 1000; i++)
                {
                    var agents:Vector.<Agent> = new Vector.<Agent>();
                    for (var k:int = 0; k < 4; k++)
                    {
                        agents.push(agentAt("sphere", random.between(-1, 1), random.between(-1, 1), random.between(-1.5, 0.5)));
                    }
                    queries.update(agents);
                    var way:Vector3D = new Vector3D(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
                    // a sphere goes into another if their middles come nearer
                    var first:Agent = null;
                    var met:int = 0;
                    for each (var agent:Agent in agents)
                    {
                        var to:Vector3D = new Vector3D(agent.x, agent.y, agent.z + 0.5);
                        if (to.length < 0.9 && to.dotProduct(way) > 1e-3)
                        {
                            first ||= agent;
                            met++;
                        }
                        else if (to.length < 1.01)
                        {
                            met = -99;
                        }
                    }
                    if (met > 0)
                    {
                        several += met > 1 ? 1 : 0;
                        var hit:ShapeHit = queries.castShape(new Sphere(new Vector3D(), 0.5), way.x, way.y, way.z);
                        assertTrue(name + " " + i, hit != null && hit.time == 0);
                        assertEquals(name + " " + i, agents.indexOf(first), agents.indexOf(hit.agent));
                    }
                }
            }
            assertTrue(String(several), several > 20);
        }

        // How deep is shallow depends on the agent, not on the width of the ground's cells.
        [Test]
        public function aBallDeepInAWideCellStaysDeep():void
        {
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                for each (var width:Number in [1, 1e3, 1e6])
                {
                    var ball:Agent = agentAt("sphere", 0.3 * width, 0.2 * width, -0.3);
                    var queries:AgentQueries = new AgentQueries(EachCollider.make(name, _greatLand));
                    queries.terrain = new Terrain(2, 2, width);
                    queries.update(new <Agent>[ball]);
                    queries.slide(ball, 0.1, 0, 0);
                    assertTrue([name, width, ball.z].join(), Math.abs(ball.z + 0.3) < 1e-6);
                    ball.moveTo(0.3 * width, 0.2 * width, 1);
                    queries.moved(ball);
                    queries.slide(ball, 0.1, 0, -2);
                    assertTrue([name, width, ball.z].join(), ball.z >= 0 && ball.z < 1e-6);
                    for (var i:int = 0; i < 20; i++)
                    {
                        assertTrue([name, width, i].join(), queries.walk(ball, 0.01, 0.005).part > 1 - 1e-9);
                    }
                    assertTrue([name, width, ball.z].join(), ball.z >= 0 && ball.z < 1e-6 && !queries.touchesAny(ball));
                }
            }
        }
    }
}
