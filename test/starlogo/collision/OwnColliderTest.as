package starlogo.collision
{
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.diagnostics.CollisionRecorder;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;
    import support.agentAt;
    import support.assertThrows;

    /** A collider belongs to one Collision, because it keeps where that one's frames have seen the agents. */
    public class OwnColliderTest
    {
        private static const TAKEN:RegExp = /belongs to another Collision.*a collider of its own/;

        private var _ball:Agent;
        private var _wall:Agent;
        private var _agents:Vector.<Agent>;
        private var _hits:int;

        [Before]
        public function makeGame():void
        {
            _ball = agentAt("sphere", 0, 0, 0, "balls");
            _ball.sweeps = true;
            _wall = agentAt("sphere", 5, 0, 0, "walls");
            _agents = new <Agent>[_ball, _wall];
            _hits = 0;
        }

        [Test]
        public function aSecondCollisionIsRefused():void
        {
            var collider:Collider = new BinCollider();
            var first:Collision = new Collision(collider);
            var second:Collision = new Collision(new BinCollider());
            for each (var system:CollisionSystem in [collider, new CollisionRecorder(collider), new BaseCollider(new CollisionRecorder(collider))])
            {
                assertThrows(ArgumentError, TAKEN, make, system);
                var before:CollisionSystem = second.collisionSystem;
                assertThrows(ArgumentError, TAKEN, exchange, second, system);
                assertTrue(second.collisionSystem === before);
            }
            exchange(first, new BinCollider());
            exchange(second, collider);
            assertThrows(ArgumentError, TAKEN, exchange, first, collider);
        }

        [Test]
        public function anExchangeReleasesItUnlessItGoesOn():void
        {
            var collider:Collider = new BinCollider();
            var collision:Collision = watched(collider);
            exchange(collision, new CollisionRecorder(collider));
            assertThrows(ArgumentError, TAKEN, make, collider);
            collision.update(_agents);
            exchange(collision, collider);
            _ball.moveTo(10, 0, 0);
            collision.update(_agents);
            assertEquals("a recorder around it forgets no motion", 1, _hits);
            exchange(collision, new BinCollider());
            make(collider);
        }

        [Test]
        public function aHandlersExchangeReleasesItAfterTheFrame():void
        {
            var collider:Collider = new BinCollider();
            var between:Collider = new BinCollider();
            var collision:Collision = new Collision(collider);
            _ball.moveTo(4.5, 0, 0);
            collision.onCollision("balls", "walls", function(ball:Agent, wall:Agent):void
                {
                    exchange(collision, between);
                    exchange(collision, new BinCollider());
                    make(between);
                    assertThrows(ArgumentError, TAKEN, make, collider);
                    _hits++;
                });
            collision.update(_agents);
            assertEquals(1, _hits);
            make(collider);
        }

        [Test]
        public function resetInAHandlerForgetsTheMotionsOfTheFrame():void
        {
            for each (var isExchanged:Boolean in [false, true])
            {
                makeGame();
                var collider:Collider = new BinCollider();
                var collision:Collision = new Collision(collider);
                _agents.push(agentAt("sphere", 5.2, 0, 0, "others"));
                collision.onCollision("walls", "others", function(wall:Agent, other:Agent):void
                    {
                        exchange(collision, isExchanged ? new BinCollider() : collider);
                        collision.reset();
                        exchange(collision, collider);
                        _hits++;
                    });
                collision.update(_agents);
                collision.onCollision("balls", "walls", function(ball:Agent, wall:Agent):void
                    {
                        _hits++;
                    });
                _ball.moveTo(10, 0, 0);
                collision.update(_agents);
                assertEquals(isExchanged + ": the ball begins there", 1, _hits);
            }
        }

        /** Who has counted decides, not how many agents it says there are. */
        [Test]
        public function whoIsNotAskedAboutIsSkipped():void
        {
            for each (var said:int in [1, 2])
            {
                var system:SayingSystem = new SayingSystem(said);
                var collision:Collision = new Collision(system);
                collision.filter = AgentFilter.ofBreeds("balls");
                collision.update(_agents);
                assertEquals("2 1", collision.statistics.agents + " " + collision.statistics.agentsSkipped);
            }
        }

        [Test]
        public function aSystemWithoutStatisticsIsNamed():void
        {
            var collision:Collision = new Collision(new UncountedSystem());
            assertThrows(ArgumentError, /statistics of the collision system must not be null/, collision.update, _agents);
        }

        /** A contact has no numbers of another one, and one that is returned counts. */
        [Test]
        public function aContactOfItsOwnIsItsOwn():void
        {
            var depths:Array = [];
            var collision:Collision = new Collision(new DeepBins());
            collision.onCollision("balls", Collision.ANY_BREED, function(ball:Agent, other:Agent, contact:Contact):void
                {
                    depths.push(contact.depth + " " + contact.time);
                });
            for each (var breed:String in ["deep", "plain", "returned"])
            {
                _wall.breed = breed;
                _ball.moveTo(4.5, 0, 0);
                collision.update(_agents);
            }
            assertEquals("5 0.25,0 1,7 1", depths.join());
        }

        [Test]
        public function motionsBeginAnewAfterAnExchange():void
        {
            var collider:Collider = new BinCollider();
            var collision:Collision = watched(collider);
            collision.update(_agents);
            exchange(collision, new BinCollider());
            _ball.moveTo(10, 0, 0);
            collision.update(_agents);
            assertEquals(0, _hits);
            // it has seen the ball at 0
            exchange(collision, collider);
            _ball.moveTo(11, 0, 0);
            collision.update(_agents);
            assertEquals(0, _hits);
            _ball.moveTo(0, 0, 0);
            collision.update(_agents);
            assertEquals(1, _hits);
        }

        [Test]
        public function callsOfTheGameInBetweenChangeNoMotion():void
        {
            for each (var isWrapped:Boolean in [false, true])
            {
                makeGame();
                var collider:Collider = new BinCollider();
                var collision:Collision = watched(isWrapped ? new BaseCollider(collider) : collider);
                collision.update(_agents);
                _ball.moveTo(10, 0, 0);
                assertEquals(0, collider.findCollisions(_agents).length);
                assertEquals(false, collider.areColliding(_ball, _wall));
                if (!isWrapped)
                {
                    var queries:AgentQueries = new AgentQueries(collision);
                    queries.update(_agents);
                    assertEquals(0, queries.touching(_ball).length);
                }
                new AgentQueries(collider).update(_agents);
                collision.update(_agents);
                assertEquals("wrapped: " + isWrapped, 1, _hits);
            }
        }

        [Test]
        public function callsOfHandlersChangeNoContact():void
        {
            var collider:Collider = new BinCollider();
            var collision:Collision = new Collision(collider);
            var times:Array = [];
            collision.onCollision("balls", "walls", function(ball:Agent, wall:Agent, contact:Contact):void
                {
                    ball.moveTo(50, 0, 0);
                    collider.findCollisions(_agents);
                    times.push(contact.time, collider.contactOf(ball, wall).time);
                });
            collision.update(_agents);
            _ball.moveTo(8, 0, 0);
            collision.update(_agents);
            assertEquals(2, times.length);
            assertTrue(times.join(), Math.abs(times[0] - 0.5) < 1e-9 && times[0] == times[1]);
        }

        [Test]
        public function contactsAreThoseOfTheLastSearch():void
        {
            for each (var isWrapped:Boolean in [false, true])
            {
                makeGame();
                _ball.sweeps = false;
                var collider:Collider = new BinCollider();
                var system:BaseCollider = isWrapped ? new BaseCollider(collider) : collider;
                var collision:Collision = new Collision(system);
                collision.onCollision("balls", "walls", hit);
                _ball.moveTo(4.5, 0, 0);
                collision.update(_agents);
                _ball.moveTo(4.25, 0, 0);
                assertDepth("the frame", 0.5, system);
                system.findCollisions(_agents);
                _ball.moveTo(4.75, 0, 0);
                assertDepth("a search of the game", 0.25, system);
                assertThrows(ArgumentError, /twice/, system.findCollisions, new <Agent>[_ball, _ball]);
                assertDepth("a search that threw", 0.25, system);
                system.findCollisions(new <Agent>[_ball]);
                assertDepth("not both were in the search", 0.75, system);
                system.findCollisions(_agents);
                collision.update(_agents);
                _ball.moveTo(4.5, 0, 0);
                assertDepth("the next frame", 0.75, system);
            }
        }

        [Test]
        public function afterAFrameContactsAreItsOwnWhateverHandlersHaveSearched():void
        {
            var collider:Collider = new BinCollider();
            var collision:Collision = new Collision(collider);
            _ball.moveTo(4.5, 0, 0);
            collision.onCollision("balls", "walls", function(ball:Agent, wall:Agent):void
                {
                    ball.moveTo(4.25, 0, 0);
                    assertEquals(1, collider.findCollisions(_agents).length / 2);
                    _hits++;
                });
            collision.update(_agents);
            assertEquals(1, _hits);
            assertDepth("its own", 0.5, collider);
        }

        [Test]
        public function afterRestoreContactsAreThoseOfNow():void
        {
            var collider:Collider = new BinCollider();
            var collision:Collision = watched(collider);
            _ball.moveTo(4.5, 0, 0);
            collision.update(_agents);
            var bytes:ByteArray = collision.snapshot();
            _ball.moveTo(4.25, 0, 0);
            collider.findCollisions(_agents);
            _ball.moveTo(4.5, 0, 0);
            collision.restore(bytes, _agents);
            assertDepth("not those of the game's own call", 0.5, collider);
        }

        [Test]
        public function resetForgetsMotionsAndARefusedList():void
        {
            var collision:Collision = watched(new BinCollider());
            collision.update(_agents);
            collision.reset();
            collision.onCollision("balls", "walls", hit);
            _ball.moveTo(10, 0, 0);
            collision.update(_agents);
            assertEquals(0, _hits);
            assertThrows(ArgumentError, /twice/, collision.update, new <Agent>[_ball, _ball]);
            collision.reset();
            collision.onCollision("balls", "walls", hit);
            assertEquals("nothing is refused any more", 0, collision.lastAgents.length);
            collision.restore(collision.snapshot(), new Vector.<Agent>());
            _ball.moveTo(0, 0, 0);
            collision.update(_agents);
            assertEquals("the list before the refused one is forgotten too", 0, _hits);
        }

        [Test]
        public function aFilterMayChangeTheList():void
        {
            var collision:Collision = new Collision(new BinCollider());
            var asked:Vector.<int> = new Vector.<int>();
            var others:Vector.<Agent> = new <Agent>[agentAt("sphere", 4.5, 0, 0, "balls"), agentAt("sphere", 5.5, 0, 0, "balls"), _wall];
            var filter:AgentFilter = new AgentFilter();
            filter.accepts = function(agent:Agent):Boolean
            {
                asked.push(agent.id);
                if (asked.length == 1)
                {
                    others.shift();
                    collision.removeHandler("walls", "balls", hit);
                    collision.filter = null;
                }
                return true;
            };
            var wanted:String = [others[0].id, others[1].id, _wall.id].join();
            collision.filter = filter;
            collision.onCollision("balls", "walls", hit);
            collision.onCollision("walls", "balls", hit);
            collision.update(others);
            assertEquals(wanted, asked.join());
            assertEquals("not of the agent that has left the list", 1, _hits);
        }

        [Test]
        public function removeHandlerTellsKindsApart():void
        {
            var collision:Collision = new Collision(new BinCollider());
            _ball.moveTo(4.5, 0, 0);
            for each (var kind:String in ["end", "start", "collision"])
            {
                collision.onCollision("balls", "walls", hit);
                collision.onCollisionStart("balls", "walls", hit);
                collision.onCollisionEnd("balls", "walls", hit);
                assertEquals(true, collision.removeHandler("balls", "walls", hit, kind));
                assertEquals(false, collision.removeHandler("balls", "walls", hit, kind));
                _hits = 0;
                collision.update(_agents);
                collision.update(_agents);
                collision.update(new <Agent>[]);
                // one for the start, two for the frames, one for the end
                assertEquals(kind, 4 - (kind == "collision" ? 2 : 1), _hits);
                collision.reset();
            }
            assertThrows(ArgumentError, /kind must be "collision", "start", "end" or null, not "begin"/, collision.removeHandler, "balls", "walls", hit, "begin");
        }

        private function assertDepth(message:String, expected:Number, system:BaseCollider):void
        {
            var depth:Number = system.contactOf(_ball, _wall).depth;
            assertTrue(message + ": " + depth + ", not " + expected, Math.abs(depth - expected) < 1e-9);
        }

        private function watched(system:CollisionSystem):Collision
        {
            var collision:Collision = new Collision(system);
            collision.onCollision("balls", "walls", hit);
            return collision;
        }

        private function hit(a:Agent, b:Agent):void
        {
            _hits++;
        }

        private static function make(system:CollisionSystem):Collision
        {
            return new Collision(system);
        }

        private static function exchange(collision:Collision, system:CollisionSystem):void
        {
            collision.collisionSystem = system;
        }
    }
}

