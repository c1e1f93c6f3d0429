package starlogo.collision
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.assertThrows;
    import support.assign;

    public class CombinationColliderTest
    {
        private var _greatLand:GreatLand = new GreatLand();
        private var _collider:CombinationCollider = new CombinationCollider(_greatLand);

        [Test]
        public function visitsFiveLevelsAtFirst():void
        {
            assertEquals(5, _collider.maxDepth);
            assertFalse(_collider.exact);
            assertThrows(RangeError, /maxDepth.*-2/, assign, _collider, "maxDepth", -2);
        }

        [Test]
        public function needsOnlyWhatItUses():void
        {
            _greatLand.loadHierarchies = false;
            _greatLand.addModel(named("no hierarchy"));
            _greatLand.loadHierarchies = true;
            _greatLand.loadTightestFit = false;
            _greatLand.addModel(named("no fit"));
            var plain:Agent = new Agent("no hierarchy");
            var precise:Agent = new Agent("no fit");
            precise.hierarchical = true;
            assertTrue(_collider.areColliding(plain, precise));
            precise.hierarchical = false;
            assertThrows(ArgumentError, /"no fit".*loadTightestFit/, _collider.areColliding, plain, precise);
            precise.hierarchical = true;
            plain.hierarchical = true;
            assertThrows(ArgumentError, /"no hierarchy".*loadHierarchies/, _collider.areColliding, plain, precise);
            plain.hierarchical = false;
            assertTrue(_collider.areColliding(plain, precise));
        }

        private static function named(name:String):Model
        {
            var cube:Model = BuiltInModel.cube();
            return new Model(name, cube.vertices, cube.triangles);
        }
    }
}
