package starlogo.handlers
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.FoundPairs;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    public class TouchTrackerTest
    {
        private static const FRAMES:int = 300;

        private var _tracker:TouchTracker = new TouchTracker();
        private var _found:FoundPairs = new FoundPairs(new ListedAgents());
        private var _agents:Array = [];
        private var _handlers:HandlerTable = new HandlerTable();

        [Before]
        public function makeAgents():void
        {
            for (var i:int = 0; i < 40; i++)
            {
                _agents.push(new Agent("cube", i % 3 == 0 ? "sheep" : "wolves"));
                _found.listed.agentsByRow.push(_agents[i]);
            }
            _handlers.add("*", "*", function(a:Agent, b:Agent):void
                {
                }, CollisionHandler.START);
            _handlers.begin(Vector.<Agent>(_agents));
        }

        [Test]
        public function knowsWhatAListKnows():void
        {
            var random:SeededRandom = new SeededRandom(4711);
            var pairs:Array = [];
            var most:int = 0;
            for (var frame:int = 1; frame <= FRAMES; frame++)
            {
                // crowds that come and go
                var wanted:int = frame % 60 < 30 ? 200 : 3;
                var seen:Object = {};
                _found.count = 0;
                for (var i:int = 0; i < wanted; i++)
                {
                    var a:Agent = random.pick(_agents);
                    var b:Agent = random.pick(_agents);
                    if (a != b && !seen[nameOf(a, b)])
                    {
                        addPair(a, b);
                        seen[nameOf(a, b)] = true;
                    }
                }
                begin(false);
                var left:Array = pairs.filter(function(each:String, ...rest):Boolean
                    {
                        return seen.hasOwnProperty(each);
                    });
                var ended:Array = pairs.filter(function(each:String, ...rest):Boolean
                    {
                        return !seen.hasOwnProperty(each);
                    });
                assertEquals(ended.join(), endedNames());
                for (i = 0; i < _found.count; i++)
                {
                    a = _found.firstOf(i);
                    b = _found.secondOf(i);
                    var name:String = nameOf(a, b);
                    var known:Touch = _tracker.touchAt(i);
                    assertEquals(name, pairs.indexOf(name) >= 0, known != null);
                    if (known == null)
                    {
                        known = _tracker.startAt(i);
                        assertFalse("also if its object had another touch", known.hasReachedSecond);
                        known.hasReachedSecond = true;
                        assertStrictlyEquals("either way round it is the same", known, _tracker.find(b, a));
                        assertStrictlyEquals(known, _tracker.touchAt(i));
                        if (left.indexOf(name) < 0)
                        {
                            left.push(name);
                        }
                    }
                }
                _tracker.endFrame();
                most = Math.max(most, left.length);
                assertEquals(left.join(), namesOf(_tracker.inOrder()));
                assertEquals(left.length, _tracker.count);
                pairs = left;
            }
            assertTrue("there were many", most > 150);
        }

        [Test]
        public function touchesOfKeptPairsGoOn():void
        {
            var random:SeededRandom = new SeededRandom(815);
            var pairs:Array = [];
            var numbers:Array = [];
            var begun:Array = [];
            for (var frame:int = 1; frame <= FRAMES; frame++)
            {
                var dropped:Array = [];
                var left:Array = [];
                var touchIndices:Array = [];
                for (var i:int = 0; i < pairs.length; i++)
                {
                    if (random.next() < (frame % 40 < 20 ? 0.1 : 0.4))
                    {
                        dropped.push(pairs[i]);
                    }
                    else
                    {
                        left.push(pairs[i]);
                        touchIndices.push(_found.touchIndices[i]);
                    }
                }
                pairs = left.concat();
                // some pairs that were dropped, and new ones
                var found:Array = dropped.filter(function(...rest):Boolean
                    {
                        return random.next() < 0.5;
                    });
                for (i = 0; i < 8; i++)
                {
                    var a:int = random.next() * _agents.length;
                    var b:int = random.next() * _agents.length;
                    var name:String = nameOf(_agents[a], _agents[b]);
                    if (a != b && numbers.indexOf(name) < 0 && found.indexOf(name) < 0)
                    {
                        found.push(name);
                    }
                }
                var places:Array = [];
                while (places.length < found.length)
                {
                    var place:int = random.next() * (pairs.length + found.length);
                    if (places.indexOf(place) < 0)
                    {
                        places.push(place);
                    }
                }
                places.sort(Array.NUMERIC);
                for (i = 0; i < places.length; i++)
                {
                    pairs.splice(places[i], 0, found[i]);
                    touchIndices.splice(places[i], 0, FoundPairs.NO_TOUCH);
                }
                _found.count = 0;
                for (i = 0; i < pairs.length; i++)
                {
                    _found.touchIndices[i] = touchIndices[i];
                    addPair(agentOf(pairs[i], 0), agentOf(pairs[i], 1));
                }
                begin(frame > 1);
                var ended:Array = begun.filter(function(each:String, ...rest):Boolean
                    {
                        return pairs.indexOf(each) < 0;
                    });
                assertEquals(ended.join(), endedNames());
                begun = begun.filter(function(each:String, ...rest):Boolean
                    {
                        return pairs.indexOf(each) >= 0;
                    });
                for (i = 0; i < pairs.length; i++)
                {
                    var touch:Touch = _tracker.touchAt(i);
                    assertEquals(pairs[i], begun.indexOf(pairs[i]) >= 0, touch != null);
                    if (touch == null)
                    {
                        touch = _tracker.startAt(i);
                        touch.hasReachedSecond = true;
                        begun.push(pairs[i]);
                    }
                    assertEquals(pairs[i], nameOf(touch.first, touch.second));
                }
                _tracker.endFrame();
                assertEquals(begun.join(), namesOf(_tracker.inOrder()));
                assertEquals(begun.length, _tracker.count);
                numbers = pairs.concat();
            }
            assertTrue("some remained", begun.length > 5);
            assertEquals("another tracker knows none of them", _found.count, new TouchTracker().beginFrame(_found, _handlers).count);
        }

        [Test]
        public function aTouchOfOneWayEndsInTheNextFrameAndAnotherMayBegin():void
        {
            addPair(_agents[0], _agents[1]);
            addPair(_agents[2], _agents[3]);
            begin(false);
            for (var pair:int = 0; pair < 2; pair++)
            {
                _tracker.startAt(pair).hasReachedSecond = pair == 0;
            }
            _tracker.dropAt(1);
            _tracker.endFrame();
            assertEquals(1, begin(true));
            assertEquals(nameOf(_agents[2], _agents[3]), endedNames());
            assertTrue(_tracker.touchAt(0) != null);
            assertNull(_tracker.touchAt(1));
            _tracker.endFrame();
            assertEquals(1, _tracker.count);
        }

        // Begins a frame with other pairs, or with those that are updated. Returns how many touches may begin.
        private function begin(isIncremental:Boolean):int
        {
            if (!isIncremental)
            {
                _found.forgetTouches();
            }
            var starting:IntList = _tracker.beginFrame(_found, _handlers);
            for (var i:int = 0; i < starting.count; i++)
            {
                assertNull(_tracker.touchAt(starting.values[i]));
            }
            var touching:int = 0;
            for (i = 0; i < _found.count; i++)
            {
                touching += _tracker.touchAt(i) == null ? 0 : 1;
            }
            assertEquals("all others go on", _found.count, starting.count + touching);
            _tracker.endLostTouches();
            return starting.count;
        }

        [Test]
        public function anotherBreedOrOneWayIsNoTouchToGoOn():void
        {
            var a:Agent = _agents[0];
            var b:Agent = _agents[1];
            addPair(b, a);
            assertNull(next());
            _tracker.start(a, b, a.breedNumber, b.breedNumber);
            assertNull("handlers of one way only", next());
            var touch:Touch = startBothWays(a, b);
            assertStrictlyEquals(touch, next());
            b.breed = "sheep";
            assertNull(next());
            startBothWays(a, b);
            a.breed = "wolves";
            assertNull(next());
        }

        private function startBothWays(a:Agent, b:Agent):Touch
        {
            var touch:Touch = _tracker.start(a, b, a.breedNumber, b.breedNumber);
            touch.hasReachedSecond = true;
            return touch;
        }

        // The touch of the first pair that goes on in the next frame.
        private function next():Touch
        {
            _tracker.endFrame();
            begin(false);
            return _tracker.touchAt(0);
        }

        private function addPair(a:Agent, b:Agent):void
        {
            _found.rows[2 * _found.count] = _found.listed.agentsByRow.indexOf(a);
            _found.rows[2 * _found.count + 1] = _found.listed.agentsByRow.indexOf(b);
            _found.count++;
        }

        private function endedNames():String
        {
            var ended:Vector.<Touch> = new Vector.<Touch>();
            for (var i:int = 0; i < _tracker.endedCount; i++)
            {
                ended.push(_tracker.endedAt(i));
            }
            return namesOf(ended);
        }

        private function agentOf(name:String, which:int):Agent
        {
            var id:int = name.split(" ")[which];
            return _agents[id - _agents[0].id];
        }

        private static function nameOf(a:Agent, b:Agent):String
        {
            return Math.min(a.id, b.id) + " " + Math.max(a.id, b.id);
        }

        private static function namesOf(touches:Vector.<Touch>):String
        {
            var names:Array = [];
            for (var i:int = 0; i < touches.length; i++)
            {
                names.push(nameOf(touches[i].first, touches[i].second));
            }
            return names.join();
        }
    }
}
