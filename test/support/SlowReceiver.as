package support
{
    import starlogo.models.Model;
    import starlogo.models.ModelReceiver;
    import starlogo.steps.Steps;

    /** Receives models in ten steps that each take their time. */
    public class SlowReceiver implements ModelReceiver
    {
        /** How long a step takes, in ms. */
        public var stepMs:int;

        /** The names of the models that were received to the end. */
        public var received:Array = [];

        /** The names of the models that are on their way. */
        public var expected:Array = [];

        private var _refused:Array = [];

        public function SlowReceiver(stepMs:int)
        {
            this.stepMs = stepMs;
        }

        /** Fails on the models of a name, in a middle step. */
        public function refuse(name:String):void
        {
            _refused.push(name);
        }

        /** @inheritDoc */
        public function expect(name:String):void
        {
            expected.push(name);
        }

        /** @inheritDoc */
        public function expectNoMore(name:String, problem:String = null):void
        {
            expected.splice(expected.indexOf(name), 1);
        }

        /** @inheritDoc */
        public function receive(model:Model):Steps
        {
            return new SlowSteps(this, model.name, _refused.indexOf(model.name) >= 0);
        }
    }
}
