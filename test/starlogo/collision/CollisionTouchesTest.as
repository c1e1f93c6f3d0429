package starlogo.collision
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import support.MoodyBins;
    import support.OwnVectorSystem;
    import support.assertThrows;
    import support.landOf;

    /** When touches begin and end: handlers of onCollisionStart and onCollisionEnd. */
    public class CollisionTouchesTest
    {
        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube());
        private var _collision:Collision = new Collision(new BinCollider(_greatLand));
        private var _bear:Agent = new Agent("sphere", "bears");
        private var _ball:Agent = new Agent("sphere", "balls");
        private var _agents:Vector.<Agent> = new <Agent>[_bear, _ball];
        private var _calls:Array = [];

        [Test]
        public function whoIsTakenOutBeforeItsTurnNeverTouched():void
        {
            var other:Agent = new Agent("sphere", "bears");
            other.moveTo(0.2, 0.2, 0);
            _agents.push(other);
            _collision.onCollisionStart("bears", "balls", function(collider:Agent, collidee:Agent):void
                {
                    _calls.push("start");
                    _agents.splice(_agents.indexOf(_ball), 1);
                });
            _collision.onCollisionEnd("bears", "balls", function(collider:Agent, collidee:Agent):void
                {
                    _calls.push("end");
                });
            assertFrame("one of two bears", 0.1, "start");
            assertFrame("its end", 0.1, "end");
            assertFrame("no more", 0.1, "");
        }

        [Test]
        public function theDirectionThatWasNotReachedHasNoEnd():void
        {
            note("balls", "bears");
            _collision.onCollision("bears", "balls", function(collider:Agent, collidee:Agent):void
                {
                    _agents.length = 0;
                });
            _collision.onCollisionEnd("bears", "balls", function(collider:Agent, collidee:Agent):void
                {
                    _calls.push("end");
                });
            assertFrame("the bear is first", 0.5, "");
            assertFrame("and has an end", 0.5, "end");
        }

        [Test]
        public function aTouchThatHadOneDirectionOnlyBeginsAnewInBoth():void
        {
            note("bears", "balls");
            note("balls", "bears");
            var isFirst:Boolean = true;
            _collision.onCollision("bears", "balls", function(collider:Agent, collidee:Agent):void
                {
                    if (isFirst)
                    {
                        _agents.length = 0;
                        isFirst = false;
                    }
                });
            assertFrame("the ball's turn does not come", 0.5, "start bears balls,stay bears balls");
            _agents.push(_bear, _ball);
            assertFrame("both", 0.5, "end bears balls,start bears balls,stay bears balls,start balls bears,stay balls bears");
            assertFrame("and on", 0.5, "stay bears balls,stay balls bears");
            assertFrame("gone", 5, "end bears balls,end balls bears");
        }

        /** A breed counts as it is when the calls of the pair begin, whether there are other handlers or not. */
        [Test]
        public function aBreedThatAHandlerGivesMayStartATouch():void
        {
            for each (var hasOthers:Boolean in [false, true])
            {
                var rock:Agent = new Agent("sphere", "rocks");
                rock.moveTo(0.2, 0, 0);
                var all:Vector.<Agent> = new <Agent>[_bear, _ball, rock];
                var collision:Collision = new Collision(new BaseCollider(new BinCollider(_greatLand)));
                collision.onCollisionStart("bears", "balls", function(bear:Agent, ball:Agent):void
                    {
                        rock.breed = "gems";
                    });
                collision.onCollisionStart("bears", "gems", noting("start"));
                if (hasOthers)
                {
                    collision.onCollision("doors", "keys", noting("open"));
                }
                collision.update(all);
                assertEquals("start bears gems", _calls.join());
                collision.update(all);
                assertEquals("once", "start bears gems", _calls.join());
                _calls = [];
            }
        }

        [Test]
        public function anotherSystemMayEndIt():void
        {
            note("bears", "balls");
            assertFrame("spheres", 0.5, "start bears balls,stay bears balls");
            _collision.collisionSystem = new TightestFitCollider(_greatLand);
            assertFrame("the same", 0.4, "stay bears balls");
            _collision.collisionSystem = new OwnVectorSystem(new <Agent>[]);
            assertFrame("finds no pair", 0.4, "end bears balls");
            _collision.collisionSystem = new OwnVectorSystem(new <Agent>[_ball, _bear]);
            assertFrame("finds them far apart", 40, "start bears balls,stay bears balls");
        }

        [Test]
        public function whatIsThrownStopsNoCall():void
        {
            var thrower:Function = function(collider:Agent, collidee:Agent):void
            {
                _calls.push("thrown");
                throw new Error("x");
            };
            _collision.onCollisionStart("bears", "balls", thrower);
            _collision.onCollisionEnd("bears", "balls", thrower);
            note("bears", "balls");
            _ball.moveTo(0.5, 0, 0);
            assertThrows(Error, /x/, _collision.update, _agents);
            assertEquals("thrown,start bears balls,stay bears balls", _calls.join());
            _calls = [];
            _ball.moveTo(5, 0, 0);
            assertThrows(Error, /x/, _collision.update, _agents);
            assertEquals("thrown,end bears balls", _calls.join());
            assertEquals(2, _collision.statistics.handlerCalls);
        }

        [Test]
        public function aContactThatIsNotFoundLosesNoEnd():void
        {
            var other:Agent = new Agent("sphere", "balls");
            var system:MoodyBins = new MoodyBins(_greatLand);
            _collision.collisionSystem = system;
            _agents.push(other);
            note("bears", "balls");
            _collision.onCollision("bears", "balls", function(collider:Agent, collidee:Agent, contact:Contact):void
                {
                });
            other.moveTo(0, 0.5, 0);
            assertFrame("both", 0.5, "start bears balls,stay bears balls,start bears balls,stay bears balls");
            _ball.moveTo(5, 0, 0);
            _calls = [];
            system.refuses = true;
            assertThrows(Error, /no contact/, _collision.update, _agents);
            assertEquals("no handler has run", "", _calls.join());
            system.refuses = false;
            assertFrame("the next frame", 5, "end bears balls,stay bears balls");
        }

        [Test]
        public function aThirdArgumentIsTheContact():void
        {
            var contacts:Array = [];
            var take:Function = function(collider:Agent, collidee:Agent, contact:Contact):void
            {
                contacts.push(contact);
                _calls.push(contact == null ? "null" : collider.breed + " " + contact.depth.toFixed(3) + " " + contact.normal.x);
            };
            _collision.onCollisionStart("bears", "balls", take);
            _collision.onCollision("balls", "bears", take);
            _collision.onCollisionEnd("bears", "balls", take);
            _ball.size = 0.5;
            _bear.size = 0.5;
            assertFrame("first", 0.375, "bears 0.125 -1,balls 0.125 1");
            assertTrue("one object", contacts[0] === contacts[1]);
            assertFrame("second", 0.4, "balls 0.100 1");
            assertFrame("gone", 4, "null");
            // of a system that does not know
            _collision.collisionSystem = new OwnVectorSystem(new <Agent>[_bear, _ball]);
            assertFrame("a client's system", 4, "bears 0.000 -1,balls 0.000 1");
        }

        // All three kinds of handlers.
        private function note(breed:String, other:String):void
        {
            _collision.onCollision(breed, other, noting("stay"));
            _collision.onCollisionEnd(breed, other, noting("end", breed, other));
            _collision.onCollisionStart(breed, other, noting("start"));
        }

        private function noting(word:String, breed:String = null, other:String = null):Function
        {
            return function(collider:Agent, collidee:Agent):void
            {
                var isAny:Boolean = other == null || other == Collision.ANY_BREED;
                _calls.push(word + " " + (breed || collider.breed) + " " + (isAny ? collidee.breed : other));
            };
        }

        private function assertFrame(name:String, x:Number, calls:String):void
        {
            _ball.moveTo(x, 0, 0);
            _calls = [];
            _collision.update(_agents);
            assertEquals(name, calls, _calls.join());
        }
    }
}
