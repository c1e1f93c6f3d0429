package starlogo.search
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.landOf;

    use namespace engine;

    /** A pair with the ground or the edges of the world has tests, and the same answer in either order. */
    public class NarrowPhaseTest
    {
        private var _tests:NarrowPhase = new NarrowPhase(new TightestFitChoice(landOf(BuiltInModel.cube())));
        private var _body:Body = new StructureBody().setTo(new Sphere(new Vector3D(), 1));

        [Test]
        public function theGroundMayComeFirst():void
        {
            checkOrder(new Terrain(3, 3).environmentAgent);
        }

        [Test]
        public function theEdgesMayComeFirst():void
        {
            checkOrder(new WorldBounds(-5, -5, -5, 5, 5, 5).environmentAgent);
        }

        private function checkOrder(agent:EnvironmentAgent):void
        {
            var environment:Body = new Body();
            environment.setToAgent(agent, agent.surface);
            assertTrue(_tests.pairTestsFor(_body, environment) != null);
            assertTrue("in either order", _tests.areTouching(environment, _body) == _tests.areTouching(_body, environment));
        }
    }
}
