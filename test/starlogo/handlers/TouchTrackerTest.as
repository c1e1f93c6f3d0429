package starlogo.handlers
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.FoundPairs;

    use namespace engine;

    public class TouchTrackerTest
    {
        private static const FRAMES:int = 300;

        private var _tracker:TouchTracker = new TouchTracker();
        private var _found:FoundPairs = new FoundPairs();
        private var _agents:Array = [];

        [Before]
        public function makeAgents():void
        {
            for (var i:int = 0; i < 40; i++)
            {
                _agents.push(new Agent("cube", i % 3 == 0 ? "sheep" : "wolves"));
            }
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
                _found.count = wanted;
                assertFalse("all pairs are others", _tracker.areKept(_found));
                _tracker.begin(_found);
                assertEquals(frame, _tracker.frame);
                for (var i:int = 0; i < wanted; i++)
                {
                    var a:Agent = random.pick(_agents);
                    var b:Agent = random.pick(_agents);
                    var name:String = nameOf(a, b);
                    if (a == b)
                    {
                        continue;
                    }
                    _tracker.renew(i, a, b);
                    var known:Touch = _tracker.touches[i];
                    assertEquals(name, pairs.indexOf(name) >= 0, known != null);
                    if (known == null)
                    {
                        known = _tracker.touchOrStart(i, a, b, a.breedNumber, b.breedNumber, true);
                        assertStrictlyEquals("either way round it is the same", known, _tracker.touchOrStart(i, b, a, b.breedNumber, a.breedNumber, true));
                        assertStrictlyEquals(known, _tracker.touches[i]);
                        assertEquals(frame, known.beganIn);
                        pairs.push(name);
                    }
                    seen[name] = true;
                }
                most = Math.max(most, pairs.length);
                var left:Array = pairs.filter(function(each:String, ...rest):Boolean
                    {
                        return seen.hasOwnProperty(each);
                    });
                var ended:Array = pairs.filter(function(each:String, ...rest):Boolean
                    {
                        return !seen.hasOwnProperty(each);
                    });
                _tracker.collectEnded();
                assertEquals(ended.join(), namesOf(_tracker.ended, _tracker.endedCount));
                _tracker.forgetEnded();
                assertEquals(left.join(), namesOf(_tracker.inOrder(), _tracker.count));
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
            _found.revision = 1;
            for (var frame:int = 1; frame <= FRAMES; frame++)
            {
                _found.basis = _found.revision;
                _found.revision++;
                var dropped:Array = [];
                var left:Array = [];
                for (var i:int = 0; i < pairs.length; i++)
                {
                    if (random.next() < (frame % 40 < 20 ? 0.1 : 0.4))
                    {
                        _found.dropped.numbers[dropped.length] = i;
                        dropped.push(pairs[i]);
                    }
                    else
                    {
                        left.push(pairs[i]);
                    }
                }
                _found.dropped.count = dropped.length;
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
                    _found.added.numbers[i] = places[i];
                }
                _found.added.count = found.length;
                _found.count = pairs.length;
                assertEquals("pairs were kept", frame > 1, _tracker.areKept(_found));
                _tracker.begin(_found);
                for (i = 0; i < found.length; i++)
                {
                    assertNull(_tracker.touches[places[i]]);
                    _tracker.renew(places[i], agentOf(found[i], 0), agentOf(found[i], 1));
                }
                _tracker.collectEnded();
                var ended:Array = begun.filter(function(each:String, ...rest):Boolean
                    {
                        return pairs.indexOf(each) < 0;
                    });
                assertEquals(ended.join(), namesOf(_tracker.ended, _tracker.endedCount));
                _tracker.forgetEnded();
                begun = begun.filter(function(each:String, ...rest):Boolean
                    {
                        return pairs.indexOf(each) >= 0;
                    });
                for (i = 0; i < pairs.length; i++)
                {
                    var first:Agent = agentOf(pairs[i], 0);
                    var second:Agent = agentOf(pairs[i], 1);
                    assertEquals(pairs[i], begun.indexOf(pairs[i]) >= 0, _tracker.touches[i] != null);
                    if (_tracker.touches[i] == null)
                    {
                        _tracker.touchOrStart(i, first, second, first.breedNumber, second.breedNumber, true);
                        begun.push(pairs[i]);
                    }
                    assertEquals(pairs[i], nameOf(_tracker.touches[i].first, _tracker.touches[i].second));
                }
                assertEquals(begun.join(), namesOf(_tracker.inOrder(), _tracker.count));
                _tracker.complete(_found);
                numbers = pairs.concat();
            }
            assertTrue("some remained", begun.length > 5);
            _found.basis = _found.revision;
            _tracker.begin(_found);
            _found.basis = _found.revision;
            assertFalse("the frame before was not completed", _tracker.begin(_found));
        }

        [Test]
        public function anotherBreedOrOneWayIsNoTouchToGoOn():void
        {
            var a:Agent = _agents[0];
            var b:Agent = _agents[1];
            _tracker.touchOrStart(0, a, b, a.breedNumber, b.breedNumber);
            assertNull("handlers of one way only", renewed(a, b));
            _tracker.collectEnded();
            var touch:Touch = _tracker.touchOrStart(0, a, b, a.breedNumber, b.breedNumber, true);
            assertStrictlyEquals(touch, renewed(b, a));
            b.breed = "sheep";
            assertNull(renewed(a, b));
            b.breed = "wolves";
            a.breed = "wolves";
            assertNull(renewed(a, b));
        }

        // The touch that goes on in a next frame.
        private function renewed(a:Agent, b:Agent):Touch
        {
            _found.count = 1;
            _tracker.begin(_found);
            _tracker.renew(0, a, b);
            return _tracker.touches[0];
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

        private static function namesOf(touches:Vector.<Touch>, count:int):String
        {
            var names:Array = [];
            for (var i:int = 0; i < count; i++)
            {
                names.push(nameOf(touches[i].first, touches[i].second));
            }
            return names.join();
        }
    }
}
