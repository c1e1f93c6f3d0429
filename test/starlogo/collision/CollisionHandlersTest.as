package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.data.warn;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;
    import starlogo.terrain.WorldBounds;
    import support.OwnVectorSystem;
    import support.assertThrows;
    import support.create;
    import support.landOf;

    /** What handlers may do to a game, and to other handlers. */
    public class CollisionHandlersTest
    {
        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere());
        private var _collision:Collision = new Collision(new BinCollider(_greatLand));
        private var _agents:Vector.<Agent> = new Vector.<Agent>();
        private var _calls:Array = [];

        [Test]
        public function updateDoesNotNest():void
        {
            addAll("bears", "bears");
            _collision.onCollision("bears", "bears", function(collider:Agent, collidee:Agent):void
                {
                    _collision.update(_agents);
                });
            assertThrows(IllegalOperationError, /handler/, _collision.update, _agents);
        }

        [Test]
        public function badInputIsNamedAndCallsNoHandler():void
        {
            addAll("bears", "bears");
            _collision.onCollision("bears", "bears", note("bump"));
            _agents.push(_agents[0]);
            assertThrows(ArgumentError, /listed twice/, _collision.update, _agents);
            _agents[2] = null;
            assertThrows(ArgumentError, /agents\[2\].* null/, _collision.update, _agents);
            _agents[2] = new Agent("unicorn");
            assertThrows(ArgumentError, /unicorn/, _collision.update, _agents);
            assertThrows(ArgumentError, /null/, _collision.update, null);
            assertEquals(0, _calls.length);
            assertThrows(ArgumentError, /handler/, _collision.onCollision, "bears", "bears", null);
            assertThrows(ArgumentError, /^breed must be the name.*""/, _collision.onCollision, "", "bears", note("x"));
            assertThrows(ArgumentError, /\botherBreed must be (the name of a breed or ANY_BREED|a string), not null/, _collision.onCollision, "bears", null, note("x"));
            assertThrows(ArgumentError, /^TERRAIN and EDGE do not collide/, _collision.onCollision, "*terrain", "*edge", note("x"));
            assertThrows(ArgumentError, /collisionSystem/, create, Collision, null);
            _agents.pop();
            _collision.update(_agents);
            assertEquals("and the game goes on", 2, _calls.length);
        }

        [Test]
        public function handlersThatFlashCouldNotCallAreRefused():void
        {
            var one:Function = function(collider:Agent):void
            {
            };
            var four:Function = function(collider:Agent, collidee:Agent, contact:Contact = null, loud:Boolean = false):void
            {
            };
            for each (var add:Function in [_collision.onCollision, _collision.onCollisionStart, _collision.onCollisionEnd])
            {
                assertThrows(ArgumentError, /^the handler for "bears" and "balls" has 1 parameter, and gets two agents/, add, "bears", "balls", one);
                assertThrows(ArgumentError, /^the handler for "\*" and "balls" has 4 parameters, and gets two agents/, add, "*", "balls", four);
            }
            assertThrows(ArgumentError, /contact:Contact/, _collision.onCollision, "*", "balls", four);
            assertThrows(ArgumentError, /two agents: function\(collider:Agent, collidee:Agent\):void$/, _collision.onCollisionEnd, "*", "balls", four);
            addAll("bears", "balls");
            _collision.update(_agents);
            assertEquals("none was added", 0, _collision.statistics.handlerCalls);
            // it may have a rest parameter, so a line is traced
            _collision.onCollisionEnd("bears", "nets", function():void
                {
                });
            assertFalse(warn("the handler for \"bears\" and \"nets\" has no parameters. If it is function():void, Adobe's player throws an "
                        + "ArgumentError when it is called, and other players may not: write function(collider:Agent, collidee:Agent):void. "
                        + "If it is function(...all):void, nothing is wrong"));
        }

        [Test]
        public function aFilterWithoutParametersIsTold():void
        {
            var filter:AgentFilter = new AgentFilter();
            filter.accepts = function():Boolean
            {
                return true;
            };
            // of no agent: Adobe's player cannot call it
            var queries:AgentQueries = new AgentQueries(new BinCollider());
            queries.update(new Vector.<Agent>());
            assertEquals(0, queries.countNearPoint(new Vector3D(), 1, filter));
            assertFalse(warn("accepts of a filter has no parameters. If it is function():Boolean, Adobe's player throws an ArgumentError when it is called, and "
                        + "other players may not: write function(agent:Agent):Boolean. If it is function(...all):Boolean, nothing is wrong"));
        }

        // A warning that is said is not said again.
        [Test]
        public function breedsThatAreProbablyMisspelledAreTold():void
        {
            addAll("hedgehogs", "foxes", "trees7", "hedgehogs");
            for each (var name:String in ["hegdehogs", "foxse", "ofxes", "Hedgehogs", "foxe", "fox", "trees8", "sphere", "terain", "edgy", Collision.EDGE])
            {
                _collision.onCollision(Collision.ANY_BREED, name, note("x"));
            }
            _collision.update(_agents);
            assertFalse(warn(missing("hegdehogs") + "; is \"hedgehogs\" meant?"));
            assertFalse(warn(missing("Hedgehogs") + "; is \"hedgehogs\" meant?"));
            assertFalse(warn(missing("foxe") + "; is \"foxes\" meant?"));
            assertFalse(warn(missing("foxse") + "; is \"foxes\" meant?"));
            assertFalse(warn(missing("ofxes") + "; is \"foxes\" meant?"));
            assertFalse(warn(missing("terain") + "; is Collision.TERRAIN meant?"));
            assertFalse(warn(missing("sphere") + ", which is the shape of " + _agents[0] + ": new Agent(\"sphere\", \"BREED\") gives it a breed"));
            // not so near, or other numbers
            assertTrue(warn(missing("fox") + "; is \"foxes\" meant?"));
            assertTrue(warn(missing("trees8") + "; is \"trees7\" meant?"));
            assertTrue(warn(missing("edgy") + "; is Collision.EDGE meant?"));
        }

        [Test]
        public function aBreedThatAHandlerNamesIsNotMeantByAnother():void
        {
            addAll("keepers", "mails");
            _collision.onCollision("keepers", "mails", note("x"));
            _collision.update(_agents);
            _collision.onCollision("keepers", "sails", note("x"));
            _collision.update(_agents);
            assertTrue(warn(missing("sails") + "; is \"mails\" meant?"));
        }

        [Test]
        public function aBreedThatAHandlerNamesIsMeantByItsSingular():void
        {
            addAll("rowers", "coxes");
            _collision.onCollision("rowers", "coxes", note("x"));
            _collision.onCollision("rower", "Coxes", note("x"));
            _collision.update(_agents);
            assertFalse(warn(missing("rower") + "; is \"rowers\" meant?"));
            assertFalse(warn(missing("Coxes") + "; is \"coxes\" meant?"));
        }

        private static function missing(breed:String):String
        {
            return "no agent is of the breed \"" + breed + "\"";
        }

        [Test]
        public function aHandlerMayTakeAllItGets():void
        {
            addAll("bears", "balls");
            _collision.onCollision("bears", "balls", function(...all):void
                {
                    _calls.push(["all", all[0], all[1]]);
                });
            _collision.onCollision("bears", "balls", function(collider:Agent, collidee:Agent = null, contact:Contact = null):void
                {
                    _calls.push([contact == null ? "none" : "contact", collider, collidee]);
                });
            _collision.update(_agents);
            assertEquals("all,contact", names());
            assertEquals(_agents[0], _calls[0][1]);
            assertEquals(_agents[1], _calls[0][2]);
        }

        [Test]
        public function breedsThatNoAgentHasAreTold():void
        {
            addAll("bears", "balls");
            _collision.onCollision("bears", "bals", note("x"));
            _collision.onCollisionEnd(Collision.ANY_BREED, "traps", note("x"));
            _collision.onCollision("bears", Collision.EDGE, note("x"));
            assertEquals("before the first frame", "", _collision.breedsWithoutAgents.join());
            _collision.update(_agents);
            assertEquals("*edge,bals,traps", _collision.breedsWithoutAgents.sort(Array.CASEINSENSITIVE).join());
            _collision.bounds = new WorldBounds(-50, -50, 0, 50, 50, 50);
            addAll("traps");
            _collision.update(_agents);
            assertEquals("bals", _collision.breedsWithoutAgents.join());
            _collision.onCollision("bears", "foes", note("x"));
            assertEquals("not before the next frame", "bals", _collision.breedsWithoutAgents.join());
            _collision.reset();
            assertEquals("no last frame", "", _collision.breedsWithoutAgents.join());
            _collision.update(_agents);
            assertEquals("no handlers", "", _collision.breedsWithoutAgents.join());
        }

        [Test]
        public function anErrorNamesTheBreedsOfItsHandlerOnce():void
        {
            addAll("bears", "balls");
            var same:Error = new Error("again");
            var fail:Function = function(collider:Agent, collidee:Agent):void
            {
                throw same;
            };
            _collision.onCollisionStart(Collision.ANY_BREED, "balls", fail);
            assertThrows(Error, /^again \(in the handler for "\*" and "balls"\)$/, _collision.update, _agents);
            _collision.removeHandler(Collision.ANY_BREED, "balls", fail);
            same.message = "again";
            _collision.onCollision("balls", "bears", fail);
            _collision.onCollisionEnd("balls", "bears", fail);
            for (var i:int = 0; i < 3; i++)
            {
                assertThrows(Error, /^again \(in the handler for "balls" and "bears"\)$/, _collision.update, _agents);
                _agents[0].x += i;
            }
        }

        [Test]
        public function anErrorOfTwoHandlersDoesNotGrow():void
        {
            addAll("bears", "balls");
            var same:Error = new Error("again");
            var fail:Function = function(collider:Agent, collidee:Agent):void
            {
                throw same;
            };
            _collision.onCollision("bears", "balls", fail);
            _collision.onCollision("balls", Collision.ANY_BREED, fail);
            for (var i:int = 0; i < 3; i++)
            {
                assertThrows(Error, /^again \(in the handler for "balls" and "\*"\)$/, _collision.update, _agents);
                assertEquals(2, _collision.handlerErrors.length);
            }
        }

        [Test]
        public function everyErrorOfAFrameIsKept():void
        {
            addAll("bears", "bears", "bears");
            _collision.onCollision("bears", "bears", function(collider:Agent, collidee:Agent):void
                {
                    _calls.push("a");
                    throw _calls.length == 1 ? new RangeError("first") : new ArgumentError("later " + _calls.length);
                });
            assertThrows(RangeError, /^first \(in the handler for "bears" and "bears"\)$/, _collision.update, _agents);
            assertEquals("first,later 2,later 3,later 4,later 5,later 6", messages());
            _collision.collisionSystem = new OwnVectorSystem(new <Agent>[]);
            _collision.update(_agents);
            assertEquals("the next frame has none", 0, _collision.handlerErrors.length);
        }

        [Test]
        public function whatIsNoErrorStopsNoCallEither():void
        {
            addAll("bears", "bears");
            _collision.onCollision("bears", "bears", function(collider:Agent, collidee:Agent):void
                {
                    throw "a string";
                });
            _collision.onCollision("bears", "bears", function(collider:Agent, collidee:Agent):void
                {
                    throw null;
                });
            _collision.onCollision("bears", "bears", note("after"));
            assertThrows(Error, /^a string \(in the handler for "bears" and "bears"\)$/, _collision.update, _agents);
            assertEquals("after,after", names());
            assertEquals("a string,null,a string,null", messages());
        }

        // Whatever handlers throw, the calls are those of a game whose handlers throw errors.
        [Test]
        public function whatIsThrownMakesNoDifference():void
        {
            var things:Array = [new Error("plain"), "a string", null, undefined, 7, {}, new Unspeakable(), new UnspeakableError()];
            var calls:int = 0;
            for (var seed:int = 1; seed <= 40; seed++)
            {
                var expected:String = playThrowing(seed, [new Error("plain")]);
                assertEquals("game " + seed, expected, playThrowing(seed, things));
                calls += expected.split(",").length;
            }
            assertTrue(calls + " calls", calls > 2000);
        }

        private function playThrowing(seed:int, things:Array):String
        {
            var random:SeededRandom = new SeededRandom(seed);
            var collision:Collision = new Collision(new BinCollider(_greatLand));
            var calls:Array = [];
            for each (var method:Function in [collision.onCollision, collision.onCollisionStart, collision.onCollisionEnd])
            {
                for each (var breeds:String in ["a b", "b a", "a a", "* b"])
                {
                    method(breeds.charAt(0), breeds.charAt(2), throwing(calls.push, random, things));
                }
            }
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < 6; i++)
            {
                agents.push(new Agent("sphere", i % 2 == 0 ? "a" : "b"));
            }
            for (var frame:int = 0; frame < 12; frame++)
            {
                agents[random.integer(0, 5)].x = random.between(0, 4);
                try
                {
                    collision.update(agents);
                }
                catch (error:Error)
                {
                    calls.push("thrown");
                }
                calls.push("frame " + collision.handlerErrors.length);
            }
            return calls.join();
        }

        private static function throwing(push:Function, random:SeededRandom, things:Array):Function
        {
            var name:int = random.integer(0, 1000000);
            return function(collider:Agent, collidee:Agent):void
            {
                push(name + " " + collider.x + " " + collidee.x);
                var chosen:Number = random.next();
                if (random.chance(0.3))
                {
                    throw things[int(chosen * things.length)];
                }
            };
        }

        [Test]
        public function whatASystemFindsIsChecked():void
        {
            addAll("bears", "balls");
            _collision.onCollision("bears", "balls", note("hit"));
            var good:CollisionSystem = _collision.collisionSystem;
            assertSystemRefused(/^what the collision system has found must not be null$/, null);
            assertSystemRefused(/^the collision system has found no agent: 1 of what it has found is null$/, new <Agent>[_agents[0], null]);
            assertSystemRefused(/^the collision system has found agent \d+ .*, which is not in the list/, new <Agent>[_agents[0], new Agent("sphere", "balls")]);
            assertSystemRefused(/^the collision system has found pairs of 3 agents/, new <Agent>[_agents[0], _agents[1], _agents[0]]);
            _collision.collisionSystem = good;
            _collision.update(_agents);
            assertEquals("afterwards the game goes on", "hit", names());
        }

        [Test]
        public function theListOfAGamesOwnSystemIsChecked():void
        {
            addAll("bears", "balls");
            _collision.collisionSystem = new OwnVectorSystem(new <Agent>[_agents[0], _agents[1]]);
            assertThrows(ArgumentError, /agents\[1\].* null$/, _collision.update, new <Agent>[_agents[0], null]);
            assertThrows(ArgumentError, /is listed twice/, _collision.update, new <Agent>[_agents[0], _agents[1], _agents[0]]);
        }

        [Test]
        public function aBaseColliderAroundNothingSaysWhatIsMissing():void
        {
            addAll("bears", "balls");
            var empty:BaseCollider = new BaseCollider();
            assertThrows(IllegalOperationError, /must override areColliding, findCollisions and statistics/, empty.areColliding, _agents[0], _agents[1]);
            assertThrows(IllegalOperationError, /must override/, empty.findCollisions, _agents);
            _collision.collisionSystem = empty;
            assertThrows(IllegalOperationError, /must override/, _collision.update, _agents);
        }

        private function assertSystemRefused(message:RegExp, pairs:Vector.<Agent>):void
        {
            _collision.collisionSystem = new OwnVectorSystem(pairs);
            assertThrows(ArgumentError, message, _collision.update, _agents);
        }

        [Test]
        public function anyBreedIsEveryOther():void
        {
            addAll("bears", "balls", "walls", "clouds");
            _collision.onCollision("bears", Collision.ANY_BREED, note("bear"));
            _collision.update(_agents);
            assertEquals("the bear with three others", "bear,bear,bear", names());
            assertEquals(3, _collision.statistics.candidatePairs);
            assertEquals(0, _collision.statistics.agentsSkipped);
            _calls = [];
            _collision.onCollision(Collision.ANY_BREED, "walls", note("any"));
            _collision.onCollision("bears", "walls", note("wall"));
            _collision.update(_agents);
            // bear and ball, bear and wall, bear and cloud, ball and wall, wall and cloud
            assertEquals("in the order in which they were added", "any,any,any,bear,bear,bear,wall", names().split(",").sort().join());
            assertEquals(5, _collision.statistics.collisions);
        }

        [Test]
        public function aHandlerMayBeTakenAway():void
        {
            addAll("bears", "balls");
            var first:Function = note("first");
            _collision.onCollision("bears", "balls", first);
            _collision.onCollision("bears", "balls", note("second"));
            _collision.onCollision("bears", "balls", first);
            assertFalse(_collision.removeHandler("balls", "bears", first));
            assertFalse(_collision.removeHandler("bears", "balls", note("first")));
            assertTrue(_collision.removeHandler("bears", "balls", first));
            _collision.update(_agents);
            assertEquals("once", "second,first", names());
            assertTrue(_collision.removeHandler("bears", "balls", first));
            assertFalse(_collision.removeHandler("bears", "balls", first));
            _calls = [];
            _collision.update(_agents);
            assertEquals("second", names());
            assertThrows(ArgumentError, /handler/, _collision.removeHandler, "bears", "balls", null);
        }

        [Test]
        public function aHandlerThatIsAddedMeanwhileIsCalledFromTheNextFrameOn():void
        {
            addAll("bears", "balls", "walls");
            var adds:Function = function(collider:Agent, collidee:Agent):void
            {
                // for the pair at hand, and for the one whose turn is to come
                _collision.onCollision("bears", "balls", note("added"));
                _collision.onCollision("balls", "walls", note("added"));
            };
            _collision.onCollision("bears", "balls", adds);
            _collision.onCollision("balls", "walls", adds);
            _collision.update(_agents);
            assertEquals("", names());
            assertTrue(_collision.removeHandler("bears", "balls", adds));
            assertTrue(_collision.removeHandler("balls", "walls", adds));
            _collision.update(_agents);
            assertEquals("added,added,added,added", names());
        }

        [Test]
        public function aHandlerThatAnotherTakesAwayIsNotCalledAnyMore():void
        {
            addAll("bears", "balls", "balls");
            var second:Function = note("second");
            _collision.onCollision("bears", "balls", function(collider:Agent, collidee:Agent):void
                {
                    _calls.push(["first"]);
                    _collision.removeHandler("bears", "balls", second);
                });
            _collision.onCollision("bears", "balls", second);
            _collision.update(_agents);
            assertEquals("first,first", names());
        }

        [Test]
        public function theLastFramesListMayBeTheNextFramesAndChange():void
        {
            addAll("bears", "balls", "balls", "balls");
            _collision.onCollision("bears", "balls", function(bear:Agent, ball:Agent):void
                {
                    _calls.push(["hit", bear, ball]);
                    var list:Vector.<Agent> = _calls.length > 3 ? again : _agents;
                    list.splice(list.indexOf(ball), 1);
                });
            _collision.update(_agents.concat());
            assertEquals("the handler changes another list", "hit,hit,hit", names());
            var again:Vector.<Agent> = _collision.lastAgents;
            assertEquals(4, again.length);
            _collision.update(again);
            assertEquals("each ball once", "hit,hit,hit,hit,hit,hit", names());
            assertEquals("what handlers took out is gone from the game's list alone", 1, again.length);
            assertEquals(4, _collision.lastAgents.length);
        }

        [Test]
        public function anAgentHasLeftIfItIsMissingWhenItsNextCallIsDue():void
        {
            addAll("bears", "balls", "balls", "balls");
            assertEquals("added again before", "01,02,03,12,13,23", callsIfAddedAgainWith(1).join());
            assertEquals("added again after", "01,03,13", callsIfAddedAgainWith(3).join());
        }

        // The first handler of the bear and ball 1 removes ball 2, the second handler of the bear and another ball adds it again. Returns the calls.
        private function callsIfAddedAgainWith(number:int):Array
        {
            var all:Vector.<Agent> = _agents.concat();
            var list:Vector.<Agent> = _agents.concat();
            var calls:Array = [];
            var collision:Collision = new Collision(new BinCollider(_greatLand));
            collision.onCollision("bears", "balls", function(bear:Agent, ball:Agent):void
                {
                    calls.push("0" + all.indexOf(ball));
                    if (ball == all[1])
                    {
                        list.splice(list.indexOf(all[2]), 1);
                    }
                });
            collision.onCollision("bears", "balls", function(bear:Agent, ball:Agent):void
                {
                    if (all.indexOf(ball) == number)
                    {
                        list.push(all[2]);
                    }
                });
            collision.onCollision("balls", "balls", function(ball:Agent, other:Agent):void
                {
                    if (all.indexOf(ball) < all.indexOf(other))
                    {
                        calls.push(all.indexOf(ball) + "" + all.indexOf(other));
                    }
                });
            collision.update(list);
            return calls;
        }

        [Test]
        public function resetInAHandlerEndsTheCallsOfItsFrame():void
        {
            addAll("bears", "balls", "balls", "balls");
            _collision.onCollision("bears", "balls", function(bear:Agent, ball:Agent):void
                {
                    _calls.push(["hit", bear, ball]);
                    _collision.reset();
                });
            _collision.update(_agents);
            assertEquals("hit", names());
            assertEquals("no error", 0, _collision.handlerErrors.length);
            assertEquals(0, _collision.lastAgents.length);
        }

        [Test]
        public function resetInTheFilterForgetsTheFramesBeforeAlone():void
        {
            addAll("bears", "balls");
            var filter:AgentFilter = new AgentFilter();
            filter.accepts = function(agent:Agent):Boolean
            {
                _collision.reset();
                return true;
            };
            _collision.filter = filter;
            _collision.update(_agents);
            assertEquals(2, _collision.lastAgents.length);
            filter.accepts = null;
            _collision.restore(_collision.snapshot(), _agents);
        }

        // Handlers do at random what they like to a list, and every call is what the rules say, worked out by searching the list.
        [Test]
        public function callsAreThoseOfTheRulesWhateverHandlersDo():void
        {
            var removed:int = 0;
            var calls:int = 0;
            for (var seed:int = 0; seed < 300; seed++)
            {
                var expected:RuleBook = new RuleBook(seed);
                expected.play(new BinCollider(_greatLand));
                var actual:RuleBook = new RuleBook(seed);
                var collision:Collision = new Collision(new BinCollider(_greatLand));
                collision.onCollision("bears", "bears", actual.handle);
                collision.onCollision("bears", "balls", actual.handle);
                collision.onCollision("balls", "bears", actual.handle);
                collision.onCollision("bears", "bears", actual.handle);
                updateInSpiteOfErrors(collision, actual.agents);
                assertEquals("game " + seed, expected.log.join(), actual.log.join());
                calls += expected.log.length;
                removed += expected.skipped;
            }
            trace("  " + calls + " calls, " + removed + " not made");
            assertTrue(calls > 3000 && removed > 1000);
        }

        private static function updateInSpiteOfErrors(collision:Collision, agents:Vector.<Agent>):void
        {
            try
            {
                collision.update(agents);
            }
            catch (error:Error)
            {
                assertTrue(error.message, error.message.indexOf("now and then (in the handler for ") == 0);
            }
        }

        private function addAll(...breeds):void
        {
            for each (var breed:String in breeds)
            {
                var agent:Agent = new Agent("sphere", breed);
                agent.x = _agents.length * 0.1;
                _agents.push(agent);
            }
        }

        private function note(name:String):Function
        {
            return function(collider:Agent, collidee:Agent):void
            {
                _calls.push([name, collider, collidee]);
            };
        }

        private function names():String
        {
            return _calls.map(function(call:Array, index:int, all:Array):String
                {
                    return call[0];
                }).join();
        }

        private function messages():String
        {
            var texts:Array = [];
            for each (var error:Error in _collision.handlerErrors)
            {
                texts.push(error.message.split(" (in the handler")[0]);
            }
            return texts.join();
        }
    }
}

