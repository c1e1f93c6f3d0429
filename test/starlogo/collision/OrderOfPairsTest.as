package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.landOf;

    /**
     * Pairs come in the order of the list, by the first agent's index and then by the second's, as from a loop over all pairs. When an agent sweeps,
     * they come by time of impact first. What a collider has seen before does not show.
     */
    public class OrderOfPairsTest
    {
        private static const SHAPES:Array = ["sphere", "cube", "cylinder"];
        private static const NEAR:Number = 1e-9;

        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder());
        private var _random:SeededRandom = new SeededRandom(404);
        private var _agents:Vector.<Agent>;
        private var _wrong:Complaints = new Complaints();
        private var _pairs:int = 0;

        // pairs whose order is not that of the agents' ids
        private var _againstIds:int = 0;

        [Test]
        public function isOneInLongGames():void
        {
            var frames:int = Effort.choose(40, 400);
            for each (var name:String in EachCollider.NAMES)
            {
                var kept:Collider = EachCollider.make(name, _greatLand);
                makeAgents(40, 4);
                for (var frame:int = 0; frame < frames; frame++)
                {
                    var happens:String = _random.pick(["nothing", "leave", "come", "swap", "reverse", "sort", "copy", "model", "grow", "gone"]);
                    happen(happens);
                    moveSome();
                    check(name, "frame " + frame + ", " + happens, kept);
                }
            }
            assertEnough();
        }

        [Test]
        public function isThatOfTimesWhenAnAgentSweeps():void
        {
            var frames:int = Effort.choose(30, 300);
            var differing:int = 0;
            for each (var name:String in EachCollider.NAMES)
            {
                var kept:Collider = EachCollider.make(name, _greatLand);
                var younger:Collider = EachCollider.make(name, _greatLand);
                makeAgents(20, 4);
                for (var frame:int = 0; frame < frames; frame++)
                {
                    for each (var agent:Agent in _agents)
                    {
                        agent.sweeps = _random.chance(0.4);
                    }
                    _agents[0].sweeps = true;
                    if (_random.chance(0.2))
                    {
                        // one that has seen no more than the frame before this one, which is all that a motion needs
                        younger = EachCollider.make(name, _greatLand);
                        younger.findCollisions(_agents);
                        kept.findCollisions(_agents);
                    }
                    happen(_random.pick(["nothing", "leave", "come", "swap", "reverse", "sort", "copy"]));
                    moveSome();
                    var found:Vector.<Agent> = kept.findCollisions(_agents);
                    var times:Vector.<Number> = timesOf(kept, found);
                    checkOrder(name, "swept frame " + frame, found, times);
                    assertSame(name, younger.findCollisions(_agents), found);
                    differing += times.length > 1 && times[0] < times[times.length - 1] ? 1 : 0;
                }
            }
            assertTrue(differing + " frames of different times", differing > frames);
            assertEnough();
        }

        [Test]
        public function theGroundAndTheEdgesAreTheLastTwoOfTheList():void
        {
            _agents = new Vector.<Agent>();
            for each (var x:Number in [0, 3])
            {
                for each (var y:Number in [0, 0.5])
                {
                    var agent:Agent = new Agent("sphere", "balls");
                    agent.moveTo(x, y, 0);
                    _agents.push(agent);
                }
            }
            var calls:Array = [];
            var note:Function = function(a:Agent, b:Agent):void
            {
                calls.push(_agents.indexOf(a) + (_agents.indexOf(b) < 0 ? b.breed : "-" + _agents.indexOf(b)));
            };
            var collision:Collision = new Collision(new BinCollider());
            collision.terrain = new Terrain(6, 6, 1, -2, -2);
            collision.bounds = new WorldBounds(-9, -0.4, -9, 9, 9, 9);
            for each (var other:String in ["balls", Collision.TERRAIN, Collision.EDGE])
            {
                collision.onCollision("balls", other, note);
            }
            collision.update(_agents);
            assertEquals("0-1,1-0,0*terrain,0*edge,1*terrain,2-3,3-2,2*terrain,2*edge,3*terrain", calls.join());
        }

        [Test]
        public function isThatInWhichHandlersAreCalled():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                for each (var isSwept:Boolean in [false, true])
                {
                    makeAgents(30, 3);
                    _agents[3].sweeps = isSwept;
                    var collider:Collider = EachCollider.make(name, _greatLand);
                    var twin:Collider = EachCollider.make(name, _greatLand);
                    var calls:Vector.<Agent> = new Vector.<Agent>();
                    var times:Vector.<Number> = new Vector.<Number>();
                    var collision:Collision = new Collision(collider);
                    collision.onCollision(Collision.ANY_BREED, "balls", function(a:Agent, b:Agent, contact:Contact):void
                        {
                            // of a pair of balls both are called, one after the other
                            var isBack:Boolean = _agents.indexOf(a) > _agents.indexOf(b);
                            if (isBack && a.breed == "balls")
                            {
                                assertTrue("once forth, once back", calls[calls.length - 2] === b && calls[calls.length - 1] === a);
                                return;
                            }
                            calls.push(isBack ? b : a, isBack ? a : b);
                            times.push(contact.time);
                        });
                    for (var frame:int = 0; frame < 5; frame++)
                    {
                        calls.length = times.length = 0;
                        collision.update(_agents);
                        checkOrder(name, "calls", calls, isSwept ? times : null);
                        assertSame(name, withBalls(twin.findCollisions(_agents)), calls);
                        happen(_random.pick(["leave", "come", "swap"]));
                        moveSome();
                    }
                }
            }
            assertEnough();
        }

        private function happen(what:String):void
        {
            switch (what)
            {
                case "leave":
                    _agents.splice(_random.integer(0, _agents.length - 1), 1);
                    _agents.splice(_random.integer(0, _agents.length - 1), 1);
                    break;
                case "come":
                    _agents.splice(_random.integer(0, _agents.length), 0, makeAgent(3));
                    _agents.push(makeAgent(3));
                    break;
                case "swap":
                    var i:int = _random.integer(0, _agents.length - 1);
                    var last:Agent = _agents.pop();
                    if (i < _agents.length)
                    {
                        _agents.push(_agents[i]);
                        _agents[i] = last;
                    }
                    else
                    {
                        _agents.push(last);
                    }
                    break;
                case "reverse":
                    _agents.reverse();
                    break;
                case "sort":
                    mix();
                    break;
                case "copy":
                    _agents = _agents.concat();
                    break;
                case "model":
                    _greatLand.addModel(BuiltInModel.cube());
                    break;
                case "grow":
                    _agents[_random.integer(0, _agents.length - 1)].size = _random.logBetween(0.1, 6);
                    break;
                case "gone":
                    // somewhere else for a frame
                    _agents[0].moveTo(_random.pick([1e9, 3000]), 0, 0);
                    break;
            }
        }

        private function makeAgents(count:int, half:Number):void
        {
            _agents = new Vector.<Agent>();
            for (var i:int = 0; i < count; i++)
            {
                _agents.push(makeAgent(half));
            }
            mix();
        }

        private function makeAgent(half:Number):Agent
        {
            var agent:Agent = new Agent(_random.pick(SHAPES), _random.pick(["bears", "balls", "walls"]));
            agent.moveTo(_random.between(-half, half), _random.between(-half, half), _random.between(0, 0.3));
            agent.size = _random.pick([0.5, 1, 1, 1, 2]);
            agent.hierarchical = _random.chance(0.3);
            return agent;
        }

        private function moveSome():void
        {
            for each (var agent:Agent in _agents)
            {
                if (Math.abs(agent.x) > 100)
                {
                    agent.moveTo(0, 0, 0);
                }
                else if (_random.chance(0.6))
                {
                    agent.moveTo(agent.x * 0.95 + _random.normal() * 0.5, agent.y * 0.95 + _random.normal() * 0.5, agent.z);
                }
            }
        }

        // Puts the list into a random order (Fisher and Yates).
        private function mix():void
        {
            for (var i:int = _agents.length - 1; i > 0; i--)
            {
                var other:int = _random.integer(0, i);
                var agent:Agent = _agents[i];
                _agents[i] = _agents[other];
                _agents[other] = agent;
            }
        }

        // A frame of one that is kept, and of a new one.
        private function check(name:String, when:String, kept:Collider):void
        {
            var found:Vector.<Agent> = kept.findCollisions(_agents);
            checkOrder(name, when, found, null);
            assertSame(name, loop(kept), found);
            var fresh:Vector.<Agent> = EachCollider.make(name, _greatLand).findCollisions(_agents);
            checkOrder(name + ", a new one", when, fresh, null);
            assertSame(name, fresh, found);
        }

        // The times are null where no agent sweeps.
        private function checkOrder(name:String, when:String, found:Vector.<Agent>, times:Vector.<Number>):void
        {
            var firstBefore:int = -1;
            var secondBefore:int = -1;
            for (var i:int = 0; i < found.length; i += 2)
            {
                _pairs++;
                var first:int = _agents.indexOf(found[i]);
                var second:int = _agents.indexOf(found[i + 1]);
                _againstIds += found[i].id > found[i + 1].id ? 1 : 0;
                _wrong.addIf(first < 0 || first >= second, name, when + ": " + first + "-" + second);
                var comesLater:Boolean = i == 0 || first > firstBefore || first == firstBefore && second > secondBefore;
                _wrong.addIf(!comesLater && (times == null || times[i / 2] == times[i / 2 - 1]), name + ", list", when + ": " + first + "-" + second
                        + " after " + firstBefore + "-" + secondBefore);
                firstBefore = first;
                secondBefore = second;
                if (times != null && i > 0 && times[i / 2] < times[i / 2 - 1] - NEAR)
                {
                    _wrong.add(name + ", times", when + ": " + times[i / 2 - 1] + ", then " + times[i / 2]);
                }
            }
        }

        // All pairs of the list that touch where they are.
        private function loop(collider:Collider):Vector.<Agent>
        {
            var pairs:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < _agents.length; i++)
            {
                for (var j:int = i + 1; j < _agents.length; j++)
                {
                    if (collider.areColliding(_agents[i], _agents[j]))
                    {
                        pairs.push(_agents[i], _agents[j]);
                    }
                }
            }
            return pairs;
        }

        private static function timesOf(collider:Collider, found:Vector.<Agent>):Vector.<Number>
        {
            var times:Vector.<Number> = new Vector.<Number>();
            var contact:Contact = new Contact();
            for (var i:int = 0; i < found.length; i += 2)
            {
                times.push(collider.contactOf(found[i], found[i + 1], contact).time);
            }
            return times;
        }

        private function withBalls(found:Vector.<Agent>):Vector.<Agent>
        {
            var kept:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < found.length; i += 2)
            {
                if (found[i].breed == "balls" || found[i + 1].breed == "balls")
                {
                    kept.push(found[i], found[i + 1]);
                }
            }
            return kept;
        }

        private function assertSame(name:String, expected:Vector.<Agent>, actual:Vector.<Agent>):void
        {
            var texts:Array = [textOf(expected), textOf(actual)];
            if (texts[0] != texts[1])
            {
                var isOrder:Boolean = texts[0].split(",").sort().join() == texts[1].split(",").sort().join();
                _wrong.add(name + (isOrder ? ": another order" : ": other pairs"), texts[1].substr(0, 60) + ", not "
                        + texts[0].substr(0, 60));
            }
        }

        private function assertEnough():void
        {
            trace("  " + _pairs + " pairs");
            _wrong.assertNone();
            assertTrue(_pairs + " pairs, " + _againstIds + " against the order of ids", _pairs > 200 && _againstIds > _pairs / 10);
        }

        private function textOf(pairs:Vector.<Agent>):String
        {
            var parts:Array = [];
            for (var i:int = 0; i < pairs.length; i += 2)
            {
                parts.push(_agents.indexOf(pairs[i]) + "-" + _agents.indexOf(pairs[i + 1]));
            }
            return parts.join();
        }
    }
}
