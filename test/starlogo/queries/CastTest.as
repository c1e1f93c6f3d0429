package starlogo.queries
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collider;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TreeCollider;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.EachCollider;
    import support.Effort;
    import support.Fixtures;
    import support.LoopedRays;
    import support.RandomWorlds;
    import support.SolidModels;
    import support.TransformedStructure;
    import support.assertThrows;

    use namespace engine;

    /**
     * What rays meet, against loops over all agents, in worlds of many kinds.
     *
     * <p>This file is long because all of its tests share these worlds.</p>
     */
    public class CastTest
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/kelp.obj", "/assets/fortress.obj"];

        private static const BREEDS:Array = ["turtles", "wolves", "sheep"];
        private static const DEPTHS:Array = [1, 2, 3, 5, 8, 10];

        private static var sModels:Object;
        private static var sShapes:Array;
        private static var sGreatLand:GreatLand;

        private var _random:SeededRandom = new SeededRandom(2221);
        private var _structures:RandomStructures = new RandomStructures(_random);
        private var _agents:Vector.<Agent>;
        private var _origin:Vector3D;
        private var _direction:Vector3D;
        private var _counts:Object = {rays: 0, hits: 0, inside: 0, unclear: 0, agents: 0};

        [BeforeClass]
        public static function load():void
        {
            sModels = {};
            sShapes = [];
            sGreatLand = new GreatLand();
            sGreatLand.orientedBoxDegIncrement = 45;
            for each (var model:Model in SolidModels.all().concat(BuiltInModel.cylinder()))
            {
                addModel(model);
            }
            for each (var address:String in FIXTURES)
            {
                addModel(new ObjModel(address, Fixtures.text(address)));
            }
        }

        [Test]
        public function aRayThatBeginsOnASurfaceMeetsItThere():void
        {
            var collider:Collider = EachCollider.make("triangles", sGreatLand);
            var box:Agent = new Agent(BuiltInModel.cube().name);
            box.size = 4;
            box.moveTo(3, -2, 1);
            var queries:AgentQueries = new AgentQueries(collider);
            queries.update(new <Agent>[box]);
            var origin:Vector3D = new Vector3D();
            for (var i:int = 0; i < Effort.choose(3000, 100000); i++)
            {
                // a point of a face, of an edge or a corner, in numbers that are not rounded
                var coordinates:Array = [_random.integer(-2, 2), _random.integer(-2, 2), _random.integer(-2, 2)];
                coordinates[i % 3] = _random.pick([-2, 2]);
                origin.setTo(3 + coordinates[0], coordinates[1] - 2, 3 + coordinates[2]);
                var direction:Vector3D = new Vector3D(_random.integer(-3, 3), _random.integer(-3, 3), 0.5 + _random.integer(-3, 3));
                var hit:RayHit = queries.cast(origin, direction);
                assertTrue("from " + origin + " along " + direction, hit != null && hit.distance < 1e-14);
            }
        }

        [Test(timeout="3600000")]
        public function agentsAreMetAsALoopFinds():void
        {
            compare("bins", Effort.choose(16, 400), 60);
            compare("tightest fits", Effort.choose(16, 400), 60);
            compare("hierarchies", Effort.choose(8, 200), 12);
            compare("triangles", Effort.choose(8, 200), 12);
            compare("combinations", Effort.choose(8, 200), 20);
        }

        private function compare(system:String, worlds:int, count:int):void
        {
            _counts.hits = _counts.inside = _counts.unclear = 0;
            for (var world:int = 0; world < worlds; world++)
            {
                var collider:Collider = EachCollider.make(system, sGreatLand);
                makeWorld(RandomWorlds.KINDS[world % RandomWorlds.KINDS.length], count);
                var queries:AgentQueries = new AgentQueries(collider);
                queries.update(_agents);
                for (var i:int = 0; i < 25; i++)
                {
                    choose();
                    compareRay(system + ", world " + world + ", ray " + i, system, queries);
                }
            }
            assertTrue("rays that met " + _counts.hits + ", from inside " + _counts.inside + ", agents " + _counts.agents, _counts.hits > 6 * worlds && _counts.inside > worlds / 2);
            assertTrue("not clear: " + _counts.unclear, _counts.unclear < 0.1 * worlds * 25 * count);
        }

        private function compareRay(message:String, system:String, queries:AgentQueries):void
        {
            var looped:LoopedRays = new LoopedRays(sGreatLand, sModels);
            var unit:Vector3D = _direction.clone();
            unit.normalize();
            var most:Number = _random.pick([Infinity, Infinity, _random.between(0, 60)]);
            message += ", from " + _origin + " along " + _direction + " up to " + most;
            var hits:Vector.<RayHit> = queries.castAll(_origin, _direction, most);
            var met:Object = {};
            for (var i:int = 0; i < hits.length; i++)
            {
                var hit:RayHit = hits[i];
                met[_agents.indexOf(hit.agent)] = hit;
                checkHit(message, hit, unit, most);
                assertTrue(message + ": in order", i == 0 || hit.distance > hits[i - 1].distance
                        || (hit.distance == hits[i - 1].distance && _agents.indexOf(hit.agent) > _agents.indexOf(hits[i - 1].agent)));
            }
            for (i = 0; i < _agents.length; i++)
            {
                var expected:Number = looped.distance(system, _agents[i], _origin, unit);
                var slack:Number = 1e-6 * _agents[i].size + 1e-9 * Math.min(1e9, _origin.length + Math.abs(_agents[i].x) + Math.abs(_agents[i].y));
                var isMet:Boolean = met[i] !== undefined;
                if (isNaN(expected) || Math.abs(expected - most) < slack)
                {
                    _counts.unclear++;
                }
                else if (isMet != (expected < Infinity && expected <= most) || isMet && Math.abs(met[i].distance - expected) > slack)
                {
                    assertTrue(message + ", agent " + i + " of size " + _agents[i].size + ", a " + _agents[i].shape + " at " + _agents[i].x + ", " + _agents[i].y + ", "
                            + _agents[i].z + ": " + expected + ", not " + (isMet ? met[i].distance : "met"), false);
                }
                _counts.inside += isMet && met[i].distance == 0 ? 1 : 0;
            }
            _counts.hits += hits.length > 0 ? 1 : 0;
            _counts.agents += hits.length;
            checkFirst(message, queries, hits, most);
        }

        private function checkHit(message:String, hit:RayHit, unit:Vector3D, most:Number):void
        {
            assertTrue(message + ": " + hit.distance, hit.distance >= 0 && hit.distance <= most);
            var along:Number = hit.normal.dotProduct(unit);
            assertTrue(message + ": normal " + hit.normal, Math.abs(hit.normal.length - 1) < 1e-9 && along < 1e-7);
            assertTrue(message + ": from inside", hit.distance > 0 || Math.abs(along + 1) < 1e-9 || Math.abs(along) <= 1);
            var way:Vector3D = unit.clone();
            way.scaleBy(hit.distance);
            assertTrue(message + ": point", Vector3D.distance(_origin.add(way), hit.point) <= 1e-12 * (_origin.length + hit.distance));
        }

        private function checkFirst(message:String, queries:AgentQueries, hits:Vector.<RayHit>, most:Number):void
        {
            var first:RayHit = queries.cast(_origin, _direction, most);
            if (hits.length == 0)
            {
                assertNull(message, first);
                return;
            }
            assertEquals(message, hits[0].agent, first.agent);
            assertEquals(message, hits[0].distance, first.distance);
            assertTrue(message, hits[0].point.equals(first.point) && hits[0].normal.equals(first.normal));
            assertEquals(message + ": just as far", first.agent, queries.cast(_origin, _direction, first.distance).agent);
        }

        [Test(timeout="3600000")]
        public function systemsAreNested():void
        {
            var systems:Array = ["tightest fits", "hierarchies", "combinations"];
            var worlds:int = Effort.choose(24, 1000);
            var differences:int = 0;
            for (var world:int = 0; world < worlds; world++)
            {
                makeWorld(RandomWorlds.KINDS[world % RandomWorlds.KINDS.length], 15);
                var exact:AgentQueries = queriesOf("triangles", 1);
                var others:Array = [queriesOf("tightest fits", 1), queriesOf("combinations", _random.pick(DEPTHS))];
                for each (var depth:int in DEPTHS)
                {
                    others.push(queriesOf("hierarchies", depth));
                }
                for (var i:int = 0; i < 60; i++)
                {
                    i % 2 == 0 ? choose() : chooseVertex();
                    var distances:Vector.<Number> = distancesOf(exact);
                    for (var other:int = others.length - 1; other >= 0; other--)
                    {
                        var nearer:Vector.<Number> = distancesOf(others[other]);
                        for (var agent:int = 0; agent < _agents.length; agent++)
                        {
                            if (!(nearer[agent] <= distances[agent]))
                            {
                                assertTrue("world " + world + ", ray " + i + ", system " + other + ", agent " + agent + ", a " + _agents[agent].shape + ": " + nearer[agent]
                                        + " after " + distances[agent], false);
                            }
                            differences += nearer[agent] < distances[agent] ? 1 : 0;
                            _counts.hits += distances[agent] < Infinity ? 1 : 0;
                        }
                        // of hierarchies one depth after the other
                        distances = other > 2 ? nearer : distancesOf(exact);
                    }
                }
            }
            assertTrue("hits: " + _counts.hits + ", differences: " + differences, _counts.hits > 100 * worlds && differences > 100 * worlds);
        }

        [Test]
        public function agentsInTheWay():void
        {
            for each (var system:String in EachCollider.NAMES)
            {
                for (var world:int = 0; world < 12; world++)
                {
                    makeWorld(RandomWorlds.KINDS[world % RandomWorlds.KINDS.length], 25);
                    var queries:AgentQueries = new AgentQueries(EachCollider.make(system, sGreatLand));
                    queries.update(_agents);
                    for (var i:int = 0; i < 20; i++)
                    {
                        checkSight(system, queries, _agents[_random.integer(0, 24)], _agents[_random.integer(0, 24)]);
                    }
                }
            }
            assertTrue("in the way " + _counts.hits + " of " + _counts.rays, _counts.hits > 100 && _counts.hits < 0.9 * _counts.rays);
        }

        private function checkSight(system:String, queries:AgentQueries, a:Agent, b:Agent):void
        {
            var filter:AgentFilter = new AgentFilter();
            filter.except = new <Agent>[a, b];
            var from:Vector3D = middleOf(system, a);
            var way:Vector3D = middleOf(system, b).subtract(from);
            if (a == b || way.length == 0)
            {
                return;
            }
            var expected:Boolean = queries.cast(from, way, way.length, filter) == null;
            _counts.rays++;
            _counts.hits += expected ? 0 : 1;
            assertEquals(system, expected, queries.canSee(a, b));
            filter.except = null;
            var asked:int = 0;
            filter.accepts = function(agent:Agent):Boolean
            {
                asked++;
                return agent != a && agent != b;
            };
            assertEquals(system, expected, queries.canSee(a, b, filter));
            filter.accepts = null;
            filter.breeds = new <String>["nothing"];
            assertTrue(system, queries.canSee(a, b, filter));
        }

        private static function middleOf(system:String, agent:Agent):Vector3D
        {
            if (system == "bins")
            {
                return new Vector3D(agent.x, agent.y, agent.z + 0.5 * agent.size);
            }
            var isTree:Boolean = system == "hierarchies" || system == "triangles" || (system == "combinations" && agent.hierarchical);
            var structure:BoundingStructure = isTree ? sGreatLand.hierarchies.root(agent.shape).bounds : sGreatLand.boundingStructures.tightestFit(agent.shape);
            var extents:Vector.<Number> = new Vector.<Number>(6, true);
            TransformedStructure.of(structure, agent).extentsInto(extents);
            return new Vector3D((extents[0] + extents[1]) / 2, (extents[2] + extents[3]) / 2, (extents[4] + extents[5]) / 2);
        }

        [Test]
        public function agentsAtOnePlaceSeeEachOtherUnlessOneIsAround():void
        {
            _agents = new <Agent>[new Agent("sphere"), new Agent("sphere"), new Agent("sphere")];
            var queries:AgentQueries = queriesOf("bins", 1);
            assertFalse(queries.canSee(_agents[0], _agents[1]));
            _agents[2].moveTo(2, 0, 0);
            assertFalse("as it was seen", queries.canSee(_agents[0], _agents[1]));
            queries.moved(_agents[2]);
            assertTrue(queries.canSee(_agents[0], _agents[1]));
            assertTrue("itself", queries.canSee(_agents[2], _agents[2]));
            // those that ask are where they are now, listed or not
            _agents[1].moveTo(4, 0, 0);
            assertFalse(queries.canSee(_agents[0], _agents[1]));
            var guest:Agent = new Agent("sphere");
            guest.moveTo(2, 9, 0);
            assertTrue(queries.canSee(guest, _agents[2]));
            guest.moveTo(2, 0, 9);
            assertFalse("the one that was seen elsewhere", queries.canSee(guest, _agents[0]) && queries.canSee(_agents[1], guest));
        }

        [Test]
        public function filtersCount():void
        {
            _agents = new Vector.<Agent>();
            for (var i:int = 0; i < 6; i++)
            {
                _agents.push(new Agent("sphere", BREEDS[i % 3]));
                _agents[i].moveTo(2 * i + 2, 0, 0);
            }
            var queries:AgentQueries = queriesOf("tightest fits", 1);
            _origin = new Vector3D(0, 0, 0.5);
            _direction = new Vector3D(1, 0, 0);
            var filter:AgentFilter = AgentFilter.ofBreeds("wolves", "sheep");
            assertEquals("1,2,4,5", namesOf(queries.castAll(_origin, _direction, Infinity, filter)));
            filter.exceptBreeds = new <String>["wolves"];
            assertEquals("2,5", namesOf(queries.castAll(_origin, _direction, Infinity, filter)));
            filter.except = new <Agent>[_agents[2]];
            assertEquals(_agents[5], queries.cast(_origin, _direction, Infinity, filter).agent);
            var asked:Array = [];
            filter = new AgentFilter();
            filter.accepts = function(agent:Agent):Boolean
            {
                asked.push(_agents.indexOf(agent));
                // questions in a question
                queries.cast(new Vector3D(0, 9, 0), new Vector3D(0, -1, 0));
                queries.castAll(_origin, new Vector3D(1, 0, 0.01));
                return agent.x > 7 && agent.x < 11;
            };
            var hit:RayHit = queries.cast(_origin, _direction, Infinity, filter);
            assertEquals(_agents[3], hit.agent);
            assertTrue(String(hit.distance), Math.abs(hit.distance - 7.5) < 1e-12);
            assertEquals("no more than needed", "0,1,2,3", asked.join());
            assertEquals("3,4", namesOf(queries.castAll(_origin, _direction, Infinity, filter)));
            assertNull(queries.cast(_origin, _direction, 7, filter));
            filter.accepts = function(agent:Agent):Boolean
            {
                queries.update(_agents);
                return true;
            };
            assertThrows(Error, /accepts/, queries.castAll, _origin, _direction, Infinity, filter);
            assertThrows(Error, /accepts/, queries.cast, _origin, _direction, Infinity, filter);
            queries.update(_agents);
        }

        [Test]
        public function hitsAreWrittenIntoWhatIsGiven():void
        {
            _agents = new <Agent>[new Agent("cube"), new Agent("cube"), new Agent("cube")];
            _agents[1].moveTo(3, 0, 0);
            _agents[2].moveTo(3, 0, 0);
            var queries:AgentQueries = queriesOf("tightest fits", 1);
            var hit:RayHit = new RayHit();
            _origin = new Vector3D(9, 0.1, 0.2);
            _direction = new Vector3D(-5, 0, 0);
            assertTrue(hit === queries.cast(_origin, _direction, Infinity, null, hit));
            assertEquals("the first of two", _agents[1], hit.agent);
            assertTrue(hit.distance + " to " + hit.point, Math.abs(hit.distance - 5.5) < 1e-12 && Math.abs(hit.point.x - 3.5) < 1e-12);
            assertTrue(String(hit.normal), hit.normal.equals(new Vector3D(1, 0, 0)));
            var before:RayHit = hit;
            assertNull(queries.cast(_origin, new Vector3D(0, 0, 1), Infinity, null, hit));
            assertEquals("as it was", _agents[1], hit.agent);
            var out:Vector.<RayHit> = new <RayHit>[hit, null, new RayHit(), new RayHit()];
            var third:RayHit = out[2];
            assertTrue(out === queries.castAll(_origin, _direction, Infinity, null, out));
            assertEquals("1,2,0", namesOf(out));
            assertTrue(out[0] === before && out[2] === third);
            queries.castAll(_origin, new Vector3D(0, 0, 1), Infinity, null, out);
            assertEquals(0, out.length);
            var inside:RayHit = queries.cast(new Vector3D(3, 0, 0.5), new Vector3D(0, 3, 4));
            assertEquals(0, inside.distance);
            assertTrue(inside.point.equals(new Vector3D(3, 0, 0.5)) && Math.abs(inside.normal.y + 0.6) + Math.abs(inside.normal.z + 0.8) < 1e-12);
            assertEquals("as far as it goes", "1,2", namesOf(queries.castAll(new Vector3D(4.5, 0, 0.5), new Vector3D(-1, 0, 0), 1.0000000001)));
            assertEquals(0, queries.castAll(new Vector3D(4.5, 0, 0.5), new Vector3D(-1, 0, 0), 0.9999999999).length);
            queries = queriesOf("bins", 1);
            assertEquals("as far as it goes", "1,2", namesOf(queries.castAll(new Vector3D(4.5, 0, 0.5), new Vector3D(-1, 0, 0), 1)));
        }

        [Test]
        public function refusesWhatIsNoRay():void
        {
            _agents = new <Agent>[new Agent("cube")];
            var queries:AgentQueries = queriesOf("triangles", 1);
            var zero:Vector3D = new Vector3D();
            var up:Vector3D = new Vector3D(0, 0, 1);
            for each (var question:Function in [queries.cast, queries.castAll])
            {
                assertThrows(ArgumentError, /origin .*null/, question, null, up);
                assertThrows(ArgumentError, /null/, question, zero, null);
                assertThrows(RangeError, /origin( must be .*finite.*, not|\.y must be a finite number, not) NaN/, question, new Vector3D(0, NaN, 0), up);
                assertThrows(RangeError, /origin( must be .*finite.*, not|\.z must be a finite number, not) -Infinity/, question, new Vector3D(0, 0, -Infinity), up);
                assertThrows(ArgumentError, /direction/, question, zero, zero);
                assertThrows(ArgumentError, /direction/, question, zero, new Vector3D(0, NaN, 1));
                assertThrows(RangeError, /maxDistance must be 0 or more, not -1/, question, zero, up, -1);
                assertThrows(RangeError, /maxDistance must be 0 or more, not NaN/, question, zero, up, NaN);
            }
            assertThrows(ArgumentError, /null/, queries.canSee, null, _agents[0]);
            assertThrows(ArgumentError, /null/, queries.canSee, _agents[0], null);
            assertThrows(ArgumentError, /no model/, queries.canSee, _agents[0], new Agent("nothing"));
            var early:AgentQueries = new AgentQueries(new HierarchicalCollider(sGreatLand));
            assertThrows(IllegalOperationError, /call update\(agents\) of this AgentQueries or SeenAgents, or update\(\) of the DetectionBlocks, before the first question.* Collision does not count/, early.cast, zero, up);
            assertThrows(IllegalOperationError, /call update\(agents\) of this AgentQueries or SeenAgents/, early.near, _agents[0], 1);
            early.update(new <Agent>[]);
            assertNull("there is none", early.cast(zero, up));
        }

        private static function addModel(model:Model):void
        {
            sModels[model.name] = model;
            sShapes.push(model.name);
            sGreatLand.addModel(model);
        }

        private function makeWorld(kind:String, count:int):void
        {
            _agents = RandomWorlds.make(kind, count, "cube", _random);
            for each (var agent:Agent in _agents)
            {
                agent.shape = _random.pick(sShapes);
                agent.breed = _random.pick(BREEDS);
                agent.heading = _random.pick([0, 90, _random.between(-180, 180)]);
                agent.hierarchical = _random.chance(0.5);
                if (_random.chance(0.5))
                {
                    agent.pitch = _random.between(-90, 90);
                    agent.roll = _random.between(-90, 90);
                }
            }
        }

        private function queriesOf(system:String, depth:int):AgentQueries
        {
            var collider:Collider = EachCollider.make(system, sGreatLand);
            if (collider is TreeCollider)
            {
                TreeCollider(collider).maxDepth = depth;
            }
            var queries:AgentQueries = new AgentQueries(collider);
            queries.update(_agents);
            return queries;
        }

        // A ray from near or far, or from inside of an agent; towards another, along an axis, anywhere.
        private function choose():void
        {
            var agent:Agent = _agents[_random.integer(0, _agents.length - 1)];
            var other:Agent = _agents[_random.integer(0, _agents.length - 1)];
            _origin = _structures.position(agent.size * _random.pick([0.4, 0.4, 3, 100]));
            _origin.incrementBy(new Vector3D(agent.x, agent.y, agent.z + 0.5 * agent.size));
            _direction = _structures.position(0.4 * other.size);
            _direction.incrementBy(new Vector3D(other.x, other.y, other.z + 0.5 * other.size));
            _direction.decrementBy(_origin);
            var kind:int = _random.integer(0, 9);
            if (kind < 3)
            {
                var axes:Array = [Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS];
                _direction = axes[kind].clone();
                _direction.scaleBy(_random.pick([-2, 1]));
            }
            else if (kind == 3)
            {
                _direction = _structures.direction();
            }
        }

        // Towards a vertex of an agent.
        private function chooseVertex():void
        {
            choose();
            var agent:Agent = _agents[_random.integer(0, _agents.length - 1)];
            var vertices:Vector.<Number> = sModels[agent.shape].vertices;
            var at:int = 3 * _random.integer(0, vertices.length / 3 - 1);
            var point:Sphere = new Sphere(new Vector3D(vertices[at], vertices[at + 1], vertices[at + 2]), 0);
            _direction = Sphere(point.place(agent.freshPlacement())).center.subtract(_origin);
        }

        private function distancesOf(queries:AgentQueries):Vector.<Number>
        {
            var distances:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < _agents.length; i++)
            {
                distances[i] = Infinity;
            }
            for each (var hit:RayHit in queries.castAll(_origin, _direction))
            {
                distances[_agents.indexOf(hit.agent)] = hit.distance;
            }
            return distances;
        }

        private function namesOf(hits:Vector.<RayHit>):String
        {
            var names:Array = [];
            for each (var hit:RayHit in hits)
            {
                names.push(_agents.indexOf(hit.agent));
            }
            return names.join();
        }
    }
}