import starlogo.agents.Agent;
import starlogo.collision.BaseCollider;
import starlogo.collision.BinCollider;
import starlogo.collision.CollisionStatistics;
import starlogo.collision.CollisionSystem;
import starlogo.collision.Contact;

/** Finds nothing, and has no statistics. */
final class UncountedSystem implements CollisionSystem
{
    public function get statistics():CollisionStatistics
    {
        return null;
    }

    public function areColliding(a:Agent, b:Agent):Boolean
    {
        return false;
    }

    public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
    {
        return new Vector.<Agent>();
    }
}

/** Finds nothing, and says how many agents it has had. */
final class SayingSystem implements CollisionSystem
{
    private var _statistics:CollisionStatistics = new CollisionStatistics();

    public function SayingSystem(agents:int)
    {
        _statistics.agents = agents;
    }

    public function get statistics():CollisionStatistics
    {
        return _statistics;
    }

    public function areColliding(a:Agent, b:Agent):Boolean
    {
        return false;
    }

    public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
    {
        return new Vector.<Agent>();
    }
}

/** Sets some numbers of some contacts, and returns another object for others. */
final class DeepBins extends BaseCollider
{
    public function DeepBins()
    {
        super(new BinCollider());
    }

    override public function contactOf(collider:Agent, collidee:Agent, out:Contact = null):Contact
    {
        var contact:Contact = collidee.breed == "returned" ? new Contact() : out;
        if (collidee.breed != "plain")
        {
            contact.depth = collidee.breed == "deep" ? 5 : 7;
            contact.time = collidee.breed == "deep" ? 0.25 : 1;
        }
        return contact;
    }
}
