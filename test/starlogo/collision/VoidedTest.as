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
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.SolidModels;
    import support.assertThrows;

    /**
     * Models that change or load, frames that throw and others that ask make void what a collider keeps from frame to frame: one that has been kept
     * finds what a new one finds. In games in which an agent sweeps, the new one has seen the frame before, which is all that a motion needs.
     * test/fuzz/kept.mjs changes agents, lists, handlers and settings.
     */
    public class VoidedTest
    {
        private static const SHAPES:Array = ["sphere", "cube", "cylinder", "flat", "apart"];
        private static const COUNT:int = 16;

        // which colliders find something else
        private static const NOBODY:Array = [];
        private static const ALL:Array = EachCollider.NAMES;
        private static const STRUCTURES:Array = ["tightest fits", "combinations"];
        private static const MODELS:Array = ["tightest fits", "hierarchies", "triangles", "combinations"];

        private static var sGreatLand:GreatLand;

        // games of each collider: every third is one in which an agent sweeps
        private var _rounds:int = Effort.choose(3, 12);
        private var _random:SeededRandom;
        private var _agents:Vector.<Agent>;
        private var _interests:BreedInterests;
        private var _cause:String = "";
        private var _name:String;
        private var _kept:Collider;

        // one that has seen nothing but the last frame
        private var _younger:Collider;
        private var _isSwept:Boolean;
        private var _wrong:Complaints;

        private var _pairs:int;

        [BeforeClass]
        public static function makeModels():void
        {
            sGreatLand = new GreatLand();
            sGreatLand.loadAllBoundingStructures = true;
            for each (var model:Model in [BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder(), SolidModels.apart()])
            {
                sGreatLand.addModel(model);
            }
        }

        [Before]
        public function begin():void
        {
            while (sGreatLand.isLoading("flat"))
            {
                sGreatLand.expectNoMore("flat");
            }
            sGreatLand.addModel(flat(0.3));
            _random = new SeededRandom(88);
            _interests = null;
            _wrong = new Complaints();
            _pairs = 0;
        }

        [Test]
        public function modelsChange():void
        {
            check("a model was replaced", MODELS, function():void
                {
                    sGreatLand.addModel(flat(1.5));
                }, null, flatten);
            check("a model was replaced twice", MODELS, function():void
                {
                    sGreatLand.addModel(flat(0.2));
                    frame();
                    sGreatLand.addModel(flat(1.5));
                    sGreatLand.addModel(flat(1.9));
                }, null, flatten);
            check("a model was replaced and a question asked before the next frame", MODELS, function():void
                {
                    sGreatLand.addModel(flat(1.5));
                    _kept.areColliding(_agents[0], _agents[1]);
                }, null, flatten);
            check("a model was replaced by the same", NOBODY, function():void
                {
                    sGreatLand.addModel(BuiltInModel.cube());
                });
            check("a model that no agent has was added and removed", NOBODY, function():void
                {
                    var cube:Model = BuiltInModel.cube();
                    sGreatLand.addModel(new Model("unrelated", cube.vertices, cube.triangles));
                    frame();
                    assertTrue(sGreatLand.removeModel("unrelated"));
                });
            check("a model was removed and added again", MODELS, function():void
                {
                    assertTrue(sGreatLand.removeModel("flat"));
                    sGreatLand.addModel(flat(1.5));
                }, null, flatten);
            check("a model was removed while its agents were away", MODELS, function():void
                {
                    var all:Vector.<Agent> = _agents;
                    _agents = new Vector.<Agent>();
                    for each (var agent:Agent in all)
                    {
                        if (agent.shape != "flat")
                        {
                            _agents.push(agent);
                        }
                    }
                    sGreatLand.removeModel("flat");
                    frame();
                    sGreatLand.addModel(flat(1.5));
                    _agents = all;
                    frame();
                }, null, flatten);
            check("structures were added directly", STRUCTURES, function():void
                {
                    sGreatLand.boundingStructures.add("flat", flat(1.5).vertices);
                }, null, flatten);
            check("hierarchies were added directly", ["hierarchies", "triangles", "combinations"], function():void
                {
                    sGreatLand.hierarchies.add("flat", flat(1.5).vertices, flat(1.5).triangles);
                }, null, flatten);
        }

        [Test]
        public function modelsAreLoading():void
        {
            check("a model came after loading", ALL, function():void
                {
                    assertTrue("some are loading", _kept.statistics.agentsLoading > 0);
                    sGreatLand.addModel(flat(1.5));
                    sGreatLand.expectNoMore("flat");
                    // a motion begins with the first frame in which it is there
                    frame();
                    assertEquals(0, _kept.statistics.agentsLoading);
                }, null, function():void
                {
                    flatten();
                    sGreatLand.removeModel("flat");
                    sGreatLand.expect("flat");
                });
            check("agents came and left while a model was loading", ALL, function():void
                {
                    _agents.splice(_agents.length - 3, 1);
                    _agents.push(makeAgent(), makeAgent());
                }, null, function():void
                {
                    _agents[1].shape = "flat";
                    sGreatLand.removeModel("flat");
                    sGreatLand.expect("flat");
                });
            check("a model is loading again", ALL, function():void
                {
                    sGreatLand.removeModel("flat");
                    sGreatLand.expect("flat");
                }, null, function():void
                {
                    if (sGreatLand.isLoading("flat"))
                    {
                        sGreatLand.expectNoMore("flat");
                    }
                    flatten();
                });
        }

        [Test]
        public function framesThrow():void
        {
            check("a frame threw of an unknown model", ALL, function():void
                {
                    var agent:Agent = _agents[_random.integer(0, _agents.length - 1)];
                    var shape:String = agent.shape;
                    var first:Agent = _agents[0];
                    first.moveTo(first.x + 1, first.y, first.z);
                    first.size *= 2;
                    agent.shape = "nothing";
                    assertThrows(ArgumentError, /nothing/, findAll);
                    assertThrows(ArgumentError, /nothing/, findAll);
                    agent.shape = shape;
                });
            check("a frame threw of an agent listed twice", ALL, function():void
                {
                    for each (var agent:Agent in some())
                    {
                        agent.moveTo(agent.x + _random.normal(), agent.y, agent.z);
                    }
                    var all:Vector.<Agent> = _agents;
                    _agents = all.concat(new <Agent>[all[_random.integer(0, all.length - 1)]]);
                    assertThrows(ArgumentError, /twice/, findAll);
                    _agents = all;
                });
            check("a frame threw of null", ALL, function():void
                {
                    var all:Vector.<Agent> = _agents;
                    var left:Agent = all.pop();
                    left.breed = "bears";
                    all[3].size *= 3;
                    _agents = all.slice(0, 10).concat(new <Agent>[null], all.slice(10));
                    assertThrows(ArgumentError, /null/, findAll);
                    _agents = all;
                });
            check("a frame threw and the list changed after it", ALL, function():void
                {
                    _agents.push(makeAgent(), _agents[0]);
                    assertThrows(ArgumentError, /twice/, findAll);
                    _agents.length -= 2;
                    _agents.splice(0, 3);
                    _agents.push(makeAgent());
                });
        }

        [Test]
        public function othersAskToo():void
        {
            check("another collider was used on the same agents", ALL, function():void
                {
                    for each (var name:String in ALL)
                    {
                        var other:Collider = EachCollider.make(name, sGreatLand);
                        for each (var agent:Agent in some())
                        {
                            agent.moveTo(agent.x + 0.3 * _random.normal(), agent.y, agent.z);
                            agent.breed = _random.pick(["bears", "balls", "walls"]);
                        }
                        other.findCollisionsAmong(_agents, bearsAndBalls(), new Vector.<Agent>());
                        other.findCollisions(_agents.concat().reverse());
                    }
                }, bearsAndBalls);
            // long enough for what is kept with the agents to be dropped
            check("many other colliders were used on the same agents", NOBODY, function():void
                {
                    for (var i:int = 0; i < 40; i++)
                    {
                        new BinCollider(sGreatLand).findCollisions(_agents);
                    }
                });
            check("questions were asked in between", ALL, function():void
                {
                    var stranger:Agent = makeAgent();
                    for each (var agent:Agent in some())
                    {
                        agent.moveTo(agent.x, agent.y + 0.7 * _random.normal(), agent.z);
                        agent.size *= 1.3;
                        _kept.areColliding(agent, stranger);
                        if (agent !== _agents[0])
                        {
                            _kept.areColliding(_agents[0], agent);
                            _kept.contactOf(agent, _agents[0]);
                        }
                        agent.size /= 1.3;
                    }
                });
        }

        [Test]
        public function aQuestionThrewBeforeAnother():void
        {
            sGreatLand.expect("later");
            for each (var name:String in MODELS)
            {
                var collider:Collider = EachCollider.make(name, sGreatLand);
                var ball:Agent = new Agent("sphere");
                ball.size = 0.5;
                ball.hierarchical = true;
                var cube:Agent = new Agent("cube");
                var other:Agent = new Agent("cube");
                // a corner that a sphere has not
                other.moveTo(0.95, 0.95, 0.95);
                cube.hierarchical = other.hierarchical = true;
                assertThrows(ArgumentError, /loading/, collider.contactOf, ball, new Agent("later"));
                assertTrue(name, collider.areColliding(cube, other));
                assertThrows(ArgumentError, /loading/, collider.contactOf, new Agent("later"), ball);
                assertTrue(name + ", the other way round", collider.areColliding(other, cube));
            }
            sGreatLand.expectNoMore("later");
        }

        // Each collider in games of several frames, in which no agent sweeps, and in which some do.
        private function check(cause:String, changed:Array, happens:Function, interests:Function = null, before:Function = null):void
        {
            begin();
            _cause = cause;
            var changes:Object = {};
            for each (var name:String in ALL)
            {
                changes[name] = 0;
                for (var round:int = 0; round < _rounds; round++)
                {
                    _isSwept = round % 3 == 1;
                    _agents = makeAgents();
                    _interests = interests == null ? null : interests();
                    if (before != null)
                    {
                        before();
                    }
                    start(name);
                    for (var i:int = 0; i < 2; i++)
                    {
                        frame();
                        moveSome();
                    }
                    var was:String = frame();
                    if (_isSwept)
                    {
                        moveSome();
                    }
                    happens();
                    var now:String = compare("at once");
                    changes[name] += now == was || _isSwept ? 0 : 1;
                    // and in the frame after that, in which little happens
                    moveSome();
                    compare("a frame later");
                }
            }
            finish(changed, changes);
        }

        private function finish(changed:Array, changes:Object):void
        {
            _wrong.assertNone();
            assertTrue(_cause + ": " + _pairs + " pairs", _pairs > 300);
            for each (var name:String in changed)
            {
                assertTrue(name + " find something else when " + _cause, changes[name] > 0);
            }
        }

        // Most are of the model that is replaced, which is thin so far.
        private function flatten():void
        {
            for (var i:int = 0; i < _agents.length; i++)
            {
                if (i % 4 != 0)
                {
                    _agents[i].shape = "flat";
                }
            }
            sGreatLand.addModel(flat(0.1));
        }

        private function start(name:String):void
        {
            _name = name;
            _kept = EachCollider.make(name, sGreatLand);
        }

        // What the kept one finds.
        private function frame():String
        {
            var found:String = find(_kept);
            if (_isSwept)
            {
                _younger = EachCollider.make(_name, sGreatLand);
                assertEquals("agents", _agents.length, _kept.statistics.agents);
                find(_younger);
            }
            return found;
        }

        // A frame of the kept one and of one that is new, or has seen the last frame alone.
        private function compare(when:String):String
        {
            if (!_isSwept)
            {
                _younger = EachCollider.make(_name, sGreatLand);
            }
            var expected:String = find(_younger);
            var found:String = find(_kept);
            _wrong.addIf(found != expected,
                    _cause + ": " + _name + (_isSwept ? ", swept, " : ", standing, ") + when, found.substr(0, 80) + ", not " + expected.substr(0, 80));
            return found;
        }

        // The pairs, and the agents that take part.
        private function find(collider:Collider):String
        {
            var found:Vector.<Agent> = new Vector.<Agent>();
            if (_interests == null)
            {
                collider.findCollisions(_agents, found);
            }
            else
            {
                collider.findCollisionsAmong(_agents, _interests, found);
            }
            var lines:Array = [];
            for (var i:int = 0; i < found.length; i += 2)
            {
                lines.push(found[i].id + "-" + found[i + 1].id);
                _pairs++;
            }
            var statistics:CollisionStatistics = collider.statistics;
            return [statistics.agents, statistics.agentsSkipped, statistics.agentsLoading, statistics.collisions].join(" ") + ": " + lines.sort().join(" ");
        }

        private function findAll():void
        {
            find(_kept);
        }

        private static function bearsAndBalls():BreedInterests
        {
            var interests:BreedInterests = new BreedInterests();
            interests.add("bears", "balls");
            return interests;
        }

        // About every second one.
        private function some():Array
        {
            var chosen:Array = [];
            for each (var agent:Agent in _agents)
            {
                if (_random.chance())
                {
                    chosen.push(agent);
                }
            }
            return chosen;
        }

        private function moveSome():void
        {
            for each (var agent:Agent in _agents)
            {
                if (_random.chance(0.3))
                {
                    agent.moveTo(agent.x * 0.95 + 0.4 * _random.normal(), agent.y * 0.95 + 0.4 * _random.normal(), agent.z);
                }
            }
        }

        private function makeAgents():Vector.<Agent>
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < COUNT; i++)
            {
                agents.push(makeAgent());
            }
            agents[0].sweeps = _isSwept;
            return agents;
        }

        private function makeAgent():Agent
        {
            var agent:Agent = new Agent(_random.pick(SHAPES), _random.pick(["bears", "balls", "walls"]));
            agent.moveTo(_random.between(-2, 2), _random.between(-2, 2), _random.between(0, 0.5));
            agent.heading = _random.between(0, 360);
            agent.hierarchical = _random.chance();
            agent.sweeps = _isSwept && _random.chance(0.4);
            return agent;
        }

        private static function flat(height:Number):Model
        {
            return SolidModels.wedge("flat", height);
        }
    }
}
