package starlogo.search
{
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.assertThrows;
    import support.landOf;

    use namespace engine;

    /** The ground and the edges of the world are the second body of a pair. */
    public class NarrowPhaseTest
    {
        private var _tests:NarrowPhase = new NarrowPhase(new TightestFitChoice(landOf(BuiltInModel.cube())));
        private var _body:Body = new StructureBody().setTo(new Sphere(new Vector3D(), 1));

        [Test]
        public function theGroundIsNoFirstBody():void
        {
            checkOrder(new Terrain(3, 3).worldAgent);
        }

        [Test]
        public function theEdgesAreNoFirstBody():void
        {
            checkOrder(new WorldBounds(-5, -5, -5, 5, 5, 5).worldAgent);
        }

        private function checkOrder(agent:WorldAgent):void
        {
            var world:Body = new Body();
            world.setToAgent(agent, agent.surface);
            assertThrows(IllegalOperationError, /second body/, _tests.pairTestsFor, world, _body);
            assertTrue(_tests.pairTestsFor(_body, world) != null);
            assertTrue("in either order", _tests.areTouching(world, _body) == _tests.areTouching(_body, world));
        }
    }
}
