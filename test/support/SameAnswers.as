package support
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.collision.Collider;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.Contact;
    import starlogo.collision.TightestFitCollider;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.Footing;
    import starlogo.queries.RayHit;
    import starlogo.queries.ShapeHit;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;

    /**
     * The same agents twice, as two kinds of structures that are the same shape: every question has the same answers.
     */
    public class SameAnswers
    {
        private static const NEAR:Number = 1e-9;

        private var _land:GreatLand;
        private var _shape:String;
        private var _collideAs:String;
        private var _random:SeededRandom;

        // the same agents twice: as the structures of a kind, and as hulls
        private var _firsts:Vector.<Agent> = new Vector.<Agent>();
        private var _seconds:Vector.<Agent> = new Vector.<Agent>();

        /**
         * @param land has hulls
         * @param shape the model whose two structures are compared
         * @param collideAs the first kind; the second one is the hull
         */
        public function SameAnswers(land:GreatLand, shape:String, collideAs:String, seed:int)
        {
            _land = land;
            _shape = shape;
            _collideAs = collideAs;
            _random = new SeededRandom(seed);
        }

        private function addAgents(count:int, spread:Number, hierarchical:Number):void
        {
            _firsts.length = _seconds.length = 0;
            for (var i:int = 0; i < count; i++)
            {
                var shape:String = _random.pick([_shape, _shape, _shape, "sphere", "bear"]);
                var places:Array = [];
                for (var k:int = 0; k < 6; k++)
                {
                    places.push(_random.between(-spread, spread), _random.between(0, 360));
                }
                var isTree:Boolean = _random.chance(hierarchical);
                for each (var list:Vector.<Agent> in [_firsts, _seconds])
                {
                    var agent:Agent = new Agent(shape, i % 2 == 0 ? "even" : "odd");
                    agent.collideAs = shape != _shape ? Agent.TIGHTEST : list == _firsts ? _collideAs : Agent.HULL;
                    agent.hierarchical = isTree && shape != _shape;
                    agent.moveTo(places[0], places[2], places[4]);
                    agent.heading = places[1];
                    agent.pitch = i % 3 == 0 ? places[3] : 0;
                    agent.roll = i % 3 == 0 ? places[5] : 0;
                    agent.size = 1 + (places[7] / 360);
                    list.push(agent);
                }
            }
        }

        private function systems():Array
        {
            var exact:CombinationCollider = new CombinationCollider(_land);
            exact.exact = true;
            return [new TightestFitCollider(_land), new CombinationCollider(_land), exact];
        }

        private static function indices(found:Vector.<Agent>, of:Vector.<Agent>):String
        {
            var list:Array = [];
            for each (var agent:Agent in found)
            {
                list.push(of.indexOf(agent));
            }
            return list.join();
        }

        private static function assertNear(name:String, expected:Number, actual:Number, tolerance:Number = NEAR):void
        {
            assertTrue(name + ": " + actual + " instead of " + expected, expected == actual || Math.abs(expected - actual) <= tolerance);
        }

        public function framesFindTheSamePairs():void
        {
            var pairs:int = 0;
            for each (var system:CollisionSystem in systems())
            {
                for (var i:int = 0; i < Effort.choose(4, 40); i++)
                {
                    addAgents(60, 4, 0.4);
                    var expected:Vector.<Agent> = system.findCollisions(_firsts).concat();
                    var found:Vector.<Agent> = system.findCollisions(_seconds);
                    assertEquals(system + "", indices(expected, _firsts), indices(found, _seconds));
                    pairs += found.length / 2;
                    assertTrue(system.statistics.hullTests > 0);
                }
            }
            assertTrue(pairs + "", pairs > 200);
        }

        public function contactsAreAsDeep():void
        {
            var compared:int = 0;
            for each (var system:Collider in systems())
            {
                addAgents(80, 3.5, 0.4);
                var found:Vector.<Agent> = system.findCollisions(_firsts).concat();
                for (var i:int = 0; i < found.length; i += 2)
                {
                    var a:int = _firsts.indexOf(found[i]);
                    var b:int = _firsts.indexOf(found[i + 1]);
                    var expected:Contact = system.contactOf(_firsts[a], _firsts[b], new Contact());
                    var contact:Contact = system.contactOf(_seconds[a], _seconds[b], new Contact());
                    assertNear(system + ", " + _seconds[a] + ", " + _seconds[b] + ", depth", expected.depth, contact.depth, 1e-8);
                    compared++;
                }
            }
            assertTrue(compared + "", compared > 100);
        }

        public function sweepsTouchAtTheSameTime():void
        {
            var touched:int = 0;
            for (var round:int = 0; round < 9; round++)
            {
                addAgents(30, 5, 0.3);
                var system:CollisionSystem = systems()[round % 3];
                var expected:Array = sweptTimes(system, _firsts, round);
                var found:Array = sweptTimes(systems()[round % 3], _seconds, round);
                assertEquals(expected.length, found.length);
                for (var i:int = 0; i < expected.length; i += 2)
                {
                    assertEquals(system + "", expected[i], found[i]);
                    assertNear(system + ", " + expected[i], expected[i + 1], found[i + 1]);
                    touched += expected[i + 1] < 1 ? 1 : 0;
                }
            }
            assertTrue(touched + "", touched > 60);
        }

        private static function sweptTimes(system:CollisionSystem, agents:Vector.<Agent>, seed:int):Array
        {
            var random:SeededRandom = new SeededRandom(seed + 1);
            var collision:Collision = new Collision(system);
            var times:Object = {};
            collision.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, function(a:Agent, b:Agent, contact:Contact):void
                {
                    times[Math.min(agents.indexOf(a), agents.indexOf(b)) + "-" + Math.max(agents.indexOf(a), agents.indexOf(b))] = contact.time;
                });
            for each (var agent:Agent in agents)
            {
                agent.sweeps = true;
            }
            collision.update(agents);
            for each (agent in agents)
            {
                agent.moveTo(agent.x + random.between(-3, 3), agent.y + random.between(-3, 3), agent.z + random.between(-3, 3));
            }
            times = {};
            collision.update(agents);
            var list:Array = [];
            for (var key:String in times)
            {
                list.push(key);
            }
            list.sort();
            var result:Array = [];
            for each (key in list)
            {
                result.push(key, times[key]);
            }
            return result;
        }

        public function questionsHaveTheSameAnswers():void
        {
            for each (var system:CollisionSystem in systems())
            {
                for (var round:int = 0; round < Effort.choose(3, 30); round++)
                {
                    addAgents(40, 5, 0.3);
                    var box:AgentQueries = new AgentQueries(system);
                    var hull:AgentQueries = new AgentQueries(system);
                    box.update(_firsts);
                    hull.update(_seconds);
                    compareQuestions(system + ", round " + round, box, hull);
                }
            }
        }

        private function compareQuestions(name:String, box:AgentQueries, hull:AgentQueries):void
        {
            var hits:int = 0;
            var first:BoundingStructure = _collideAs == Agent.BOX ? _land.boundingStructures.box(_shape) : _land.boundingStructures.capsule(_shape);
            var second:BoundingStructure = _land.boundingStructures.hull(_shape);
            for (var i:int = 0; i < 20; i++)
            {
                var from:Vector3D = new Vector3D(_random.between(-7, 7), _random.between(-7, 7), _random.between(-7, 7));
                var to:Vector3D = new Vector3D(_random.between(-4, 4), _random.between(-4, 4), _random.between(-4, 4)).subtract(from);
                var a:RayHit = box.cast(from, to);
                var b:RayHit = hull.cast(from, to);
                assertEquals(name + ", ray", a == null, b == null);
                if (a != null)
                {
                    hits++;
                    assertEquals(name, _firsts.indexOf(a.agent), _seconds.indexOf(b.agent));
                    assertNear(name + ", ray", a.distance, b.distance);
                }
                var x:Agent = _firsts[i];
                var y:Agent = _firsts[(i + 7) % _firsts.length];
                assertNear(name + ", distance", box.distance(x, y), hull.distance(_seconds[i], _seconds[(i + 7) % _seconds.length]));
                assertNear(name + ", point", box.distanceToPoint(x, from), hull.distanceToPoint(_seconds[i], from));
                assertEquals(name + ", touching", indices(box.touching(x), _firsts), indices(hull.touching(_seconds[i]), _seconds));
                assertEquals(name, indices(box.overlapping(first.clone().translate(from)), _firsts),
                        indices(hull.overlapping(second.clone().translate(from)), _seconds));
                compareShapes(name, box.castShape(first.clone().translate(from), to.x, to.y, to.z),
                        hull.castShape(second.clone().translate(from), to.x, to.y, to.z));
                compareShapes(name, box.castAgent(x, to.x, to.y, to.z), hull.castAgent(_seconds[i], to.x, to.y, to.z));
            }
            assertTrue(name + ", " + hits + " rays", hits > 3);
        }

        private function compareShapes(name:String, a:ShapeHit, b:ShapeHit):void
        {
            assertEquals(name, a == null, b == null);
            if (a != null)
            {
                assertEquals(name, _firsts.indexOf(a.agent), _seconds.indexOf(b.agent));
                assertNear(name + ", time", a.time, b.time);
            }
        }

        public function motionsEndInTheSamePlace():void
        {
            var stopped:int = 0;
            for each (var system:CollisionSystem in systems())
            {
                addAgents(40, 4, 0.3);
                var box:AgentQueries = new AgentQueries(system);
                var hull:AgentQueries = new AgentQueries(system);
                box.update(_firsts);
                hull.update(_seconds);
                for (var i:int = 0; i < 30; i++)
                {
                    var way:Vector3D = new Vector3D(_random.between(-3, 3), _random.between(-3, 3), _random.between(-3, 3));
                    var went:Number = box.moveUntilTouch(_firsts[i], way.x, way.y, way.z);
                    assertNear(system + ", " + i, went, hull.moveUntilTouch(_seconds[i], way.x, way.y, way.z), 1e-8);
                    stopped += went < 1 ? 1 : 0;
                    // so that small differences do not add up
                    _seconds[i].moveTo(_firsts[i].x, _firsts[i].y, _firsts[i].z);
                    hull.moved(_seconds[i]);
                }
            }
            assertTrue(stopped + "", stopped > 20);
        }

        public function theGroundAndTheEdgesAreMet():void
        {
            var touched:int = 0;
            for (var round:int = 0; round < 6; round++)
            {
                addAgents(30, 6, 0.2);
                var system:Collider = systems()[round >> 1];
                var expected:Array = groundCalls(system, _firsts, round % 2 == 0);
                var found:Array = groundCalls(systems()[round >> 1], _seconds, round % 2 == 0);
                assertEquals(system + "", expected.join(), found.join());
                touched += found.length;
            }
            assertTrue(touched + "", touched > 50);
        }

        // Who touches the ground or the edges. Moved out by the contact, it does not.
        private static function groundCalls(system:Collider, agents:Vector.<Agent>, isBlocky:Boolean):Array
        {
            var random:SeededRandom = new SeededRandom(5);
            var collision:Collision = new Collision(system);
            var terrain:Terrain = new Terrain(15, 15, 1, -7, -7);
            terrain.isBlocky = isBlocky;
            for (var column:int = 0; column < 15; column++)
            {
                for (var row:int = 0; row < 15; row++)
                {
                    terrain.setHeight(column, row, random.between(-2, 1));
                }
            }
            collision.terrain = terrain;
            collision.bounds = new WorldBounds(-5, -5, -5, 5, 5, 5);
            var calls:Array = [];
            for each (var world:String in [Collision.TERRAIN, Collision.EDGE])
            {
                collision.onCollision(Collision.ANY_BREED, world, function(a:Agent, b:Agent, contact:Contact):void
                    {
                        calls.push(agents.indexOf(a) + " " + b.breed);
                        var out:Number = contact.depth + 1e-8;
                        var moved:Agent = a.collideAs == Agent.HULL && b === terrain.agent ? copyOf(a, contact, out) : null;
                        assertFalse(a + " is out of the ground", moved != null && system.areColliding(moved, b));
                    });
            }
            collision.update(agents);
            return calls;
        }

        private static function copyOf(agent:Agent, contact:Contact, by:Number):Agent
        {
            var copy:Agent = new Agent(agent.shape, agent.breed);
            copy.collideAs = agent.collideAs;
            copy.heading = agent.heading;
            copy.pitch = agent.pitch;
            copy.roll = agent.roll;
            copy.size = agent.size;
            copy.moveTo(agent.x + by * contact.normal.x, agent.y + by * contact.normal.y, agent.z + by * contact.normal.z);
            return copy;
        }

        public function walksGoTheSameWay():void
        {
            var stood:int = 0;
            for each (var system:CollisionSystem in systems())
            {
                addAgents(50, 5, 0);
                var walkers:Array = [];
                for each (var list:Vector.<Agent> in [_firsts, _seconds])
                {
                    for (var k:int = 0; k < list.length; k++)
                    {
                        // none overlaps another
                        list[k].pitch = list[k].roll = 0;
                        list[k].moveTo(1.7 * (k % 8) - 6, 1.7 * int(k / 8) - 6, 0);
                        list[k].size = 0.3 + 0.2 * (k % 4);
                    }
                    var queries:AgentQueries = new AgentQueries(system);
                    queries.terrain = new Terrain(15, 15, 1, -7, -7);
                    queries.update(list);
                    walkers.push(queries);
                }
                for (var i:int = 0; i < 40; i++)
                {
                    var x:Number = _random.between(-1, 1);
                    var y:Number = _random.between(-1, 1);
                    var expected:Footing = walkers[0].walk(_firsts[i], x, y);
                    var found:Footing = walkers[1].walk(_seconds[i], x, y);
                    assertEquals(system + ", " + i, expected.stands, found.stands);
                    assertNear(system + ", x of " + i, _firsts[i].x, _seconds[i].x, 1e-6);
                    assertNear(system + ", y of " + i, _firsts[i].y, _seconds[i].y, 1e-6);
                    assertNear(system + ", z of " + i, _firsts[i].z, _seconds[i].z, 1e-6);
                    stood += found.stands ? 1 : 0;
                    _seconds[i].moveTo(_firsts[i].x, _firsts[i].y, _firsts[i].z);
                    walkers[1].moved(_seconds[i]);
                }
            }
            assertTrue(stood + "", stood > 60);
        }
    }
}