import evaluation.pairs.SeededRandom;
import starlogo.agents.Agent;
import starlogo.collision.CollisionSystem;

/** Has no text. */
class Unspeakable
{
    public function toString():String
    {
        throw this;
    }
}

/** An error with a text that cannot be read. */
class UnspeakableError extends Error
{
    public function toString():String
    {
        throw this;
    }
}

/** A game whose handlers change the list at random, the same with either caller. */
class RuleBook
{
    public var agents:Vector.<Agent> = new Vector.<Agent>();

    /** The calls, by the numbers of the agents. */
    public var log:Array = [];

    /** Calls that were not made. */
    public var skipped:int = 0;

    private var _random:SeededRandom;

    public function RuleBook(seed:int)
    {
        _random = new SeededRandom(7000 + seed);
        for (var i:int = 0; i < 9; i++)
        {
            agents.push(make());
        }
    }

    /** A handler. */
    public function handle(collider:Agent, collidee:Agent):void
    {
        if (act(collider, collidee))
        {
            throw new Error("now and then");
        }
    }

    /** Makes the calls by the rules. */
    public function play(system:CollisionSystem):void
    {
        var pairs:Vector.<Agent> = ofInterest(system.findCollisions(agents));
        var gone:Vector.<Agent> = new Vector.<Agent>();
        for (var i:int = 0; i < pairs.length; i += 2)
        {
            var breed:String = pairs[i].breed;
            var otherBreed:String = pairs[i + 1].breed;
            callIfListed(pairs[i], pairs[i + 1], handlersOf(breed, otherBreed), gone);
            callIfListed(pairs[i + 1], pairs[i], handlersOf(otherBreed, breed), gone);
        }
    }

