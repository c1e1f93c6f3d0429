package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.Model;
    import support.Effort;
    import support.SameAnswers;
    import support.SteppedModels;

    /** Agents that collide as hulls. A cube's hull is the cube, so every question has the answers that it has for the box. */
    public class HullColliderTest
    {
        public static const FIXTURES:Array = SteppedModels.FIXTURES;

        private static var sLand:GreatLand;

        private var _same:SameAnswers = new SameAnswers(sLand, "cube", Agent.BOX, 7131);
        private var _random:SeededRandom = new SeededRandom(7132);

        [BeforeClass]
        public static function load():void
        {
            sLand = new GreatLand();
            sLand.loadHulls = sLand.loadAllBoundingStructures = true;
            for each (var model:Model in SteppedModels.twelve())
            {
                sLand.addModel(model);
            }
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

        // Whoever touches by surfaces is reported by hulls too; and hulls are tighter than the tightest of the three.
        [Test]
        public function answersAreNestedAndPrecise():void
        {
            var exact:HierarchicalCollider = new HierarchicalCollider(sLand);
            exact.exact = true;
            var fits:TightestFitCollider = new TightestFitCollider(sLand);
            var names:Array = ["bear", "dragon", "fireman", "seagull", "fortress", "person", "spaceship", "tree"];
            var counts:Array = [0, 0, 0];
            for (var i:int = 0; i < Effort.choose(20, 200); i++)
            {
                var agents:Vector.<Agent> = new Vector.<Agent>();
                for (var k:int = 0; k < 24; k++)
                {
                    var agent:Agent = new Agent(_random.pick(names));
                    agent.moveTo(_random.between(-2.5, 2.5), _random.between(-2.5, 2.5), _random.between(-0.5, 0.5));
                    agent.heading = _random.between(0, 360);
                    agent.pitch = _random.pick([0, _random.between(-180, 180)]);
                    agents.push(agent);
                }
                var truth:Object = keysOf(exact.findCollisions(agents), agents);
                var tightest:Object = keysOf(fits.findCollisions(agents), agents);
                for each (agent in agents)
                {
                    agent.collideAs = Agent.HULL;
                }
                var hulls:Object = keysOf(fits.findCollisions(agents), agents);
                for (var key:String in truth)
                {
                    assertTrue("round " + i + ", pair " + key, key in hulls);
                    counts[0]++;
                }
                counts[1] += sizeOf(hulls);
                counts[2] += sizeOf(tightest);
            }
            trace("precision of hulls " + counts[0] / counts[1] + ", of the tightest fits " + counts[0] / counts[2]);
            assertTrue(counts.join(), counts[0] > 200 && counts[0] > 0.65 * counts[1] && counts[2] > 1.4 * counts[1]);
        }

        private static function keysOf(pairs:Vector.<Agent>, agents:Vector.<Agent>):Object
        {
            var keys:Object = {};
            for (var i:int = 0; i < pairs.length; i += 2)
            {
                keys[agents.indexOf(pairs[i]) + "-" + agents.indexOf(pairs[i + 1])] = true;
            }
            return keys;
        }

        private static function sizeOf(keys:Object):int
        {
            var count:int = 0;
            for (var key:String in keys)
            {
                count++;
            }
            return count;
        }
    }
}
