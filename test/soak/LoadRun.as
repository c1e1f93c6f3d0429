package soak
{
    import flash.display.Shape;
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import flash.events.EventDispatcher;
    import flash.utils.ByteArray;
    import headless.Host;
    import starlogo.GreatLand;
    import starlogo.models.ModelEvent;
    import starlogo.models.ModelLoader;

    /**
     * Loads files one after the other, and prints what each takes: milliseconds, the longest step, memory, and how it ended. Dispatches Event.COMPLETE.
     */
    public final class LoadRun extends EventDispatcher
    {
        /** How many models came. */
        public var models:int = 0;

        /** What went wrong with the others. */
        public var errors:Array = [];

        private var _names:Array;
        private var _make:Function;
        private var _prepareExact:Boolean;
        private var _shape:Shape = new Shape();
        private var _loader:ModelLoader;
        private var _name:String;
        private var _length:int;
        private var _start:Number;
        private var _startMemory:Number;
        private var _frames:int;

        /**
         * @param names of the files
         * @param make <code>function(name:String):Object</code>: a String, or a ByteArray
         * @param prepareExact as GreatLand's
         */
        public function LoadRun(names:Array, make:Function, prepareExact:Boolean = false)
        {
            _names = names.concat();
            _make = make;
            _prepareExact = prepareExact;
        }

        /** Begins. */
        public function start():void
        {
            trace("| file | MB | ms | longest step ms | frames | memory MB | outcome |");
            trace("|---|---|---|---|---|---|---|");
            _shape.addEventListener(Event.ENTER_FRAME, onFrame);
        }

        private function onFrame(event:Event):void
        {
            _frames++;
            if (_loader != null)
            {
                return;
            }
            if (_names.length == 0)
            {
                _shape.removeEventListener(Event.ENTER_FRAME, onFrame);
                dispatchEvent(new Event(Event.COMPLETE));
                return;
            }
            load(_names.shift());
        }

        private function load(name:String):void
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.prepareExact = _prepareExact;
            var file:Object = _make(name);
            var bytes:ByteArray = file as ByteArray;
            _name = name;
            _length = bytes == null ? String(file).length : bytes.length;
            _loader = new ModelLoader(greatLand);
            _loader.addEventListener(ModelEvent.LOADED, onLoaded);
            _loader.addEventListener(ErrorEvent.ERROR, onError);
            _startMemory = Host.memory;
            _frames = 0;
            _start = Host.now;
            if (bytes == null)
            {
                _loader.loadText("model", String(file));
            }
            else
            {
                _loader.loadBytes("model", bytes);
            }
        }

        private function onLoaded(event:ModelEvent):void
        {
            models++;
            report(event.model.vertices.length / 3 + " vertices, " +
                    (event.model.triangles == null ? 0 : event.model.triangles.length / 3) + " triangles");
        }

        private function onError(event:ErrorEvent):void
        {
            errors.push(event.text);
            report(event.text.substr(0, 160));
        }

        // The longest step is known when the frame has ended.
        private function report(outcome:String):void
        {
            var ms:Number = Host.now - _start;
            var loader:ModelLoader = _loader;
            loader.addEventListener(Event.COMPLETE, function(event:Event):void
                {
                    trace("| " + [_name, (_length / 1e6).toFixed(2), ms.toFixed(0), loader.longestStep, _frames,
                                ((Host.memory - _startMemory) / 1048576).toFixed(0), outcome].join(" | ") + " |");
                    _loader = null;
                });
        }
    }
}
