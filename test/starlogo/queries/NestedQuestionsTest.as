package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import support.Complaints;
    import support.Effort;
    import support.QuestionModels;
    import support.QuestionWorld;

    /** A filter's accepts asks every question in every question, with filters that ask too. All answers are those without filters, to the last bit. */
    public class NestedQuestionsTest
    {
        // The questions that have a filter, and those that accepts may ask.
        private static const OUTER:Array = ["near", "nearest", "near a point", "in a cone", "cast", "castAll", "canSee", "castShape", "castShapeAll", "castAgent", "castAgentAll",
                "overlapping", "touching", "would touch at", "moveUntilTouch", "slide", "walk"];
        private static const INNER:Array = OUTER.concat("colliding", "contacts", "distances", "distances to the ground", "distances to points", "touches an edge");

        private static const KINDS:Array = ["sphere", "cube", "apart", "doll", "open cube"];

        private var _random:SeededRandom = new SeededRandom(71);
        private var _wrong:Complaints = new Complaints();
        private var _world:QuestionWorld;

        // By question: its answer in this world without filters, asked by a guest.
        private var _guestAnswers:Object;

        // By question: how often its accepts was called.
        private var _calls:Object = {};

        [Test]
        public function questionsInFiltersDoNotChangeAnswers():void
        {
            for (var seed:int = 1; seed <= Effort.choose(3, 60); seed++)
            {
                var names:Array = [_random.pick(KINDS), "cube", _random.pick(KINDS)];
                _world = new QuestionWorld(QuestionModels.land(names, false), _random.pick(QuestionWorld.SYSTEMS));
                _world.begin(names, seed);
                _guestAnswers = {};
                for each (var inner:String in INNER)
                {
                    _guestAnswers[inner] = askAsGuest(inner, null);
                }
                for each (var outer:String in OUTER)
                {
                    _world.begin(names, seed);
                    var expected:String = _world.ask(outer);
                    var first:int = _random.integer(0, INNER.length - 1);
                    for (var i:int = Effort.choose(6, INNER.length); i > 0; i--)
                    {
                        inner = INNER[(first + i) % INNER.length];
                        _world.begin(names, seed);
                        _world.filter = asking(outer, inner);
                        _wrong.addIf(_world.ask(outer) != expected, outer + " asks " + inner, names + ", " + seed);
                        _world.filter = null;
                    }
                }
            }
            _wrong.assertNone();
            for each (outer in OUTER)
            {
                assertTrue(outer + " calls accepts " + _calls[outer] + " times", _calls[outer] > 9);
            }
        }

        // A filter that excludes no agent. Its accepts asks a question, with a filter that asks another one.
        private function asking(outer:String, inner:String):AgentFilter
        {
            var innermost:AgentFilter = new AgentFilter();
            innermost.accepts = function(agent:Agent):Boolean
            {
                askAgain(inner, _random.pick(INNER), null);
                return true;
            };
            var filter:AgentFilter = new AgentFilter();
            filter.accepts = function(agent:Agent):Boolean
            {
                _calls[outer] = int(_calls[outer]) + 1;
                askAgain(outer, inner, innermost);
                return true;
            };
            return filter;
        }

        private function askAgain(outer:String, inner:String, filter:AgentFilter):void
        {
            var answer:String = askAsGuest(inner, filter);
            _wrong.addIf(answer != _guestAnswers[inner], inner + " in " + outer, answer + " for " + _guestAnswers[inner]);
        }

        // In questions that move the agent, a guest asks, which is not in the list.
        private function askAsGuest(question:String, filter:AgentFilter):String
        {
            var before:Agent = _world.mover;
            var filterBefore:AgentFilter = _world.filter;
            var other:Agent = _world.agents[1];
            _world.mover = new Agent(other.shape);
            _world.mover.moveTo(other.x + 0.3, other.y - 0.2, other.z + 0.4);
            _world.filter = filter;
            var answer:String = _world.ask(question);
            _world.mover = before;
            _world.filter = filterBefore;
            return answer;
        }
    }
}
