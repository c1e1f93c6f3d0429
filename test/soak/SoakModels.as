package soak
{
    import evaluation.pairs.SeededRandom;
    import flash.events.ErrorEvent;
    import starlogo.GreatLand;
    import starlogo.libraries.FitStore;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ModelEvent;
    import starlogo.models.ModelLoader;
    import support.SolidModels;
    import support.encoded;

    /** The models of a soak's game: some stay, some are replaced and removed at once, some come through a ModelLoader, or don't. */
    public final class SoakModels
    {
        private static const REPLACED:Array = ["blob 1", "blob 2", "blob 3", "blob 4"];
        private static const LOADED:Array = ["load 1", "load 2", "load 3", "load 4", "load 5"];
        private static const BROKEN:String = "v 0 0 0\nv 1 0 0\nf 1 2 3\n";

        // shapes that come again, and how many bytes of fits are kept: not of all
        private static const COMMON_SHAPES:int = 6;
        private static const KEPT_BYTES:int = 15000;

        private var _random:SeededRandom;
        private var _counts:SoakCounts;
        private var _greatLand:GreatLand = new GreatLand();
        private var _loaders:Vector.<ModelLoader> = new Vector.<ModelLoader>();
        private var _storage:SoakStorage;
        private var _lasting:Array = [];
        private var _reaches:Object = {};
        private var _passing:int = 0;

        /**
         * @param random decides
         * @param counts is told
         */
        public function SoakModels(random:SeededRandom, counts:SoakCounts)
        {
            _random = random;
            _counts = counts;
            _storage = new SoakStorage(random, counts);
            _greatLand.fitStore = new FitStore(KEPT_BYTES, _storage);
            var points:Model = new Model("points", cloud());
            for each (var model:Model in [BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder(), points,
                        SolidModels.hollow(), SolidModels.apart()])
            {
                add(model);
                _lasting.push(model.name);
            }
            // each does a step a frame: what a budget allows depends on the machine
            for (var i:int = 0; i < LOADED.length; i++)
            {
                _loaders.push(newLoader());
            }
        }

        /** Has them. */
        public function get greatLand():GreatLand
        {
            return _greatLand;
        }

        /** Has their fits. */
        internal function get storage():SoakStorage
        {
            return _storage;
        }

        /** A shape that agents may have now: a model that is there, or is loading. */
        public function pickShape():String
        {
            var shape:String = _random.pick(_random.chance(0.5) ? _lasting : _random.chance(0.5) ? REPLACED : LOADED);
            return isKnown(shape) ? shape : _random.pick(_lasting);
        }

        /** Whether agents may have a shape. */
        public function isKnown(shape:String):Boolean
        {
            return _greatLand.hasModel(shape) || _greatLand.isLoading(shape);
        }

        /** How far what stands for an agent of size 1 can be from where the agent is. */
        public function reachOf(shape:String):Number
        {
            return _reaches[shape];
        }

        /** Adds or replaces a model at once. */
        public function replaceOne():void
        {
            var name:String = _random.pick(_random.chance(0.8) ? REPLACED : LOADED);
            _counts.add(_greatLand.hasModel(name) ? "models replaced" : "models added");
            chooseFlags();
            var lathe:Lathe = newLathe();
            add(new Model(name, lathe.vertices, lathe.triangles));
        }

        /** Removes a model, whoever has its shape. */
        public function removeOne():void
        {
            if (_greatLand.removeModel(_random.pick(_random.chance(0.5) ? REPLACED : LOADED)))
            {
                _counts.add("models removed");
            }
        }

        /** Begins to load a model, or stops what is loading under a name. */
        public function loadOne():void
        {
            var place:int = _random.integer(0, LOADED.length - 1);
            var loader:ModelLoader = _loaders[place];
            if (loader.pendingCount == 0)
            {
                chooseFlags();
                load(loader, _random.chance(0.2) ? "passing " + ++_passing : LOADED[place]);
            }
            else if (_random.chance(0.1))
            {
                loader.cancel();
                _counts.add("loads cancelled");
            }
        }

        private function newLoader():ModelLoader
        {
            var loader:ModelLoader = new ModelLoader(_greatLand, 0);
            loader.addEventListener(ModelEvent.LOADED, onLoaded);
            loader.addEventListener(ErrorEvent.ERROR, onError);
            return loader;
        }

        // What is passing nobody has, and its name never comes again
        private function onLoaded(event:ModelEvent):void
        {
            noteReach(event.model);
            end(event.model);
        }

        private function end(model:Model):void
        {
            _counts.add("models loaded");
            if (model.name.indexOf("passing") == 0)
            {
                _greatLand.removeModel(model.name);
            }
        }

        private function onError(event:ErrorEvent):void
        {
            if (event.text.indexOf("there is no vertex 3") < 0)
            {
                throw new Error("a load that was to work failed: " + event.text);
            }
            _counts.add("loads failed, as they should");
        }

        private function load(loader:ModelLoader, name:String):void
        {
            var lathe:Lathe = newLathe();
            switch (_random.integer(0, 4))
            {
                case 0:
                    loader.loadText(name, BROKEN);
                    break;
                case 1:
                    loader.loadText(name, lathe.toObj());
                    break;
                case 2:
                    loader.loadBytes(name, encoded(lathe.toObj()), "y");
                    break;
                default:
                    takeAtOnce(ColladaModel.fromBytes(name, encoded(lathe.toCollada())));
            }
        }

        // In how many steps XML is read depends on the machine, and so would the frame in which a loader has it.
        private function takeAtOnce(model:Model):void
        {
            add(model);
            end(model);
        }

        private function newLathe():Lathe
        {
            return new Lathe(_random.chance(0.5) ? new SeededRandom(_random.integer(1, COMMON_SHAPES)) : _random);
        }

        private function chooseFlags():void
        {
            _greatLand.loadAllBoundingStructures = _random.chance(0.5);
            _greatLand.prepareExact = _random.chance(0.5);
        }

        private function add(model:Model):void
        {
            _greatLand.addModel(model);
            noteReach(model);
        }

        // A sphere or a capsule around a model reaches less than three times as far as the model does.
        private function noteReach(model:Model):void
        {
            var most:Number = 0;
            for (var i:int = 0; i < model.vertices.length; i += 3)
            {
                var x:Number = model.vertices[i];
                var y:Number = model.vertices[i + 1];
                var z:Number = model.vertices[i + 2];
                most = Math.max(most, x * x + y * y + z * z);
            }
            _reaches[model.name] = 3 * Math.sqrt(most);
        }

        // At random, so that no two boxes around some of them are flat and pass each other in a moment.
        private function cloud():Vector.<Number>
        {
            var points:Vector.<Number> = new Vector.<Number>();
            while (points.length < 120)
            {
                points.push(_random.between(0, 1));
            }
            return points;
        }
    }
}
