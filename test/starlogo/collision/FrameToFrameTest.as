package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.search.BreedInterests;

    /**
     * What colliders keep from frame to frame must not show: one that has seen all of a game finds what a new one finds, and is as
     * strict.
     */
    public class FrameToFrameTest
    {
        private static const FRAMES:int = 50;
        private static const SHAPES:Array = ["sphere", "cube", "cylinder", "flat"];

        private var _land:GreatLand;
        private var _random:SeededRandom;
        private var _agents:Vector.<Agent>;
        private var _hits:int;
        private var _repeated:int;

        [Before]
        public function makeLand():void
        {
            _land = new GreatLand();
            _land.addModel(BuiltInModel.sphere());
            _land.addModel(BuiltInModel.cube());
            _land.addModel(BuiltInModel.cylinder());
            _land.addModel(flat(0.3));
            _hits = _repeated = 0;
        }

        [Test]
        public function bins():void
        {
            play(BinCollider, 901);
        }

        [Test]
        public function tightestFits():void
        {
            play(TightestFitCollider, 902);
        }

        [Test]
        public function hierarchies():void
        {
            play(HierarchicalCollider, 903);
        }

        [Test]
        public function combinations():void
        {
            play(CombinationCollider, 904);
        }

        // Several games, in each frame of which a few things happen that matter to what is kept.
        private function play(type:Class, seed:uint):void
        {
            _random = new SeededRandom(seed);
            for (var game:int = 0; game < 8; game++)
            {
                makeAgents(40);
                var kept:CollisionSystem = new type(_land);
                var interests:BreedInterests = new BreedInterests();
                interests.add("bears", "balls");
                for (var frame:int = 0; frame < FRAMES; frame++)
                {
                    moveSome();
                    var happens:String = _random.pick(["nothing", "nothing", "grow", "far", "shape", "breed", "swap", "leave", "come", "ask", "model", "broken", "others"]);
                    happen(happens, kept);
                    _repeated += happens == "nothing" ? 1 : 0;
                    var name:String = type + ", game " + game + ", frame " + frame + ", " + happens;
                    if (game % 2 == 0)
                    {
                        assertSame(name, CollisionSystem(new type(_land)).findCollisions(_agents), kept.findCollisions(_agents));
                        assertEquals(name, 0, kept.statistics.agentsSkipped);
                    }
                    else
                    {
                        assertSame(name + ", among breeds", BaseCollider(new type(_land)).findCollisionsAmong(_agents, interests, new Vector.<Agent>()),
                                BaseCollider(kept).findCollisionsAmong(_agents, interests, new Vector.<Agent>()));
                    }
                }
            }
            assertTrue(_hits + " pairs", _hits > 8 * FRAMES * 3);
            assertTrue(_repeated + " quiet frames", _repeated > 20);
        }

        private function happen(what:String, kept:CollisionSystem):void
        {
            var agent:Agent = _random.pick(asArray(_agents));
            switch (what)
            {
                case "grow":
                    agent.size = _random.logBetween(0.2, 6);
                    break;
                case "far":
                    _agents[0].moveTo(_random.pick([0, 9e8]), 0, _random.pick([0, 3e8]));
                    agent.moveTo(_agents[0].x + 0.25, 0, _agents[0].z);
                    break;
                case "shape":
                    agent.shape = _random.pick(SHAPES);
                    agent.hierarchical = _random.chance();
                    break;
                case "breed":
                    agent.breed = _random.pick(["bears", "balls", "walls"]);
                    break;
                case "swap":
                    _agents.push(_agents.shift());
                    break;
                case "leave":
                    _agents.splice(_random.integer(0, _agents.length - 1), 1);
                    break;
                case "come":
                    _agents.splice(_random.integer(0, _agents.length), 0, makeAgent());
                    break;
                case "ask":
                    agent.size = _random.logBetween(0.2, 6);
                    if (agent !== _agents[0])
                    {
                        kept.areColliding(agent, _agents[0]);
                    }
                    break;
                case "model":
                    _land.addModel(flat(_random.between(0.1, 0.9)));
                    break;
                case "broken":
                    searchBroken(agent, kept);
                    break;
                case "others":
                    // long enough for records to be dropped
                    for (var i:int = 0; i < 40; i++)
                    {
                        new BinCollider(_land).findCollisions(_agents);
                    }
                    agent.breed = "balls";
                    break;
            }
        }

        // A search that fails half-way, after agents before the one that is wrong have changed.
        private function searchBroken(agent:Agent, kept:CollisionSystem):void
        {
            _agents[0].size *= 3;
            var shape:String = agent.shape;
            var list:Vector.<Agent> = _agents;
            var isTwice:Boolean = _random.chance();
            if (isTwice)
            {
                list = _agents.concat(new <Agent>[agent]);
            }
            else
            {
                agent.shape = "unknown";
            }
            var thrown:int = 0;
            // twice over: the second time nothing is new
            for (var i:int = 0; i < 2; i++)
            {
                try
                {
                    kept.findCollisions(list);
                }
                catch (error:ArgumentError)
                {
                    thrown++;
                }
            }
            assertEquals(isTwice ? "listed twice" : "an unknown model", 2, thrown);
            agent.shape = shape;
            _agents[0].size /= 3;
        }

        private function moveSome():void
        {
            for each (var agent:Agent in _agents)
            {
                if (_random.chance(0.7))
                {
                    agent.moveTo(agent.x + _random.normal() * 0.3, agent.y + _random.normal() * 0.3, agent.z);
                }
                if (_random.chance(0.1))
                {
                    agent.heading = _random.between(0, 360);
                    agent.pitch = _random.pick([0, 0, 30]);
                }
            }
        }

        private function makeAgents(count:int):void
        {
            _agents = new Vector.<Agent>();
            for (var i:int = 0; i < count; i++)
            {
                _agents.push(makeAgent());
            }
        }

        private function makeAgent():Agent
        {
            var agent:Agent = new Agent(_random.pick(SHAPES), _random.pick(["bears", "balls", "walls"]));
            agent.moveTo(_random.between(-4, 4), _random.between(-4, 4), 0);
            agent.hierarchical = _random.chance(0.3);
            return agent;
        }

        private static function flat(height:Number):Model
        {
            return new Model("flat", new <Number>[0, 0, 0, 1, 0, 0, 1, 0.4, 0, 0, 0.4, 0, 0.5, 0.2, height],
                    new <uint>[0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 0, 2, 1, 0, 3, 2]);
        }

        private static function asArray(agents:Vector.<Agent>):Array
        {
            var result:Array = [];
            for each (var agent:Agent in agents)
            {
                result.push(agent);
            }
            return result;
        }

        // The same pairs, whatever their order: the one that is kept may have its bins in another.
        private function assertSame(name:String, expected:Vector.<Agent>, actual:Vector.<Agent>):void
        {
            assertEquals(name, textOf(expected), textOf(actual));
            _hits += expected.length / 2;
        }

        private static function textOf(pairs:Vector.<Agent>):String
        {
            var lines:Array = [];
            for (var i:int = 0; i < pairs.length; i += 2)
            {
                lines.push(pairs[i].id + "-" + pairs[i + 1].id);
            }
            return lines.sort().join(" ");
        }
    }
}
