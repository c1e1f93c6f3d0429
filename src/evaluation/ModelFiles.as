package evaluation
{
    import flash.events.Event;
    import flash.events.IOErrorEvent;
    import flash.net.URLLoader;
    import flash.net.URLRequest;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ModelTransform;
    import starlogo.models.ObjModel;

    /**
     * Loads the thesis's twelve models: three built-in ones and nine from files. If the StarLogo Nova client's models are present
     * (test/models/nova.mjs), it loads them too. Those are the thesis's own files.
     */
    public final class ModelFiles
    {
        private static const FOLDER:String = "/assets/";
        private static const FILES:Array = ["bear.obj", "dragon.dae", "seagull.dae", "tree.obj", "kelp.obj", "fortress.obj",
                "spaceship.obj", "fireman.dae", "person.dae"];
        private static const NOVA:String = "/models/nova-thesis.json";

        /** The loaded models, by name. */
        public var models:Object = {};

        /** The StarLogo Nova client's models, by the same names. Empty if they are not present. */
        public var novaModels:Object = {};

        private var _pending:Array = [];
        private var _complete:Function;
        private var _failed:Function;

        /**
         * @param complete called without arguments when all are loaded
         * @param failed called with a text when one can't be loaded
         * @param hasNova whether the StarLogo Nova client's models are present
         */
        public function ModelFiles(complete:Function, failed:Function, hasNova:Boolean)
        {
            for each (var name:String in FILES)
            {
                _pending.push(FOLDER + name);
            }
            if (hasNova)
            {
                _pending.push(NOVA);
            }
            _complete = complete;
            _failed = failed;
            for each (var model:Model in [BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder()])
            {
                models[model.name] = model;
            }
            loadNext();
        }

        private function loadNext():void
        {
            if (_pending.length == 0)
            {
                _complete();
                return;
            }
            var file:String = _pending.shift();
            var loader:URLLoader = new URLLoader();
            loader.addEventListener(Event.COMPLETE, function(event:Event):void
                {
                    read(file, loader.data);
                    loadNext();
                });
            loader.addEventListener(IOErrorEvent.IO_ERROR, function(event:IOErrorEvent):void
                {
                    _failed("can't load " + file + ": " + event.text);
                });
            loader.load(new URLRequest(file));
        }

        private function read(file:String, text:String):void
        {
            if (file == NOVA)
            {
                readNova(JSON.parse(text));
                return;
            }
            var name:String = file.slice(FOLDER.length, file.indexOf("."));
            models[name] = file.slice(-4) == ".dae" ? new ColladaModel(name, text) : new ObjModel(name, text);
        }

        private function readNova(files:Object):void
        {
            for (var name:String in files)
            {
                novaModels[name] = new ObjModel(name, files[name].obj, ModelTransform.fromText(files[name].slb));
            }
        }
    }
}
