package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ObjModel;
    import support.EachCollider;
    import support.Effort;
    import support.Fixtures;
    import support.RandomWorlds;
    import support.ThinModels;
    import support.landOf;

    /** The answers about places and touches against loops over all agents, in worlds of many kinds. With -Dfull 1,000,000 questions. */
    public class AgentQueriesTest
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/fortress.obj", "/assets/kelp.obj"];

        private static const SHAPES:Array = ["sphere", "cube", "cylinder", "bear", "fortress", "kelp", "point", "two points", "triangle", "plane"];
        private static const BREEDS:Array = ["turtles", "wolves", "sheep", "toString", "__proto__"];

        private static var sGreatLand:GreatLand;

        private var _random:SeededRandom;
        private var _queries:AgentQueries;
        private var _reference:LoopedQuestions;
        private var _agents:Vector.<Agent>;
        private var _answers:int = 0;
        private var _empty:int = 0;

        [BeforeClass]
        public static function load():void
        {
            sGreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder());
            ThinModels.addTo(sGreatLand);
            for each (var name:String in ["bear", "fortress", "kelp"])
            {
                sGreatLand.addModel(new ObjModel(name, Fixtures.text("/assets/" + name + ".obj")));
            }
        }

        [Test]
        public function olderNamesAnswerAlike():void
        {
            var collider:BinCollider = new BinCollider();
            var queries:AgentQueries = new AgentQueries(collider);
            var asker:Agent = new Agent("sphere");
            var other:Agent = new Agent("sphere");
            other.moveTo(3, 0, 0);
            queries.update(new <Agent>[asker, other]);
            assertFalse(queries.wouldTouchAt(asker, 6.5, 0, 0) || queries.overlapsAgent(asker, 6.5, 0, 0));
            other.moveTo(7, 0, 0);
            queries.moved(other);
            assertTrue(queries.wouldTouchAt(asker, 6.5, 0, 0) && queries.overlapsAgent(asker, 6.5, 0, 0));
            assertEquals(1, queries.nearestOf(asker, 2, 7.5).length);
            assertEquals(1, queries.nearestFew(asker, 2, 7.5).length);
            other.moveTo(8, 0, 0);
            queries.refresh(other);
            assertEquals(0, queries.nearestOf(asker, 2, 7.5).length);
            assertEquals(0, queries.nearestFew(asker, 2, 7.5).length);
        }

        [Test]
        public function whoIsInNoListIsSeenWhileTheListGrows():void
        {
            for each (var shape:String in ["sphere", "cube", "bear"])
            {
                for each (var name:String in EachCollider.ALL_NAMES)
                {
                    var agents:Vector.<Agent> = new <Agent>[agentAt(shape, 0)];
                    var guest:Agent = agentAt(shape, 10);
                    var queries:AgentQueries = new AgentQueries(EachCollider.make(name, sGreatLand));
                    queries.update(agents);
                    for (var i:int = 0; i < 3; i++)
                    {
                        queries.touching(guest);
                    }
                    agents.push(agentAt(shape, 20));
                    queries.update(agents);
                    queries.touching(agentAt(shape, 20.5));
                    assertTrue(name + ", " + shape, queries.distance(guest, agents[1]) > 7);
                }
            }
        }

        [Test(timeout="3600000")]
        public function placesAreAsALoopFindsThem():void
        {
            _random = new SeededRandom(2201);
            var worlds:int = Effort.choose(48, 1600);
            for (var world:int = 0; world < worlds; world++)
            {
                makeWorld(RandomWorlds.KINDS[world % RandomWorlds.KINDS.length], _random.integer(1, 250), new TightestFitCollider(sGreatLand));
                for (var i:int = 0; i < 40; i++)
                {
                    changeSome();
                    askPlaces("world " + world + ", " + i);
                }
            }
            assertTrue(_answers + " answers, " + _empty + " empty", _answers > 25 * worlds && _empty > 3 * worlds);
        }

        [Test(timeout="3600000")]
        public function touchesAreAsTheSystemFindsThem():void
        {
            _random = new SeededRandom(2202);
            var worlds:int = Effort.choose(2, 40);
            for each (var name:String in EachCollider.NAMES)
            {
                for (var world:int = 0; world < worlds * RandomWorlds.KINDS.length; world++)
                {
                    var collider:Collider = EachCollider.make(name, sGreatLand);
                    makeWorld(RandomWorlds.KINDS[world % RandomWorlds.KINDS.length], _random.integer(2, 60), collider);
                    askAllWhatTheyTouch(name + ", world " + world, EachCollider.make(name, sGreatLand));
                }
            }
            assertTrue(_answers + " answers, " + _empty + " empty", _answers > 100 * worlds && _empty > 100 * worlds);
        }

        private static function agentAt(shape:String, x:Number):Agent
        {
            var agent:Agent = new Agent(shape);
            agent.moveTo(x, 0, 0);
            return agent;
        }

        private function makeWorld(kind:String, count:int, collider:Collider):void
        {
            _agents = RandomWorlds.make(kind, count, "cube", _random);
            for each (var agent:Agent in _agents)
            {
                agent.shape = _random.pick(SHAPES);
                agent.breed = _random.pick(BREEDS);
                agent.heading = _random.between(-180, 180);
                agent.hierarchical = _random.chance(0.5);
                if (_random.chance(0.5))
                {
                    agent.pitch = _random.between(-90, 90);
                    agent.roll = _random.between(-90, 90);
                }
            }
            _queries = new AgentQueries(collider);
            _reference = new LoopedQuestions();
            update();
        }

        private function update():void
        {
            _queries.update(_agents);
            _reference.update(_agents);
        }

        private function changeSome():void
        {
            var agent:Agent = anyAgent();
            var other:Agent = anyAgent();
            switch (_random.integer(0, 5))
            {
                case 0:
                    // seen where it was
                    agent.moveTo(other.x + _random.normal(), other.y + _random.normal(), other.z + _random.normal());
                    break;
                case 1:
                    agent.moveTo(other.x, other.y, other.z);
                    _queries.moved(agent);
                    _reference.moved(agent);
                    break;
                case 2:
                    agent.breed = _random.pick(BREEDS);
                    break;
                case 3:
                    var place:int = _random.integer(0, _agents.length - 1);
                    if (_agents.length > 1)
                    {
                        _agents.splice(place, 1);
                    }
                    update();
                    break;
                case 4:
                    _agents.splice(_random.integer(0, _agents.length), 0, newAgent(other));
                    update();
                    break;
                default:
                    break;
            }
        }

        private function anyAgent():Agent
        {
            return _agents[_random.integer(0, _agents.length - 1)];
        }

        private function newAgent(near:Agent):Agent
        {
            var agent:Agent = new Agent(_random.pick(SHAPES), _random.pick(BREEDS));
            agent.moveTo(near.x + _random.normal(), near.y, near.z);
            return agent;
        }

        private function askPlaces(message:String):void
        {
            var asker:Agent = _random.chance(0.9) ? anyAgent() : newAgent(anyAgent());
            var other:Agent = anyAgent();
            // mostly as far as that other is
            var radius:Number = _random.chance(0.8) ? _reference.distance(asker, other) : _random.pick([0, 1, 5, 1e4, Infinity]);
            var filter:AgentFilter = randomFilter();
            var near:Vector.<Agent> = _reference.near(asker.x, asker.y, asker.z, asker, radius, filter);
            near.length > 0 ? _answers++ : _empty++;
            message += " with " + near.length;
            assertSame(message + ": near", near, _queries.near(asker, radius, filter));
            assertEquals(message + ": countNear", near.length, _queries.countNear(asker, radius, filter));
            assertEquals(message + ": nearest", near.length > 0 ? near[0] : null, _queries.nearest(asker, radius, filter));
            var count:int = _random.pick([0, 1, 2, 5, 30, 1000]);
            assertSame(message + ": nearestOf " + count, near.slice(0, count), _queries.nearestOf(asker, count, radius, filter));
            assertAskedInOrder(message, asker, count, radius);
            var degrees:Number = _random.pick([0, 30, 90, 180, 200, 359, 360, 500]);
            assertSame(message + ": inCone " + degrees, _reference.inCone(asker, near, degrees), _queries.inCone(asker, radius, degrees, filter));
            var point:Vector3D = new Vector3D(asker.x, other.y, asker.z);
            near = _reference.near(point.x, point.y, point.z, null, radius, filter);
            assertSame(message + ": nearPoint", near, _queries.nearPoint(point, radius, filter));
            assertEquals(message + ": countNearPoint", near.length, _queries.countNearPoint(point, radius, filter));
            assertEquals(message + ": nearestToPoint", near.length > 0 ? near[0] : null, _queries.nearestToPoint(point, radius, filter));
        }

        // The function of a filter is called for the nearest agents first, until enough are accepted.
        private function assertAskedInOrder(message:String, asker:Agent, count:int, radius:Number):void
        {
            var asked:Vector.<Agent> = new Vector.<Agent>();
            var filter:AgentFilter = new AgentFilter();
            filter.accepts = function(agent:Agent):Boolean
            {
                asked.push(agent);
                return asked.length % 3 == 0;
            };
            _queries.nearestOf(asker, count, radius, filter);
            assertSame(message + ": asked", _reference.near(asker.x, asker.y, asker.z, asker, radius, null).slice(0, 3 * count), asked);
        }

        private function randomFilter():AgentFilter
        {
            if (_random.chance(0.4))
            {
                return null;
            }
            var filter:AgentFilter = new AgentFilter();
            if (_random.chance(0.4))
            {
                filter.breeds = new <String>[_random.pick(BREEDS), _random.pick(BREEDS), "nobody's"];
            }
            if (_random.chance(0.4))
            {
                filter.exceptBreeds = new <String>[_random.pick(BREEDS)];
            }
            if (_random.chance(0.4))
            {
                filter.except = new <Agent>[anyAgent(), new Agent("cube")];
            }
            if (_random.chance(0.4))
            {
                var queries:AgentQueries = _queries;
                filter.accepts = function(agent:Agent):Boolean
                {
                    // what it asks disturbs nothing
                    queries.near(agent, 3);
                    queries.nearest(agent, Infinity, AgentFilter.ofBreeds("sheep"));
                    return agent.id % 3 == 0;
                };
            }
            return filter;
        }

        [Test]
        public function aComputedDistanceIsARadiusThatReaches():void
        {
            var random:SeededRandom = new SeededRandom(911);
            var asker:Agent = new Agent("cube");
            var other:Agent = new Agent("cube");
            var queries:AgentQueries = new AgentQueries(new BinCollider(sGreatLand));
            for (var i:int = 0; i < 2000; i++)
            {
                var scale:Number = random.logBetween(1e-6, 1e8);
                asker.moveTo(random.between(-scale, scale), random.between(-scale, scale), random.between(-scale, scale));
                other.moveTo(asker.x + random.normal(), asker.y + random.normal() * scale, asker.z - random.normal() * scale);
                queries.update(new <Agent>[asker, other]);
                var x:Number = other.x - asker.x;
                var y:Number = other.y - asker.y;
                var z:Number = other.z - asker.z;
                var at:Vector3D = new Vector3D(asker.x, asker.y, asker.z);
                asker.heading = Math.atan2(y, x) * 180 / Math.PI;
                for each (var distance:Number in [Math.sqrt(x * x + y * y + z * z), Math.sqrt(z * z + y * y + x * x), at.subtract(new Vector3D(other.x, other.y, other.z)).length])
                {
                    var message:String = i + ": " + distance;
                    assertEquals(message, 1, queries.near(asker, distance).length);
                    assertEquals(message, 1, queries.countNear(asker, distance));
                    assertEquals(message, other, queries.nearest(asker, distance));
                    assertEquals(message, 1, queries.nearestFew(asker, 2, distance).length);
                    assertEquals(message, 1, queries.inCone(asker, distance, 181).length);
                    assertEquals(message, 2, queries.nearPoint(at, distance).length);
                    assertEquals(message, 2, queries.countNearPoint(at, distance));
                    assertEquals(message, 0, queries.countNear(asker, distance * (1 - 1e-14)));
                }
            }
        }

        [Test]
        public function anAgentSeesItselfInsideOfAnother():void
        {
            var inside:Agent = new Agent("sphere");
            var other:Agent = new Agent("sphere");
            var around:Agent = new Agent("cube");
            other.x = 0.5;
            around.size = 9;
            around.z = -4;
            var queries:AgentQueries = new AgentQueries(new TightestFitCollider(sGreatLand));
            queries.update(new <Agent>[inside, other, around]);
            assertTrue(queries.canSee(inside, inside));
            assertFalse(queries.canSee(inside, other));
        }

        [Test]
        public function aNewBreedWhileAFilterIsAsked():void
        {
            var agents:Vector.<Agent> = new <Agent>[new Agent("cube", "sheep")];
            while (agents.length < 100)
            {
                var wolf:Agent = new Agent("cube", "wolves");
                wolf.x = 10 * agents.length;
                agents.push(wolf);
            }
            var queries:AgentQueries = new AgentQueries(new BinCollider(sGreatLand));
            queries.update(agents);
            var filter:AgentFilter = AgentFilter.ofBreeds("wolves");
            var asked:int = 0;
            filter.accepts = function(agent:Agent):Boolean
            {
                asked++;
                agents[agents.length - asked].breed = "the new breed of " + agent.id;
                return false;
            };
            assertNull(queries.nearest(agents[0], Infinity, filter));
            assertTrue(asked > 40 && asked < 60);
        }

        private function askAllWhatTheyTouch(message:String, system:Collider):void
        {
            var pairs:Vector.<Agent> = system.findCollisions(_agents);
            for each (var agent:Agent in _agents)
            {
                var touched:Vector.<Agent> = new Vector.<Agent>();
                for (var i:int = 0; i < pairs.length; i++)
                {
                    if (pairs[i] == agent)
                    {
                        touched.push(pairs[i ^ 1]);
                    }
                }
                assertAboutTouches(message, agent, touched);
            }
            // from elsewhere, as it is now
            for (i = 0; i < 3; i++)
            {
                agent = i < 2 ? anyAgent() : newAgent(anyAgent());
                var other:Agent = anyAgent();
                var x:Number = agent.x;
                var y:Number = agent.y;
                var z:Number = agent.z;
                agent.moveTo(other.x + _random.normal() * other.size, other.y, other.z);
                touched.length = 0;
                for each (other in _agents)
                {
                    if (other != agent && system.areColliding(agent, other))
                    {
                        touched.push(other);
                    }
                }
                assertAboutTouches(message + ", moved", agent, touched);
                agent.moveTo(x, y, z);
            }
        }

        private function assertAboutTouches(message:String, agent:Agent, touched:Vector.<Agent>):void
        {
            touched.length > 0 ? _answers++ : _empty++;
            var all:Vector.<Agent> = _reference.sorted(agent.x, agent.y, agent.z, touched);
            assertSame(message + ": touching", all, _queries.touching(agent));
            assertEquals(message + ": touchesAny", all.length > 0, _queries.touchesAny(agent));
            var filter:AgentFilter = randomFilter();
            all = _reference.filtered(all, filter);
            assertSame(message + ": touching, some", all, _queries.touching(agent, filter));
            assertEquals(message + ": touchesAny, some", all.length > 0, _queries.touchesAny(agent, filter));
        }

        private static function assertSame(message:String, expected:Vector.<Agent>, found:Vector.<Agent>):void
        {
            assertEquals(message, LoopedQuestions.numbers(expected), LoopedQuestions.numbers(found));
        }
    }
}
