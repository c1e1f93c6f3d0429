package starlogo.debug
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.collision.BinCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.EachCollider;
    import support.agentAt;
    import support.assertThrows;

    public class CollisionLinesTest
    {
        [Test]
        public function anAgentThatCollidesWithNothingHasNone():void
        {
            var land:GreatLand = new GreatLand();
            var lines:CollisionLines = new CollisionLines(land);
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                land.expect("late");
                assertEquals(name + ", loading", 0, lines.linesOf(agentAt("late", 1, 2, 3), EachCollider.make(name, land)).length);
                var cube:Model = BuiltInModel.cube();
                land.addModel(new Model("late", cube.vertices, cube.triangles));
                land.expectNoMore("late");
                assertTrue(name + ", loaded", lines.linesOf(agentAt("late", 1, 2, 3), EachCollider.make(name, land)).length > 0);
                land.removeModel("late");
                assertEquals(name + ", removed", 0, lines.linesOf(agentAt("late", 1, 2, 3), EachCollider.make(name, land)).length);
            }
        }

        [Test]
        public function anAgentIsNeeded():void
        {
            assertThrows(ArgumentError, /agent must (not be|be an Agent, not) null$/, new CollisionLines(new GreatLand()).linesOf, null, new BinCollider());
        }

        [Test]
        public function aColliderWithoutModelsShowsSpheresOfAnyShape():void
        {
            assertTrue(new CollisionLines(new GreatLand()).linesOf(agentAt("no model", 0, 0, 0), new BinCollider()).length > 0);
        }
    }
}
