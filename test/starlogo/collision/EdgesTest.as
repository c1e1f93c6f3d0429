package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.queries.AgentQueries;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.AgentPieces;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.OwnVectorSystem;
    import support.RandomWorlds;
    import support.SolidModels;
    import support.agentAt;
    import support.assertThrows;
    import support.create;

    use namespace engine;

    /** The edges of the world: when agents touch them, and who is told. test/fuzz puts agents beside them. */
    public class EdgesTest
    {
        private static const SHAPES:Array = ["sphere", "cube", "cylinder", "plank", "hollow", "apart"];
        private static const NEAR:Number = 1e-9;

        private static var sGreatLand:GreatLand;
        private static var sModels:Object;

        private var _random:SeededRandom;
        private var _wrong:Complaints;
        private var _bounds:WorldBounds;
        private var _calls:Array;

        // The extents of the agent that beyondOf() was last asked about.
        private var _least:Vector3D;
        private var _most:Vector3D;

        [BeforeClass]
        public static function makeModels():void
        {
            sGreatLand = new GreatLand();
            sModels = {};
            for each (var model:Model in SolidModels.all().concat(BuiltInModel.cylinder(), SolidModels.of("plank", [[1, 0, 0, 0, false], [0.2, 0.9, 0, 0, false]])))
            {
                sModels[model.name] = model;
                sGreatLand.addModel(model);
            }
        }

        [Before]
        public function begin():void
        {
            _random = new SeededRandom(3808);
            _wrong = new Complaints();
            _calls = [];
        }

        [Test]
        public function whatSweepsTouchesWhenItComesThere():void
        {
            var passing:int = 0;
            var begun:int = 0;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                for (var i:int = Effort.choose(40, 3000); i > 0; i--)
                {
                    _bounds = anyBounds();
                    var agent:Agent = RandomWorlds.mixed(1, SHAPES, 10, _random)[0];
                    agent.sweeps = true;
                    var collision:Collision = makeCollision(name);
                    var way:Vector3D = new Vector3D(_random.between(-9, 9), _random.between(-9, 9), _random.between(-9, 9));
                    agent.moveTo(0.8 * agent.x, 0.8 * agent.y, 0.8 * agent.z);
                    var before:Array = beyondOf(name, agent);
                    collision.update(new <Agent>[agent]);
                    agent.moveTo(agent.x + way.x, agent.y + way.y, agent.z + way.z);
                    _calls = [];
                    collision.update(new <Agent>[agent]);
                    assertTime(name, agent, before, beyondOf(name, agent), way);
                    var contact:Contact = contactWith(agent);
                    if (contact != null)
                    {
                        contact.time == 0 ? begun++ : passing++;
                    }
                }
            }
            _wrong.assertNone();
            assertTrue(passing + " come to an edge, " + begun + " begin there", passing > 30 && begun > 15);
        }

        [Test]
        public function startsAndEndsFromBothSides():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var cube:Agent = new Agent("cube", "cubes");
                var other:Agent = new Agent("cube", "others");
                var agents:Vector.<Agent> = new <Agent>[other, cube];
                var collision:Collision = new Collision(EachCollider.make(name, sGreatLand));
                collision.bounds = _bounds = new WorldBounds(-Infinity, -Infinity, -Infinity, 5, Infinity, Infinity);
                _calls = [];
                collision.onCollisionStart("cubes", Collision.EDGE, note("start"));
                collision.onCollisionEnd("cubes", Collision.EDGE, note("end"));
                collision.onCollision(Collision.EDGE, "cubes", note("back"));
                collision.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, note("any"));
                other.x = 20;
                assertCalls(name, collision, agents, "");
                cube.x = 4.5;
                assertCalls(name + ": touching counts", collision, agents, "start back");
                cube.x = 7;
                assertCalls(name, collision, agents, "back");
                cube.breed = "others";
                assertCalls(name, collision, agents, "end");
                cube.breed = "cubes";
                assertCalls(name, collision, agents, "start back");
                collision.bounds = null;
                assertCalls(name, collision, agents, "end");
                collision.bounds = _bounds;
                assertCalls(name, collision, agents, "start back");
                _bounds.setTo(-Infinity, -Infinity, -Infinity, 9, Infinity, Infinity);
                assertCalls(name, collision, agents, "end");
                cube.x = 8.6;
                collision.filter = new NoAgents();
                assertCalls(name, collision, agents, "");
                collision.filter = null;
                assertCalls(name, collision, agents, "start back");
                agents.pop();
                assertCalls(name + ": out of the list", collision, agents, "end");
                assertStrictlyEquals(_bounds.agent, _bounds.agent);
                assertEquals(Collision.EDGE, _bounds.agent.breed);
            }
        }

        [Test]
        public function aColliderTellsOfTheLastFramesEdges():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var collider:Collider = EachCollider.make(name, sGreatLand);
                var collision:Collision = new Collision(collider);
                collision.bounds = new WorldBounds(0, -Infinity, 0, 9, Infinity, 9);
                var cube:Agent = agentAt("cube", 0.25, 0, 3, "cubes");
                collision.update(new <Agent>[cube]);
                assertTrue(name, collider.areColliding(cube, collision.bounds.agent) && collider.areColliding(collision.bounds.agent, cube));
                var contact:Contact = collider.contactOf(cube, collision.bounds.agent);
                assertTrue(name + contact.normal, contact.normal.x == 1 && Math.abs(contact.depth - 0.25) < NEAR && contact.time == 1);
                assertTrue(name + contact.point, Math.abs(contact.point.x + 0.125) < NEAR && Math.abs(contact.point.y) < 0.5 + NEAR);
                assertEquals(name, -1, collider.contactOf(collision.bounds.agent, cube).normal.x);
                var far:Agent = agentAt("cube", 5, 0, 4);
                assertFalse(name, collider.areColliding(far, collision.bounds.agent));
                assertEquals(name + ": nearest", 0, collider.contactOf(far, collision.bounds.agent).depth);
                // it is larger than the world: it cannot get free, and is led to the side where it is less far beyond
                cube.size = 20;
                cube.moveTo(3, 0, 20);
                collision.update(new <Agent>[cube]);
                contact = collider.contactOf(cube, collision.bounds.agent);
                assertTrue(name + contact.normal, contact.normal.x > 0 && contact.depth > 0);
            }
        }

        [Test]
        public function aPointOnEdgesIsLedBackFromAllOfThem():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var collider:Collider = EachCollider.make(name, landOfPoints());
                var bounds:WorldBounds = new WorldBounds(-9, -9, -9, 9, 9, 9);
                var point:Agent = agentAt("point", 9, 2, 0);
                // the sphere of the BinCollider stands on the place
                point.size = 1e-6;
                var contact:Contact = collider.contactOf(point, bounds.agent);
                assertTrue(name + contact.normal, contact.normal.x == -1 && contact.depth <= 1e-6);
                point.moveTo(10, -9, 0);
                contact = collider.contactOf(point, bounds.agent);
                assertTrue(name + contact.normal, contact.normal.x < -0.9 && contact.normal.y > 0 && Math.abs(contact.depth - 1) < 1e-6);
            }
        }

        [Test]
        public function aPointThatGlidesAlongAnEdgeTouchesItFromTheStart():void
        {
            var times:Array = [];
            for each (var name:String in EachCollider.NAMES)
            {
                var collision:Collision = new Collision(EachCollider.make(name, landOfPoints()));
                // no coordinate of the touch is rounded, so it has no tolerance
                collision.bounds = new WorldBounds(-9, -9, -9, 0, 9, 9);
                collision.onCollision("turtles", Collision.EDGE, function(agent:Agent, edge:Agent, contact:Contact):void
                    {
                        times.push(contact.time);
                    });
                var point:Agent = agentAt("point", 0, 2, 0);
                point.sweeps = true;
                point.size = 1e-6;
                collision.update(new <Agent>[point]);
                point.y = 0;
                times = [];
                collision.update(new <Agent>[point]);
                assertEquals(name, "0", times.join());
            }
        }

        [Test]
        public function anEdgeThatIsTouchedAcrossTheGapForRoundingCountsInACorner():void
        {
            var alone:WorldBounds = new WorldBounds(-9, -9, -9, Infinity, 9, 9);
            var corner:WorldBounds = new WorldBounds(-9, -9, -9, 9, 9, 9);
            for each (var name:String in EachCollider.NAMES)
            {
                var collider:Collider = EachCollider.make(name, sGreatLand);
                var cube:Agent = agentAt("cube", 8.7, 0, 0);
                // where it begins to touch the edge at its side
                var free:Number = 8.4;
                var touching:Number = 8.5;
                for (var i:int = 0; i < 60; i++)
                {
                    cube.y = (free + touching) / 2;
                    collider.areColliding(cube, alone.agent) ? touching = cube.y : free = cube.y;
                }
                assertTrue(name + touching, touching < 8.5 && touching > 8.499);
                cube.y = (touching + 8.5) / 2;
                var contact:Contact = collider.contactOf(cube, corner.agent);
                assertTrue(name + contact.normal, contact.normal.x < -0.9 && contact.normal.y < 0 && Math.abs(contact.depth - 0.2) < 1e-6);
                assertTrue(name + contact.point, Math.abs(contact.point.x - 9.1) < 1e-6 && Math.abs(contact.point.y - 9) < 1e-6);
            }
        }

        [Test]
        public function farOutOneContactLeadsAwayFromAnEdgeThatItOnlyTouches():void
        {
            for each (var far:Number in [1e4, 1e6, 1e8])
            {
                for each (var size:Number in [1e-2, 1])
                {
                    var agent:Agent = agentAt("sphere", far + 0.1 * size, far + 0.5 * size, 0);
                    agent.size = size;
                    var collider:BinCollider = new BinCollider();
                    var edges:Agent = new WorldBounds(far, far, -Infinity, Infinity, Infinity, Infinity).agent;
                    var contact:Contact = collider.contactOf(agent, edges);
                    var way:Number = contact.depth + 4 * Math.max(1e-9 * size, 1.2e-15 * far);
                    agent.moveTo(agent.x + way * contact.normal.x, agent.y + way * contact.normal.y, 0);
                    assertFalse("of size " + size + " at " + far, collider.areColliding(agent, edges));
                }
            }
        }

        private static function landOfPoints():GreatLand
        {
            var land:GreatLand = new GreatLand();
            land.loadAllBoundingStructures = true;
            land.addModel(new Model("point", new <Number>[0, 0, 0]));
            return land;
        }

        [Test]
        public function questionsTakeTheEdgesAsAnAgent():void
        {
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                var collider:Collider = EachCollider.make(name, sGreatLand);
                var bounds:WorldBounds = new WorldBounds(-9, -9, -9, 9, 9, Infinity);
                var inside:Agent = agentAt("cube", 6, 2, 0);
                var outside:Agent = agentAt("cube", 0, -9, 0);
                var queries:AgentQueries = new AgentQueries(collider);
                queries.terrain = new Terrain(3, 3, 1, -1, -1);
                queries.update(new <Agent>[inside, outside]);
                assertTrue(name + ": in no frame", collider.areColliding(outside, bounds.agent) && !collider.areColliding(inside, bounds.agent));
                assertTrue(name, queries.touchesEdge(outside, bounds) && !queries.touchesEdge(inside, bounds));
                assertEquals(name, outside, queries.touching(bounds.agent).join());
                assertFalse(name, queries.touchesEdge(queries.terrain.agent, bounds) || collider.areColliding(bounds.agent, queries.terrain.agent));
                var from:Vector3D = new Vector3D();
                var to:Vector3D = new Vector3D();
                assertEquals(name, 0, queries.distance(outside, bounds.agent));
                assertTrue(name, Math.abs(queries.distance(inside, bounds.agent, from, to) - 2.5) < NEAR);
                assertTrue(name + from + to, Math.abs(from.x - 6.5) < NEAR && Math.abs(to.x - 9) < NEAR && Math.abs(from.y - 2) < 0.5 + NEAR && from.y == to.y);
                assertTrue(name, Math.abs(queries.distance(bounds.agent, inside, from, to) - 2.5) < NEAR && Math.abs(from.x - 9) < NEAR);
                bounds.setTo(-Infinity, -Infinity, -Infinity, Infinity, Infinity, Infinity);
                assertEquals(name, Infinity, queries.distance(inside, bounds.agent, from, to));
                assertTrue(name + ": no point is written", from.x == 9 && Math.abs(to.x - 6.5) < NEAR);
                assertThrows(ArgumentError, /does not move/, queries.moveUntilTouch, bounds.agent, 1, 0, 0);
            }
        }

        [Test]
        public function loadingAgentsAreCountedAmongTrees():void
        {
            sGreatLand.expect("later");
            for each (var name:String in ["hierarchies", "triangles", "combinations"])
            {
                var collision:Collision = new Collision(EachCollider.make(name, sGreatLand));
                collision.bounds = new WorldBounds(-5, -5, -5, 5, 5, 5);
                collision.onCollision("turtles", Collision.EDGE, note("edge"));
                var agents:Vector.<Agent> = new <Agent>[agentAt("apart", 4.9, 0, 0), agentAt("later", 0, 0, 0), agentAt("cube", 0, 0, 0, "others")];
                agents[0].hierarchical = true;
                for (var frame:int = 0; frame < 2; frame++)
                {
                    collision.update(agents);
                    assertEquals(name, "1 1", collision.statistics.agentsLoading + " " + collision.statistics.agentsSkipped);
                }
            }
            sGreatLand.expectNoMore("later");
        }

        [Test]
        public function snapshotsKnowWhatTouchesTheEdges():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var cube:Agent = new Agent("cube", "cubes");
                cube.x = 9;
                var collision:Collision = new Collision(EachCollider.make(name, sGreatLand));
                collision.bounds = new WorldBounds(-9, -9, -9, 9, 9, 9);
                collision.onCollisionStart("cubes", Collision.EDGE, note("start"));
                collision.onCollisionEnd("cubes", Collision.EDGE, note("end"));
                var agents:Vector.<Agent> = new <Agent>[new Agent("cube", "others"), cube];
                assertCalls(name, collision, agents, "start");
                var bytes:ByteArray = collision.snapshot();
                cube.x = 0;
                assertCalls(name, collision, agents, "end");
                var bounds:WorldBounds = collision.bounds;
                collision.bounds = null;
                assertThrows(ArgumentError, /a Collision without bounds/, collision.restore, bytes, agents);
                collision.bounds = bounds;
                assertCalls(name, collision, agents, "");
                cube.x = 9;
                collision.restore(bytes, agents);
                assertCalls(name + ": it goes on touching", collision, agents, "");
                cube.x = 0;
                assertCalls(name, collision, agents, "end");
            }
        }

        [Test]
        public function whatIsRefusedChangesNothing():void
        {
            assertThrows(RangeError, /least and the greatest x of the world must be numbers, not NaN and 1$/, create, WorldBounds, NaN, 0, 0, 1, 1, 1);
            assertThrows(RangeError, /greatest y of the world must have a place between them, not 2 and 1$/, create, WorldBounds, 0, 2, 0, 1, 1, 1);
            assertThrows(RangeError, /greatest x .*not Infinity and Infinity$/, create, WorldBounds, Infinity, 0, 0, Infinity, 1, 1);
            assertThrows(RangeError, /greatest z .*not -Infinity and -Infinity$/, create, WorldBounds, 0, 0, -Infinity, 1, 1, -Infinity);
            assertThrows(RangeError, /edges of the world must be a finite number between -1000000000 and 1000000000, not 2000000000/, create, WorldBounds, 0, 0, 0, 1, 2e9, 1);
            var bounds:WorldBounds = new WorldBounds(-1, -2, -3, 1, 2, Infinity);
            assertThrows(RangeError, /greatest z .*numbers, not 0 and NaN$/, bounds.setTo, 0, 0, 0, 1, 1, NaN);
            assertEquals("-1,-2,-3,1,2,Infinity", [bounds.minX, bounds.minY, bounds.minZ, bounds.maxX, bounds.maxY, bounds.maxZ].join());
            var collision:Collision = new Collision(new BinCollider());
            assertThrows(ArgumentError, /agents\[0\].*edges of the world/, collision.update, new <Agent>[bounds.agent]);
            assertThrows(ArgumentError, /breed/, create, Agent, "cube", Collision.EDGE);
            collision = new Collision(new OwnVectorSystem(new <Agent>[]));
            collision.bounds = bounds;
            assertThrows(IllegalOperationError, /bounds need one of the engine's collision systems/, collision.update, new <Agent>[]);
        }

        private function note(name:String):Function
        {
            return function(a:Agent, b:Agent):void
            {
                _calls.push(name);
            };
        }

        private function assertCalls(message:String, collision:Collision, agents:Vector.<Agent>, expected:String):void
        {
            _calls = [];
            collision.update(agents);
            assertEquals(message, expected, _calls.join(" "));
        }

        private function makeCollision(name:String):Collision
        {
            var collision:Collision = new Collision(EachCollider.make(name, sGreatLand));
            collision.bounds = _bounds;
            collision.onCollision("turtles", Collision.EDGE, function(agent:Agent, edge:Agent, contact:Contact):void
                {
                    var copy:Contact = new Contact();
                    copy.time = contact.time;
                    copy.depth = contact.depth;
                    copy.approachSpeed = contact.approachSpeed;
                    copy.normal.copyFrom(contact.normal);
                    copy.point.copyFrom(contact.point);
                    assertStrictlyEquals(_bounds.agent, edge);
                    _calls.push([agent, copy]);
                });
            _calls = [];
            return collision;
        }

        private function contactWith(agent:Agent):Contact
        {
            for each (var call:Array in _calls)
            {
                if (call[0] == agent)
                {
                    return call[1];
                }
            }
            return null;
        }

        private function assertTime(name:String, agent:Agent, before:Array, after:Array, way:Vector3D):void
        {
            var time:Number = Infinity;
            for (var edge:int = 0; edge < 6; edge++)
            {
                if (before[edge] >= 0)
                {
                    time = 0;
                }
                else if (after[edge] >= 0)
                {
                    time = Math.min(time, before[edge] / (before[edge] - after[edge]));
                }
            }
            var contact:Contact = contactWith(agent);
            var message:String = time + ", " + (contact == null ? "none" : contact.time + ", normal " + contact.normal + ", depth " + contact.depth) + ": " + agent;
            if (time <= 1 != (contact != null) || contact != null && Math.abs(contact.time - time) > NEAR)
            {
                _wrong.add(name + ": time", message);
            }
            else if (contact != null && Math.abs(contact.approachSpeed - Math.max(0, -way.dotProduct(contact.normal))) > NEAR)
            {
                _wrong.add(name + ": speed", contact.approachSpeed + ": " + message);
            }
            else if (contact != null && time > 0 && contact.depth > NEAR)
            {
                _wrong.add(name + ": depth", message);
            }
            else if (contact != null && !isWithinExtents(contact.point, way, 1 - contact.time))
            {
                _wrong.add(name + ": point", contact.point + ": " + message);
            }
        }

        // Whether a point is in the extents as they were when a part of the way was left, or between them and an edge that they are wholly beyond.
        private function isWithinExtents(point:Vector3D, way:Vector3D, left:Number):Boolean
        {
            return isWithin(point.x, left * way.x, _least.x, _most.x, _bounds.minX, _bounds.maxX)
                && isWithin(point.y, left * way.y, _least.y, _most.y, _bounds.minY, _bounds.maxY)
                && isWithin(point.z, left * way.z, _least.z, _most.z, _bounds.minZ, _bounds.maxZ);
        }

        private static function isWithin(coordinate:Number, left:Number, least:Number, most:Number, minEdge:Number, maxEdge:Number):Boolean
        {
            return coordinate >= Math.min(least - left, maxEdge) - NEAR && coordinate <= Math.max(most - left, minEdge) + NEAR;
        }

        // How far an agent reaches beyond each edge, by all points of its shape.
        private function beyondOf(name:String, agent:Agent):Array
        {
            var least:Vector3D = new Vector3D(Infinity, Infinity, Infinity);
            var most:Vector3D = new Vector3D(-Infinity, -Infinity, -Infinity);
            for each (var piece:Object in AgentPieces.of(name, agent, sGreatLand, sModels[agent.shape]))
            {
                var radius:Number = piece.radius;
                for (var i:int = 0; i < piece.points.length; i += 3)
                {
                    var x:Number = piece.points[i];
                    var y:Number = piece.points[i + 1];
                    var z:Number = piece.points[i + 2];
                    least.setTo(Math.min(least.x, x - radius), Math.min(least.y, y - radius), Math.min(least.z, z - radius));
                    most.setTo(Math.max(most.x, x + radius), Math.max(most.y, y + radius), Math.max(most.z, z + radius));
                }
            }
            _least = least;
            _most = most;
            return [_bounds.minX - least.x, most.x - _bounds.maxX, _bounds.minY - least.y, most.y - _bounds.maxY, _bounds.minZ - least.z, most.z - _bounds.maxZ];
        }

        private function anyBounds():WorldBounds
        {
            var size:Number = _random.pick([6, 9, 12]);
            return new WorldBounds(_random.chance(0.2) ? -Infinity : -size, _random.chance(0.2) ? -Infinity : -size, _random.chance(0.5) ? -Infinity : -size,
                    _random.chance(0.2) ? Infinity : size, _random.chance(0.2) ? Infinity : size + 1, _random.chance(0.5) ? Infinity : size);
        }
    }
}

import starlogo.agents.Agent;
import starlogo.agents.AgentPredicate;

class NoAgents extends AgentPredicate
{
    override public function admits(agent:Agent):Boolean
    {
        return false;
    }
}
