package evaluation
{
    import flash.events.Event;
    import flash.events.IOErrorEvent;
    import flash.net.URLLoader;
    import flash.net.URLRequest;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;

    /** Loads the thesis's twelve models: three built-in ones, and nine from files. */
    public final class ModelFiles
    {
        private static const FOLDER:String = "/assets/";
        private static const FILES:Array = ["bear.obj", "dragon.dae", "seagull.dae", "tree.obj", "kelp.obj", "fortress.obj",
                "spaceship.obj", "fireman.dae", "person.dae"];

        /** The models that are loaded, by name. */
        public var models:Object = {};

        private var _pending:Array = FILES.concat();
        private var _complete:Function;
        private var _failed:Function;

        /**
         * @param complete called without arguments when all are loaded
         * @param failed called with a text when one can't be
         */
        public function ModelFiles(complete:Function, failed:Function)
        {
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
                    _failed("can't load " + FOLDER + file + ": " + event.text);
                });
            loader.load(new URLRequest(FOLDER + file));
        }

        private function read(file:String, text:String):void
        {
            var name:String = file.slice(0, file.indexOf("."));
            models[name] = file.slice(-4) == ".dae" ? new ColladaModel(name, text) : new ObjModel(name, text);
        }
    }
}
