package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertTrue;
    import starlogo.steps.StepSequence;
    import support.Complaints;
    import support.Effort;
    import support.FrameByFrame;
    import support.QuestionModels;
    import support.QuestionWorld;

    /**
     * Every question to every kind of model in every system, asked first or later, of models that were divided or read from cooked files. The
     * answers are the same to the last bit.
     */
    public class QuestionMatrixTest
    {
        public static const FIXTURES:Array = QuestionModels.FIXTURES;

        // How many questions are asked first in each run.
        private static const EVERY_DAY:int = 2;

        private var _wrong:Complaints = new Complaints();
        private var _runs:int = 0;
        private var _asked:int = 0;

        // By question: how many different answers there were.
        private var _answers:Object = {};
        private var _different:Object = {};

        [Test(async, timeout="3600000")]
        public function answersDoNotDependOnWhatWasAskedBefore():void
        {
            var kinds:int = QuestionModels.NAMES.length;
            var systems:int = QuestionWorld.SYSTEMS.length;
            // each kind in some system, or in every one
            var count:int = kinds * Effort.choose(1, systems);
            var i:int = 0;
            var asking:StepSequence = new StepSequence().repeat(function():Boolean
                {
                    askAll(QuestionModels.NAMES[i % kinds], QuestionWorld.SYSTEMS[(i + int(i / kinds)) % systems], i + 1);
                    return ++i < count;
                });
            FrameByFrame.run(this, asking, 50, function():void
                {
                    trace("  " + _runs + " runs of " + kinds + " kinds of models in " + systems + " systems with " + _asked + " questions");
                    _wrong.assertNone();
                    var different:int = 0;
                    for each (var question:String in QuestionWorld.QUESTIONS)
                    {
                        different += _different[question];
                        assertTrue(question + " has " + _different[question] + " answers", _different[question] > 2);
                    }
                    assertTrue(different + " answers", different > count * QuestionWorld.QUESTIONS.length / 3);
                });
        }

        // The answers in a land that was asked everything before, against those in lands that were asked nothing.
        private function askAll(kind:String, system:String, seed:int):void
        {
            var random:SeededRandom = new SeededRandom(seed);
            var names:Array = [kind, "cube", random.pick(QuestionModels.NAMES)];
            var what:String = names + ", " + system;
            var later:Object = null;
            for each (var isCooked:Boolean in [false, true])
            {
                var world:QuestionWorld = new QuestionWorld(QuestionModels.land(names, isCooked), system);
                var warm:Object = answersOf(world, names, seed, what);
                var again:Object = answersOf(world, names, seed, what);
                later ||= again;
                var first:int = random.integer(0, QuestionWorld.QUESTIONS.length - 1);
                for (var i:int = 0; i < QuestionWorld.QUESTIONS.length; i++)
                {
                    var question:String = QuestionWorld.QUESTIONS[(first + i) % QuestionWorld.QUESTIONS.length];
                    compare(later[question], warm[question], question + ", once asked", what, isCooked, seed);
                    compare(later[question], again[question], question + ", asked again", what, isCooked, seed);
                    if (Effort.isFull || i < EVERY_DAY)
                    {
                        world = new QuestionWorld(QuestionModels.land(names, isCooked), system);
                        compare(later[question], answerOf(world, names, seed, question, what), question + ", asked first", what, isCooked, seed);
                    }
                }
                _runs++;
            }
        }

        private function answersOf(world:QuestionWorld, names:Array, seed:int, what:String):Object
        {
            var answers:Object = {};
            for each (var question:String in QuestionWorld.QUESTIONS)
            {
                answers[question] = answerOf(world, names, seed, question, what);
            }
            return answers;
        }

        private function answerOf(world:QuestionWorld, names:Array, seed:int, question:String, what:String):String
        {
            _asked++;
            try
            {
                world.begin(names, seed);
                var answer:String = world.ask(question);
            }
            catch (error:Error)
            {
                answer = String(error);
                _wrong.add(question + " throws", what + ", " + seed + ": " + error);
            }
            _wrong.addIf(/NaN/.test(answer), question + " is NaN", what + ", " + seed + ": " + answer);
            if (_answers[question + answer] == undefined)
            {
                _answers[question + answer] = true;
                _different[question] = int(_different[question]) + 1;
            }
            return answer;
        }

        private function compare(expected:String, answer:String, how:String, what:String, isCooked:Boolean, seed:int):void
        {
            _wrong.addIf(expected != answer, how + (isCooked ? ", cooked" : ""), what + ", " + seed + ": " + answer + " for " + expected);
        }
    }
}
