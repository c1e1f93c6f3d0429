package docs
{
    import org.flexunit.asserts.assertEquals;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    /** For the ASDoc of StepSequence: the parts, in their order. */
    public class StepSequencePage extends Page
    {
        public static const FIXTURES:Array = [];

        private var _log:Array = [];

        protected function parse():void
        {
            _log.push("parse");
        }

        protected function newReader():Steps
        {
            return new StepSequence().call(function():void
                {
                    _log.push("read");
                });
        }

        protected function store():void
        {
            _log.push("store");
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            assertEquals("", _log.join());
            finish(shown["loading"]);
            assertEquals("parse,read,store", _log.join());
        }
    }
}
