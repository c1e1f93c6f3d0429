package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Capsule;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ObjModel;
    import support.Fixtures;
    import support.FurtherCapsule;
    import support.SameAnswers;

    use namespace engine;

    /** A further convex structure takes part in everything with no more than its class: a capsule that the engine does not know as one. */
    public class FurtherStructureTest
    {
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        private static var sLand:GreatLand;

        private var _same:SameAnswers = new SameAnswers(sLand, "cylinder", Agent.CAPSULE, 7141);

        [BeforeClass]
        public static function load():void
        {
            sLand = new GreatLand();
            sLand.loadHulls = sLand.loadAllBoundingStructures = true;
            sLand.addModel(BuiltInModel.sphere());
            sLand.addModel(BuiltInModel.cylinder());
            sLand.addModel(new ObjModel("bear", Fixtures.text(FIXTURES[0])));
            var capsule:Capsule = sLand.boundingStructures.capsule("cylinder");
            sLand.models.entryOf("cylinder").structures.hullOrSphere = new FurtherCapsule(capsule);
        }

        [Test]
        public function framesFindTheSamePairs():void
        {
            _same.framesFindTheSamePairs();
        }

        [Test]
        public function contactsAreAsDeep():void
        {
            _same.contactsAreAsDeep();
        }

        [Test]
        public function sweepsTouchAtTheSameTime():void
        {
            _same.sweepsTouchAtTheSameTime();
        }

        [Test]
        public function questionsHaveTheSameAnswers():void
        {
            _same.questionsHaveTheSameAnswers();
        }

        [Test]
        public function motionsEndInTheSamePlace():void
        {
            _same.motionsEndInTheSamePlace();
        }

        [Test]
        public function theGroundAndTheEdgesAreMet():void
        {
            _same.theGroundAndTheEdgesAreMet();
        }

        [Test]
        public function walksGoTheSameWay():void
        {
            _same.walksGoTheSameWay();
        }
    }
}
