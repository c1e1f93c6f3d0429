package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.EachCollider;
    import support.SolidModels;
    import support.assertThrows;

    /** AgentQueries.distance: of when the agents are, what is refused, and the same on every machine. */
    public class AgentDistanceTest
    {
        // of the bits of all distances
        private static const GOLDEN:String = "cdaf056c";

        private static var sGreatLand:GreatLand;
        private static var sNames:Array;

        private var _random:SeededRandom = new SeededRandom(2240);

        [BeforeClass]
        public static function load():void
        {
            sGreatLand = new GreatLand();
            sGreatLand.orientedBoxDegIncrement = 45;
            sNames = [];
            for each (var model:Model in SolidModels.all().concat(BuiltInModel.cylinder()))
            {
                sGreatLand.addModel(model);
                sNames.push(model.name);
            }
        }

        [Test]
        public function theAskerIsOfNowTheOtherAsSeen():void
        {
            for each (var collider:Collider in colliders())
            {
                var queries:AgentQueries = new AgentQueries(collider);
                var a:Agent = new Agent("sphere");
                var b:Agent = new Agent("sphere");
                b.moveTo(4, 0, 0);
                queries.update(new <Agent>[a, b]);
                var apart:Number = queries.distance(a, b);
                assertTrue(collider + ": " + apart, apart > 2.5 && apart <= 3 + 1e-12);
                b.moveTo(20, 0, 0);
                b.size = 3;
                assertEquals(collider + ": the other as it was", apart, queries.distance(a, b));
                a.moveTo(-1, 0, 0);
                assertNear(collider + ": the asker as it is", apart + 1, queries.distance(a, b));
                var stranger:Agent = new Agent("sphere");
                stranger.moveTo(-6, 0, 0);
                assertNear(collider + ": a stranger asks", apart + 6, queries.distance(stranger, b));
                assertNear(collider + ": about a stranger", apart + 1, queries.distance(a, stranger));
                stranger.moveTo(-7, 0, 0);
                assertNear(collider + ": a stranger is of now", apart + 2, queries.distance(a, stranger));
                queries.moved(b);
                assertFalse(collider + ": moved", apart == queries.distance(a, b));
            }
        }

        [Test]
        public function refusals():void
        {
            var queries:AgentQueries = new AgentQueries(new TightestFitCollider(sGreatLand));
            var agents:Vector.<Agent> = world(2, 9);
            queries.update(agents);
            var before:Number = queries.distance(agents[0], agents[1]);
            var unknown:Agent = new Agent("unknown");
            for each (var pair:Array in [[null, agents[1]], [agents[0], null], [agents[0], agents[0]], [agents[0], unknown], [unknown, agents[0]]])
            {
                assertThrows(ArgumentError, /agents are needed|unknown/, queries.distance, pair[0], pair[1]);
            }
            assertEquals("as before", before, queries.distance(agents[0], agents[1]));
        }

        [Test]
        public function theSameOnEveryMachine():void
        {
            var bytes:ByteArray = new ByteArray();
            for each (var collider:Collider in colliders())
            {
                var agents:Vector.<Agent> = world(40, 6);
                var queries:AgentQueries = new AgentQueries(collider);
                queries.update(agents);
                for (var i:int = 1; i < agents.length; i++)
                {
                    bytes.writeDouble(queries.distance(agents[i - 1], agents[i]));
                }
            }
            bytes.position = 0;
            var hash:int = 17;
            while (bytes.bytesAvailable > 0)
            {
                hash = hash * 31 + bytes.readInt() | 0;
                hash ^= hash >>> 13;
            }
            assertEquals(GOLDEN, (hash >>> 0).toString(16));
        }

        private static function assertNear(what:String, expected:Number, actual:Number):void
        {
            assertTrue(what + ": " + actual + " is not " + expected, Math.abs(actual - expected) <= 1e-11);
        }

        private static function colliders():Array
        {
            return EachCollider.NAMES.map(function(name:String, index:int, all:Array):Collider
                {
                    return EachCollider.make(name, sGreatLand);
                });
        }

        private function world(count:int, spread:Number):Vector.<Agent>
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < count; i++)
            {
                var agent:Agent = new Agent(_random.pick(sNames));
                agent.moveTo(_random.between(-spread, spread), _random.between(-spread, spread), _random.between(-spread, spread) / 3);
                agent.size = _random.between(0.3, 1.5);
                agent.heading = _random.between(0, 360);
                agent.pitch = _random.pick([0, _random.between(0, 360)]);
                agent.hierarchical = _random.chance();
                agents.push(agent);
            }
            return agents;
        }
    }
}
