package evaluation
{
    import evaluation.scenes.Scene;
    import evaluation.scenes.Scenes;
    import starlogo.agents.Agent;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.GreatLand;

    /**
     * How many of the pairs that collide as spheres, boxes, capsules or hulls touch, and of those that each collider finds, in a game of six models
     * in which every other agent is hierarchical. Exact mode says which touch.
     */
    public final class PrecisionTask extends Task
    {
        private static const AGENTS:int = 150;
        private static const FRAMES:int = 50;
        private static const SHAPES:Array = [Agent.SPHERE, Agent.BOX, Agent.CAPSULE, Agent.TIGHTEST, Agent.HULL];

        private var _models:Object;
        private var _settings:Settings;
        private var _results:Results;
        private var _exact:HierarchicalCollider = null;
        private var _shapes:TightestFitCollider;
        private var _colliders:Vector.<CollisionSystem> = new Vector.<CollisionSystem>();
        private var _scene:Scene = Scenes.crowded(AGENTS);
        // those of the shapes, then those of the colliders
        private var _accuracies:Vector.<Accuracy> = new Vector.<Accuracy>();
        private var _frame:int = 0;

        /**
         * @param models all models by name
         * @param settings name the colliders
         * @param results takes the shares
         */
        public function PrecisionTask(models:Object, settings:Settings, results:Results)
        {
            super("precision of shapes and colliders", 4000);
            _models = models;
            _settings = settings;
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
                collideAs(SHAPES[i]);
                _accuracies[i].add(_shapes.findCollisions(_scene.agents), truth);
            }
            collideAs(Agent.TIGHTEST);
            for (i = 0; i < _colliders.length; i++)
            {
                _accuracies[SHAPES.length + i].add(_colliders[i].findCollisions(_scene.agents), truth);
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
            for each (name in _settings.colliders)
            {
                _colliders.push(Colliders.make(name, greatLand, _settings.own));
            }
            for (var i:int = 0; i < SHAPES.length + _colliders.length; i++)
            {
                _accuracies.push(new Accuracy());
            }
            for (i = 0; i < AGENTS; i += 2)
            {
                _scene.agents[i].hierarchical = true;
            }
        }

        private function collideAs(shape:String):void
        {
            for each (var agent:Agent in _scene.agents)
            {
                agent.collideAs = shape;
            }
        }

        private function conclude():void
        {
            var names:Array = SHAPES.concat(_settings.colliders);
            for (var i:int = 0; i < names.length; i++)
            {
                var figure:String = i < SHAPES.length ? "precision" : "colliders";
                _results.addNumber(figure, names[i], "found", _accuracies[i].found, "pairs");
                _results.addNumber(figure, names[i], "precision", 100 * _accuracies[i].precision, "%");
                _results.addNumber(figure, names[i], "recall", 100 * _accuracies[i].recall, "%");
            }
        }
    }
}
