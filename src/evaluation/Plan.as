package evaluation
{
    import evaluation.scenes.Scene;
    import evaluation.scenes.Scenes;
    import flash.display.Stage;
    import starlogo.GreatLand;

    /** The tasks that the settings ask for, in the order of the thesis's section 6. */
    public final class Plan
    {
        private static const HIERARCHICAL_CROWD:int = 100;
        private static const MONITORED_GAME:int = 1000;

        /** The tasks. */
        public var tasks:Vector.<Task> = new Vector.<Task>();

        private var _settings:Settings;
        private var _results:Results;
        private var _models:Object;
        private var _novaModels:Object;
        private var _greatLand:GreatLand = new GreatLand();
        private var _literal:LiteralColliders;
        private var _stage:Stage;

        /**
         * @param settings select the tasks
         * @param files all models
         * @param results takes the measurements
         * @param stage shows the monitor
         */
        public function Plan(settings:Settings, files:ModelFiles, results:Results, stage:Stage)
        {
            _settings = settings;
            _models = files.models;
            _novaModels = files.novaModels;
            _results = results;
            _stage = stage;
            for each (var name:String in ["sphere", "cube", "cylinder", "bear", "dragon"])
            {
                _greatLand.addModel(_models[name]);
            }
            _literal = new LiteralColliders(_greatLand, [_models.sphere, _models.cube, _models.bear, _models.dragon]);
            var planners:Object = {volumes: planVolumes, fits: planFits, access: planAccess, tests: planTests,
                    precision: planPrecision, hierarchies: planHierarchies, crowds: planCrowds, combination: planCombination, experiments: planExperiments, scattered: planScattered,
                    monitor: planMonitor};
            for each (var figure:String in settings.figures)
            {
                planners[figure]();
            }
        }

        private function planVolumes():void
        {
            for each (var name:String in _settings.models)
            {
                add(new VolumesTask("volumes", _models[name], _settings, _results), "volumes", name);
            }
            for each (name in _settings.models)
            {
                if (_novaModels.hasOwnProperty(name))
                {
                    add(new VolumesTask("nova", _novaModels[name], _settings, _results), "nova", name);
                }
            }
        }

        private function planFits():void
        {
            for each (var name:String in _settings.models)
            {
                add(new FitTask(_models[name], _settings, _results), "fits", name);
            }
        }

        private function planAccess():void
        {
            for each (var name:String in _settings.models)
            {
                if (_greatLand.hasModel(name))
                {
                    add(new AccessTask(name, _greatLand, _settings, _results), "access", name);
                }
            }
        }

        private function planTests():void
        {
            for each (var name:String in TestTask.TESTS)
            {
                add(new TestTask(name, _settings, _results), "tests", name);
            }
        }

        private function planPrecision():void
        {
            add(new PrecisionTask(_models, _settings, _results), "precision", "all");
        }

        private function planHierarchies():void
        {
            for each (var name:String in _settings.models)
            {
                add(new HierarchyTask(_models[name], _settings, _results), "hierarchies", name);
            }
        }

        private function planCrowds():void
        {
            for each (var count:int in _settings.crowds)
            {
                for each (var cast:String in Scenes.CROWD_CASTS)
                {
                    for each (var collider:String in _settings.colliders)
                    {
                        var scene:Scene = Scenes.crowd(count, cast);
                        var subject:String = count + " " + cast;
                        makeSomeHierarchical(scene, collider == "CombinationCollider" ? 1 : 0);
                        addGame("crowds", subject, collider, collider, scene, Thesis.CROWD_MS[collider + " " + subject]);
                    }
                }
            }
        }

        // §6.4: between the TightestFitCollider and the HierarchicalCollider
        private function planCombination():void
        {
            for each (var cast:String in _settings.casts === Scenes.CASTS ? Scenes.CASTS : ["bears"])
            {
                for each (var hierarchical:int in [0, 1, 10, HIERARCHICAL_CROWD])
                {
                    var scene:Scene = Scenes.crowd(HIERARCHICAL_CROWD, cast);
                    makeSomeHierarchical(scene, hierarchical);
                    addGame("combination", HIERARCHICAL_CROWD + " " + cast, hierarchical + " hierarchical", "CombinationCollider", scene, undefined);
                }
            }
        }

        private function planExperiments():void
        {
            var models:Array = [_models.cube, _models.bear, _models.cylinder, _models.seagull, _models.kelp, _models.person];
            for each (var question:String in ExperimentTask.QUESTIONS)
            {
                add(new ExperimentTask(question, models, _settings, _results), "experiments", question);
            }
        }

        private function planScattered():void
        {
            for each (var cast:String in _settings.casts)
            {
                planGames(cast, Scenes.scattered, "");
                planGames(cast, Scenes.scatteredAsDense, ", as dense");
            }
        }

        private function planGames(cast:String, make:Function, suffix:String):void
        {
            for each (var count:int in _settings.games)
            {
                for each (var collider:String in _settings.colliders)
                {
                    var scene:Scene = make(count, cast);
                    makeSomeHierarchical(scene, collider == "CombinationCollider" ? 1 : 0);
                    addGame("scattered", count + " " + cast + suffix, collider, collider, scene, undefined);
                }
            }
        }

        private function planMonitor():void
        {
            var scene:Scene = Scenes.scattered(MONITORED_GAME, "mix");
            makeSomeHierarchical(scene, MONITORED_GAME / 10);
            add(new MonitorTask(_stage, scene.agents, Colliders.make("CombinationCollider", _greatLand, _settings.own), _settings, _results), "monitor",
                    _settings.isWanted("monitor", "recorder") ? "recorder" : MONITORED_GAME + " agents");
        }

        private function addGame(figure:String, subject:String, variant:String, collider:String, scene:Scene, thesis:*):void
        {
            add(new GameTask(figure, subject, variant, scene, Colliders.make(collider, _greatLand, _settings.own),
                        figure == "scattered" ? null : _literal.pairTest(collider), thesis, _settings, _results), figure, subject, variant);
        }

        // Adds a task, if what it measures is wanted.
        private function add(task:Task, figure:String, subject:String, variant:String = null):void
        {
            if (_settings.isWanted(figure, subject, variant))
            {
                tasks.push(task);
            }
        }

        private static function makeSomeHierarchical(scene:Scene, count:int):void
        {
            for (var i:int = 0; i < count && i < scene.agents.length; i++)
            {
                scene.agents[i].hierarchical = true;
            }
        }
    }
}
