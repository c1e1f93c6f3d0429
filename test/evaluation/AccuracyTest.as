package evaluation
{
    import org.flexunit.asserts.assertEquals;
    import starlogo.agents.Agent;
    import starlogo.collision.TightestFitCollider;
    import starlogo.GreatLand;
    import starlogo.models.BuiltInModel;

    /** What counts as found, right and missed. */
    public class AccuracyTest
    {
        private var _agents:Vector.<Agent> = new Vector.<Agent>();

        [Test]
        public function pairsCountInEitherOrder():void
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.addModel(BuiltInModel.cube());
            for (var i:int = 0; i < 5; i++)
            {
                _agents.push(new Agent("cube"));
                // three in a row touch
                _agents[i].moveTo(i < 3 ? 0.9 * i : 10 * i, 0, 0);
            }
            var truth:Object = Accuracy.truthOf(new TightestFitCollider(greatLand), _agents);
            var accuracy:Accuracy = new Accuracy();
            accuracy.add(new <Agent>[_agents[1], _agents[0], _agents[3], _agents[4], _agents[0], _agents[4], _agents[0], _agents[2]], truth);
            assertEquals(4, accuracy.found);
            assertEquals(1, accuracy.right);
            assertEquals(2, accuracy.touching);
            accuracy.add(new <Agent>[_agents[0], _agents[1], _agents[1], _agents[2]], truth);
            assertEquals(0.5, accuracy.precision);
            assertEquals(0.75, accuracy.recall);
        }
    }
}
