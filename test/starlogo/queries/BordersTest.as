package starlogo.queries
{
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import support.EachCollider;
    import support.agentAt;
    import support.landOf;

    /** Answers at borders: the ground's largest cells. */
    public class BordersTest
    {
        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube());

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
