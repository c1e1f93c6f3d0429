package starlogo.handlers
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    public class TouchTrackerTest
    {
        private static const FRAMES:int = 300;

        private var _tracker:TouchTracker = new TouchTracker();
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
            for (_tracker.frame = 1; _tracker.frame <= FRAMES; _tracker.frame++)
            {
                // crowds that come and go, so that the table grows and shrinks
                var wanted:int = _tracker.frame % 60 < 30 ? 200 : 3;
                var seen:Object = {};
                for (var i:int = 0; i < wanted; i++)
                {
                    var a:Agent = random.pick(_agents);
                    var b:Agent = random.pick(_agents);
                    var name:String = nameOf(a, b);
                    if (a == b)
                    {
                        continue;
                    }
                    var known:Touch = _tracker.renew(a, b);
                    assertEquals(name, pairs.indexOf(name) >= 0, known != null);
                    if (known == null)
                    {
                        known = _tracker.start(a, b, a.breedNumber, b.breedNumber, true);
                        assertStrictlyEquals("either way round it is the same", known, _tracker.start(b, a, b.breedNumber, a.breedNumber, true));
                        assertEquals(_tracker.frame, known.beganIn);
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
                var touching:Vector.<Touch> = new Vector.<Touch>();
                for (i = 0; i < _tracker.count; i++)
                {
                    touching.push(_tracker.pairAt(i));
                }
                assertEquals(left.join(), namesOf(touching, touching.length));
                pairs = left;
            }
            assertTrue("there were many", most > 150);
            _tracker.clear();
            assertEquals(0, _tracker.count);
            assertNull(_tracker.renew(_agents[0], _agents[1]));
        }

        [Test]
        public function anotherBreedOrOneWayIsNoTouchToGoOn():void
        {
            var a:Agent = _agents[0];
            var b:Agent = _agents[1];
            _tracker.start(a, b, a.breedNumber, b.breedNumber);
            assertNull("handlers of one way only", _tracker.renew(a, b));
            _tracker.clear();
            var touch:Touch = _tracker.start(a, b, a.breedNumber, b.breedNumber, true);
            assertStrictlyEquals(touch, _tracker.renew(b, a));
            b.breed = "sheep";
            assertNull(_tracker.renew(a, b));
            b.breed = "wolves";
            a.breed = "wolves";
            assertNull(_tracker.renew(a, b));
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
