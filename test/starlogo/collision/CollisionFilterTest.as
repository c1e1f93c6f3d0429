package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import flash.errors.IllegalOperationError;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.diagnostics.CollisionRecorder;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentFilter;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.EachCollider;
    import support.RandomWorlds;
    import support.agentAt;
    import support.assertThrows;
    import support.landOf;

    /** A Collision with a filter is one of a list without the agents that it excludes. */
    public class CollisionFilterTest
    {
        private static const BREEDS:Array = ["turtles", "wolves", "sheep"];

        private var _greatLand:GreatLand = landOf(BuiltInModel.cube());
        private var _calls:Array;

        [Test]
        public function excludedAgentsAreAsNotListed():void
        {
            var random:SeededRandom = new SeededRandom(2210);
            var called:int = 0;
            for each (var name:String in EachCollider.NAMES.concat("own"))
            {
                for each (var kind:String in ["scattered", "mixed sizes", "clusters"])
                {
                    var agents:Vector.<Agent> = RandomWorlds.make(kind, 60, "cube", random);
                    for each (var agent:Agent in agents)
                    {
                        agent.breed = random.pick(BREEDS);
                        agent.sweeps = random.chance(0.1);
                    }
                    var filtered:Collision = collisionNamed(name);
                    var filter:AgentFilter = new AgentFilter();
                    filter.exceptBreeds = new <String>["wolves"];
                    filter.except = new <Agent>[agents[0], agents[1]];
                    filter.accepts = function(agent:Agent):Boolean
                    {
                        return agent.id % 5 > 0;
                    };
                    filtered.filter = filter;
                    _calls = [];
                    filtered.update(agents);
                    var found:String = _calls.join();
                    called += _calls.length;
                    var left:Vector.<Agent> = new Vector.<Agent>();
                    for each (agent in agents)
                    {
                        if (filter.admits(agent))
                        {
                            left.push(agent);
                        }
                    }
                    var plain:Collision = collisionNamed(name);
                    _calls = [];
                    plain.update(left);
                    assertEquals(name + ", " + kind, _calls.join(), found);
                    assertTrue("agents were left out", left.length < agents.length - 5);
                    assertEquals(name + ", candidates", plain.statistics.candidatePairs, filtered.statistics.candidatePairs);
                    assertEquals(name + ", skipped", agents.length - left.length, filtered.statistics.agentsSkipped);
                }
            }
            assertTrue(called + " calls", called > 100);
        }

        // The motion of an agent that was excluded begins where the last frame saw it, also with a system around the collider.
        [Test]
        public function motionsGoOnAfterAnExclusion():void
        {
            var random:SeededRandom = new SeededRandom(2211);
            var agents:Vector.<Agent> = RandomWorlds.make("scattered", 30, "cube", random);
            var collider:Function = EachCollider.make;
            var systems:Array = [collider("bins", _greatLand), new BaseCollider(collider("bins", _greatLand)),
                    new BaseCollider(new CollisionRecorder(new BaseCollider(collider("bins", _greatLand)))), new CopyingSystem(_greatLand)];
            var excluded:Array = [];
            var filter:AgentFilter = new AgentFilter();
            filter.accepts = function(agent:Agent):Boolean
            {
                return !excluded[agent.id];
            };
            var collisions:Array = systems.map(function(system:CollisionSystem, ...ignored):Collision
                {
                    return collisionOf(system);
                });
            var called:int = 0;
            for (var frame:int = 0; frame < 60; frame++)
            {
                for each (var agent:Agent in agents)
                {
                    agent.sweeps = agent.sweeps || random.chance(0.2);
                    excluded[agent.id] = random.chance(0.3);
                    agent.moveTo(agent.x + random.between(-4, 4), agent.y + random.between(-4, 4), agent.z);
                }
                var expected:String = null;
                for (var i:int = 0; i < systems.length; i++)
                {
                    collisions[i].filter = filter;
                    _calls = [];
                    collisions[i].update(agents);
                    expected ||= _calls.join();
                    assertEquals("system " + i + ", frame " + frame, expected, _calls.join());
                    assertEquals("skipped", collisions[0].statistics.agentsSkipped, collisions[i].statistics.agentsSkipped);
                }
                called += _calls.length;
            }
            assertTrue(called + " calls", called > 100);
        }

        [Test]
        public function aFilterThatThrowsEndsTheFrameBeforeAnything():void
        {
            var agents:Vector.<Agent> = new <Agent>[new Agent("cube"), new Agent("cube")];
            var collision:Collision = collisionNamed("tightest fits");
            var filter:AgentFilter = new AgentFilter();
            collision.filter = filter;
            _calls = [];
            filter.accepts = function(agent:Agent):Boolean
            {
                throw new RangeError("no");
            };
            assertThrows(RangeError, /no/, collision.update, agents);
            filter.accepts = function(agent:Agent):Boolean
            {
                collision.update(agents);
                return true;
            };
            assertThrows(IllegalOperationError, /filter/, collision.update, agents);
            assertEquals(0, _calls.length);
            filter.accepts = null;
            collision.update(agents);
            assertEquals(2, _calls.length);
            agents[1] = null;
            assertThrows(ArgumentError, /null/, collision.update, agents);
        }

        [Test]
        public function theGroundAndTheEdgesThatItExchangesCountFromTheNextFrameOn():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var agent:Agent = agentAt("cube", 0, 0, 0.5);
                var grounds:Array = [groundAt(-1), groundAt(1), null];
                var worlds:Array = [new WorldBounds(0, -9, -9, 9, 9, 9), null, new WorldBounds(-9, -9, 0.5, 9, 9, 9)];
                var collision:Collision = new Collision(EachCollider.make(name, _greatLand));
                var frame:int = 0;
                var filter:AgentFilter = new AgentFilter();
                filter.accepts = function(agent:Agent):Boolean
                {
                    frame++;
                    collision.terrain = grounds[frame % 3];
                    collision.bounds = worlds[frame % 3];
                    return true;
                };
                collision.terrain = grounds[0];
                collision.bounds = worlds[0];
                collision.filter = filter;
                _calls = [];
                for each (var breed:String in [Collision.TERRAIN, Collision.EDGE])
                {
                    collision.onCollision("turtles", breed, function(collider:Agent, collidee:Agent, contact:Contact):void
                        {
                            _calls.push(frame + (collidee.breed == Collision.TERRAIN ? " ground " : " edge ") + contact.depth.toFixed(1));
                        });
                }
                var expected:Array = ["1 edge 0.5", "2 ground 0.5", "3 edge 0.0", "4 edge 0.5", "5 ground 0.5", "6 edge 0.0"];
                for (var i:int = 0; i < 6; i++)
                {
                    collision.update(new <Agent>[agent]);
                }
                assertEquals(name, expected.join(), _calls.join());
            }
        }

        private static function groundAt(height:Number):Terrain
        {
            var ground:Terrain = new Terrain(5, 5, 1, -2, -2);
            for (var column:int = 0; column < 5; column++)
            {
                for (var row:int = 0; row < 5; row++)
                {
                    ground.setHeight(column, row, height);
                }
            }
            return ground;
        }

        private function collisionNamed(name:String):Collision
        {
            return collisionOf(name == "own" ? new OwnSystem(_greatLand) : EachCollider.make(name, _greatLand));
        }

        private function collisionOf(system:CollisionSystem):Collision
        {
            var collision:Collision = new Collision(system);
            var calls:Function = function(collider:Agent, collidee:Agent):void
            {
                _calls.push(collider.id + "-" + collidee.id);
            };
            collision.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, calls);
            return collision;
        }
    }
}

import starlogo.GreatLand;
import starlogo.agents.Agent;
import starlogo.collision.BaseCollider;
import starlogo.collision.BinCollider;
import starlogo.collision.CollisionStatistics;
import starlogo.collision.CollisionSystem;
import starlogo.collision.TightestFitCollider;

class OwnSystem implements CollisionSystem
{
    private var _system:TightestFitCollider;

    public function OwnSystem(greatLand:GreatLand)
    {
        _system = new TightestFitCollider(greatLand);
    }

    public function get statistics():CollisionStatistics
    {
        return _system.statistics;
    }

    public function areColliding(a:Agent, b:Agent):Boolean
    {
        return _system.areColliding(a, b);
    }

    public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
    {
        return _system.findCollisions(agents, out);
    }
}

/** Passes a copy of the list on. */
class CopyingSystem extends BaseCollider
{
    public function CopyingSystem(greatLand:GreatLand)
    {
        super(new BinCollider(greatLand));
    }

    override public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
    {
        return super.findCollisions(agents.concat(), out);
    }
}
