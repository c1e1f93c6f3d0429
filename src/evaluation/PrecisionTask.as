package evaluation
{
    import evaluation.scenes.Scene;
    import evaluation.scenes.Scenes;
    import starlogo.agents.Agent;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.GreatLand;

    /** How many of the pairs that collide as spheres, boxes, capsules or hulls touch, in a game of six models. Exact mode says which touch. */
    public final class PrecisionTask extends Task
    {
        private static const AGENTS:int = 150;
        private static const FRAMES:int = 50;
        private static const SHAPES:Array = [Agent.SPHERE, Agent.BOX, Agent.CAPSULE, Agent.TIGHTEST, Agent.HULL];

        private var _models:Object;
        private var _results:Results;
        private var _exact:HierarchicalCollider = null;
        private var _shapes:TightestFitCollider;
        private var _scene:Scene = Scenes.crowded(AGENTS);
        private var _accuracies:Vector.<Accuracy> = new Vector.<Accuracy>();
        private var _frame:int = 0;

        /**
         * @param models all models by name
         * @param results takes the shares
         */
        public function PrecisionTask(models:Object, results:Results)
        {
            super("precision of shapes", 3000);
            _models = models;
            _results = results;
        }

        /** @inheritDoc */
        override public function work():Boolean
        {
            if (_exact == null)
            {
                begin();
                return false;
            }
            _scene.step();
            var truth:Object = Accuracy.truthOf(_exact, _scene.agents);
            for (var i:int = 0; i < SHAPES.length; i++)
            {
                for each (var agent:Agent in _scene.agents)
                {
                    agent.collideAs = SHAPES[i];
                }
                _accuracies[i].add(_shapes.findCollisions(_scene.agents), truth);
            }
            _frame++;
            if (_frame == FRAMES)
            {
                conclude();
            }
            return _frame == FRAMES;
        }

        private function begin():void
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.loadAllBoundingStructures = greatLand.loadHulls = true;
            for each (var name:String in Scenes.CROWDED)
            {
                greatLand.addModel(_models[name]);
            }
            _exact = new HierarchicalCollider(greatLand);
            _exact.exact = true;
            _shapes = new TightestFitCollider(greatLand);
            for each (var shape:String in SHAPES)
            {
                _accuracies.push(new Accuracy());
            }
        }

        private function conclude():void
        {
            for (var i:int = 0; i < SHAPES.length; i++)
            {
                _results.addNumber("precision", SHAPES[i], "found", _accuracies[i].found, "pairs");
                _results.addNumber("precision", SHAPES[i], "precision", 100 * _accuracies[i].precision, "%");
                _results.addNumber("precision", SHAPES[i], "recall", 100 * _accuracies[i].recall, "%");
            }
        }
    }
}