    // The breeds that the two have before the first call have handlers.
    private static function ofInterest(found:Vector.<Agent>):Vector.<Agent>
    {
        var pairs:Vector.<Agent> = new Vector.<Agent>();
        for (var i:int = 0; i < found.length; i += 2)
        {
            if (handlersOf(found[i].breed, found[i + 1].breed) + handlersOf(found[i + 1].breed, found[i].breed) > 0)
            {
                pairs.push(found[i], found[i + 1]);
            }
        }
        return pairs;
    }

    private function callIfListed(collider:Agent, collidee:Agent, times:int, gone:Vector.<Agent>):void
    {
        for (var i:int = 0; i < times; i++)
        {
            if (!isListed(collider, gone) || !isListed(collidee, gone))
            {
                skipped++;
                return;
            }
            act(collider, collidee);
        }
    }

    private function isListed(agent:Agent, gone:Vector.<Agent>):Boolean
    {
        if (gone.indexOf(agent) < 0 && agents.indexOf(agent) >= 0)
        {
            return true;
        }
        gone.push(agent);
        return false;
    }

    private static function handlersOf(breed:String, otherBreed:String):int
    {
        if (breed == "bears")
        {
            return otherBreed == "bears" ? 2 : (otherBreed == "balls" ? 1 : 0);
        }
        return breed == "balls" && otherBreed == "bears" ? 1 : 0;
    }

