package starlogo.away3d
{
    import away3d.entities.Mesh;
    import away3d.primitives.CubeGeometry;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import support.MemoryGrowth;
    import support.landOf;

    /**
     * Bindings and wireframes allocate nothing, measured as collision's AllocationTest does.
     */
    public class Away3dAllocationTest
    {
        private static const UPDATES:int = 100000;
        private static const WARM_UP:int = 10;
        private static const SMALLEST_OBJECT:int = 20;

        private var _agent:Agent;
        private var _mesh:Mesh;
        private var _binding:Away3dAgentBinding;

        [Before]
        public function bind():void
        {
            _agent = new Agent("cube");
            _mesh = new Mesh(new CubeGeometry(1, 2, 3));
            _mesh.pivotPoint = new Vector3D(1, 2, 3);
            _binding = new Away3dAgentBinding(_agent, _mesh, new Away3dModel("cube", _mesh));
        }

        [Test]
        public function theMeasureSeesOneSmallObject():void
        {
            var grown:Number = MemoryGrowth.during(UPDATES, WARM_UP, function(i:int):void
                {
                    MemoryGrowth.makeObjects(1);
                });
            assertTrue("one object an update: " + grown + " bytes", grown > UPDATES * SMALLEST_OBJECT);
        }

        [Test]
        public function agentsLeadForNothing():void
        {
            assertAllocatesNothing(function(i:int):void
                {
                    _agent.moveTo(i * 1e-3, 1, 2);
                    _agent.heading = i % 360;
                    _agent.pitch = 33.5;
                    _binding.updateObject();
                });
        }

        [Test]
        public function objectsLeadForNothing():void
        {
            assertAllocatesNothing(function(i:int):void
                {
                    _mesh.moveTo(i * 1e-3, 1, 2);
                    _mesh.rotateTo(20, i % 360, 30);
                    _binding.updateAgent();
                });
        }

        [Test]
        public function nothingChangesForNothing():void
        {
            _binding.updateObject();
            assertAllocatesNothing(function(i:int):void
                {
                    _binding.updateObject();
                    _binding.updateAgent();
                });
        }

        [Test]
        public function wireframesMoveForNothing():void
        {
            var greatLand:GreatLand = landOf(BuiltInModel.cube());
            var wireframe:Away3dWireframe = new Away3dWireframe(_agent);
            wireframe.showLevel(greatLand.hierarchies.root("cube"), 3);
            assertAllocatesNothing(function(i:int):void
                {
                    _agent.heading = i % 360;
                    _agent.roll = 12.5;
                    wireframe.update();
                });
        }

        private function assertAllocatesNothing(update:Function):void
        {
            var grown:Number = MemoryGrowth.during(UPDATES, WARM_UP, update);
            assertTrue(grown + " bytes in " + UPDATES + " updates", grown < UPDATES * SMALLEST_OBJECT / 2);
        }
    }
}
