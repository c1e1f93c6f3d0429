package evaluation.literal
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.CombinationCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Fixtures;

    public class LiteralCombinationColliderTest
    {
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        // The thesis's tests of capsules with boxes are not exact, and its hierarchies are of vertices: here are boxes of vertices alone.
        [Test]
        public function findsWhatTheEngineFinds():void
        {
            var bear:Model = new ObjModel("bear", Fixtures.text("/assets/bear.obj"));
            var greatLand:GreatLand = new GreatLand();
            greatLand.addModel(new Model("bear", bear.vertices));
            greatLand.addModel(BuiltInModel.sphere());
            var fits:LiteralTightestFitCollider = new LiteralTightestFitCollider(greatLand.boundingStructures);
            var trees:LiteralHierarchicalCollider = new LiteralHierarchicalCollider(greatLand.hierarchies);
            var literal:LiteralCombinationCollider = new LiteralCombinationCollider(fits, trees, greatLand.hierarchies);
            var collider:CombinationCollider = new CombinationCollider(greatLand);
            var random:SeededRandom = new SeededRandom(61);
            var met:Array = [0, 0, 0];
            for (var i:int = 0; i < 240; i++)
            {
                var a:Agent = new Agent(i % 2 == 0 ? "bear" : "sphere");
                var b:Agent = new Agent("bear");
                a.hierarchical = i % 3 == 1;
                b.hierarchical = i % 3 > 0;
                a.heading = random.between(0, 360);
                b.heading = random.between(0, 360);
                b.moveTo(random.between(-1.2, 1.2), random.between(-1.2, 1.2), random.between(-1.5, 1.5));
                var isHit:Boolean = literal.areColliding(a, b);
                assertTrue("pair " + i, isHit == collider.areColliding(a, b));
                met[i % 3] += isHit ? 1 : 0;
            }
            for each (var hits:int in met)
            {
                assertTrue(hits + " of 80", hits > 10 && hits < 70);
            }
        }
    }
}