    // Whether it ends with an error.
    private function act(collider:Agent, collidee:Agent):Boolean
    {
        log.push(collider.color + "-" + collidee.color);
        change(collider, collidee);
        return _random.chance(0.1);
    }

    private function make():Agent
    {
        var agent:Agent = new Agent("sphere", _random.pick(["bears", "bears", "balls", "clouds"]));
        agent.moveTo(_random.between(0, 1), _random.between(0, 1), 0);
        agent.color = _random.integer(1, 1000000);
        return agent;
    }

    private function change(collider:Agent, collidee:Agent):void
    {
        var index:int = agents.length == 0 ? 0 : _random.integer(0, agents.length - 1);
        switch (_random.integer(0, 13))
        {
            case 0:
                agents.splice(agents.indexOf(collidee), 1);
                break;
            case 1:
                agents.splice(index, 1);
                break;
            case 2:
                agents.pop();
                break;
            case 3:
                agents[agents.indexOf(collider)] = agents[agents.length - 1];
                agents.pop();
                break;
            case 4:
                agents.push(make());
                break;
            case 5:
                agents.unshift(make());
                break;
            case 6:
                agents.reverse();
                break;
            case 7:
                agents[index] = make();
                break;
            case 8:
                agents.splice(agents.indexOf(collider), 1);
                agents.push(collider);
                break;
            case 9:
                collider.breed = _random.pick(["bears", "balls", "clouds"]);
                break;
            case 10:
                collidee.x += 5;
                break;
        }
    }
}
