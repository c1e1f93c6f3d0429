package starlogo.models
{
    import flash.display.Shape;
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import flash.events.EventDispatcher;
    import flash.events.ProgressEvent;
    import flash.net.URLLoader;
    import flash.utils.ByteArray;
    import flash.utils.getTimer;

    /** A model is loaded: agents may have its shape. @eventType starlogo.models.ModelEvent.LOADED */
    [Event(name="modelLoaded", type="starlogo.models.ModelEvent")]

    /**
     * A model can't be loaded: the text names it and says why. The others go on. @eventType
     * flash.events.ErrorEvent.ERROR
     */
    [Event(name="error", type="flash.events.ErrorEvent")]

    /**
     * Once a frame while there is work: <code>bytesLoaded</code> of <code>bytesTotal</code> hundredths of models are
     * done, of all since the loader was last idle. @eventType flash.events.ProgressEvent.PROGRESS
     */
    [Event(name="progress", type="flash.events.ProgressEvent")]

    /** No model is left to load, whether all were loaded or not. @eventType flash.events.Event.COMPLETE */
    [Event(name="complete", type="flash.events.Event")]

    /** All loads were cancelled. @eventType flash.events.Event.CANCEL */
    [Event(name="cancel", type="flash.events.Event")]

    /**
     * Loads models while a game runs: fetches their files, reads them and hands them to a receiver, in steps that leave
     * the frames their time.
     *
     * <p>Models wait in a queue and are worked on in its order, each as soon as its file is there. Every frame the loader
     * works for about <code>budget</code> milliseconds. It can't stop within a step: most take less than a millisecond,
     * the longest for a file of 5,000 vertices a few.</p>
     *
     * <p>A loader that has work need not be kept: it stays alive until that is done or cancelled.</p>
     *
     * <p>Where a manifest says that a model was cooked when the game was built, that is fetched in place of its source: see
     * <code>manifest</code>.</p>
     *
     * <p>The reader is chosen by content: OBJ, glTF (JSON, with its data inside or beside it, or binary), STL (text or binary), COLLADA, or that in a
     * zip archive. Only where the content says nothing the name does. Agents may have a shape from when its ModelEvent comes; before that the
     * collision systems do not know it.</p>
     *
     * @example
     * <listing version="3.0">
     * var loader:ModelLoader = new ModelLoader(greatLand);
     * loader.addEventListener(Event.COMPLETE, startGame);
     * loader.addEventListener(ErrorEvent.ERROR, showError);
     * loader.load("bear", "assets/bear.obj");
     * </listing>
     */
    public class ModelLoader extends EventDispatcher
    {
        // its listeners are the loaders that have work: static, so that they are not collected with what they are doing
        private static var sFrames:Shape = new Shape();

        /**
         * Whether <code>load()</code> asks for a transform file beside the model's too, as the StarLogo Nova client has them:
         * <code>bear.slb</code> beside <code>bear.obj</code>. What is in it, a ModelTransform, stands in place of the up axis; one that is not
         * there, or says nothing, is no error. It is not asked for where <code>load()</code> gets a ModelTransform.
         */
        public var usesTransforms:Boolean = false;

        private var _receiver:ModelReceiver;
        private var _budget:Number;
        private var _queue:Vector.<ModelLoad> = new Vector.<ModelLoad>();
        private var _isWorking:Boolean = false;
        private var _doneCount:int = 0;
        private var _manifest:ModelManifest = null;
        private var _longestFrame:int = 0;
        private var _longestStep:int = 0;

        /**
         * A loader that has nothing to do yet.
         *
         * @param receiver takes the models in
         * @param budget milliseconds of work a frame
         * @throws ArgumentError if the receiver is null
         * @throws RangeError if the budget is negative or not a number
         */
        public function ModelLoader(receiver:ModelReceiver, budget:Number = 8)
        {
            if (receiver == null)
            {
                throw new ArgumentError("the receiver of the models must not be null: a GreatLand, say");
            }
            _receiver = receiver;
            this.budget = budget;
        }

        /** Whether any loader has work. */
        internal static function get isAnyWorking():Boolean
        {
            return sFrames.hasEventListener(Event.ENTER_FRAME);
        }

        /**
         * Milliseconds of work a frame. At 0 it is one step a frame.
         *
         * @throws RangeError if it is set to what is negative or not a number
         */
        public function get budget():Number
        {
            return _budget;
        }

        public function set budget(value:Number):void
        {
            if (!(value >= 0))
            {
                throw new RangeError("the budget must be 0 milliseconds a frame or more, not " + value);
            }
            _budget = value;
        }

        /**
         * Where the list is of what <code>./antw bake</code> or <code>starlogo-bake</code> made of models, "assets/manifest.json", say; null, the
         * default, for none. It is fetched once. For a file that it names, in its folder or below, <code>load()</code> fetches what was cooked, a
         * model with all that the receiver would compute, and nothing else. Where that is not there, damaged, or for another up axis,
         * transform or scaling than asked for, the model's own file is read as without a manifest; a list that can't be fetched or read
         * names nothing.
         */
        public function get manifest():String
        {
            return _manifest == null ? null : _manifest.url;
        }

        public function set manifest(value:String):void
        {
            _manifest = value == null ? null : new ModelManifest(value);
        }

        /** How many models are not loaded yet. */
        public function get pendingCount():int
        {
            return _queue.length;
        }

        /** The longest time it has worked in one frame so far, in milliseconds. */
        public function get longestFrame():int
        {
            return _longestFrame;
        }

        /** The longest time that a single step has taken so far, in milliseconds: that of a slow fitter, perhaps. */
        public function get longestStep():int
        {
            return _longestStep;
        }

        /** Whether a model of a name is being loaded: asked for, but not loaded yet. */
        public function isPending(name:String):Boolean
        {
            return _queue.some(function(pending:ModelLoad, i:int, all:Vector.<ModelLoad>):Boolean
                {
                    return pending.name == name;
                });
        }

        /**
         * Loads a model from a file. What goes wrong comes as an ErrorEvent.
         *
         * @param name what agents call the shape
         * @param url where the file is: OBJ, glTF, STL, COLLADA, zipped COLLADA or cooked
         * @param upAxis the axis that points up in an OBJ or STL file: "x", "y" or "z"; or, for any file, a ModelTransform
         * @param scaling as for <code>Model</code>
         */
        public function load(name:String, url:String, upAxis:Object = "z", scaling:String = "footprint"):void
        {
            add(name, upAxis, scaling).fetch(url, usesTransforms, _manifest);
        }

        /**
         * Loads a model from a file's bytes.
         *
         * @param name what agents call the shape
         * @param bytes the whole file: OBJ, glTF, STL, COLLADA, zipped COLLADA or cooked; not to be changed until the model is loaded
         * @param upAxis the axis that points up in an OBJ or STL file: "x", "y" or "z"; or, for any file, a ModelTransform
         * @param scaling as for <code>Model</code>
         */
        public function loadBytes(name:String, bytes:ByteArray, upAxis:Object = "z", scaling:String = "footprint"):void
        {
            add(name, upAxis, scaling).setFile(bytes, null);
        }

        /**
         * Loads a model from text.
         *
         * @param name what agents call the shape
         * @param text OBJ, glTF, STL or COLLADA
         * @param upAxis the axis that points up in OBJ or STL text: "x", "y" or "z"; or, for any text, a ModelTransform
         * @param scaling as for <code>Model</code>
         */
        public function loadText(name:String, text:String, upAxis:Object = "z", scaling:String = "footprint"):void
        {
            add(name, upAxis, scaling).setFile(null, text);
        }

        /**
         * Loads a model that a client's own source makes.
         *
         * @param source not begun yet; its steps should take a few milliseconds at most
         * @throws ArgumentError if it is null
         */
        public function loadFrom(source:ModelSource):void
        {
            if (source == null)
            {
                throw new ArgumentError("the source of the model must not be null");
            }
            add(source.name, "z", Model.FOOTPRINT).setSource(source);
        }

        /**
         * Forgets the loads of one name, or all. What they have done so far is undone; models that are loaded stay.
         *
         * @param name the name; null for all
         */
        public function cancel(name:String = null):void
        {
            for (var i:int = _queue.length - 1; i >= 0; i--)
            {
                if (name == null || _queue[i].name == name)
                {
                    drop(_queue[i]);
                }
            }
        }

        /** Forgets one load, if it is not over. */
        internal function drop(load:ModelLoad):void
        {
            if (!remove(load))
            {
                return;
            }
            load.cancel();
            tell(load, null, null);
            if (_queue.length == 0)
            {
                rest();
                dispatchEvent(new Event(Event.CANCEL));
            }
        }

        /** Fetches one file. */
        internal function newURLLoader():URLLoader
        {
            return new URLLoader();
        }

        /** The time, in milliseconds. */
        internal function now():int
        {
            return getTimer();
        }

        private function add(name:String, upAxis:Object, scaling:String):ModelLoad
        {
            var added:ModelLoad = new ModelLoad(name, upAxis, scaling, _receiver, newURLLoader);
            _receiver.expect(name);
            _queue.push(added);
            sFrames.addEventListener(Event.ENTER_FRAME, onFrame);
            _isWorking = true;
            return added;
        }

        private function rest():void
        {
            sFrames.removeEventListener(Event.ENTER_FRAME, onFrame);
            _isWorking = false;
            _doneCount = 0;
        }

        private function onFrame(event:Event):void
        {
            var start:int = now();
            var time:int = start;
            var next:ModelLoad = nextReady();
            while (next != null)
            {
                var before:int = time;
                work(next);
                time = now();
                _longestStep = Math.max(_longestStep, time - before);
                next = time - start < _budget ? nextReady() : null;
            }
            _longestFrame = Math.max(_longestFrame, time - start);
            report();
        }

        private function nextReady():ModelLoad
        {
            for each (var pending:ModelLoad in _queue)
            {
                if (pending.isReady)
                {
                    return pending;
                }
            }
            return null;
        }

        /** Does a step; whatever goes wrong in it ends this load, not the others. */
        private function work(load:ModelLoad):void
        {
            var hasMore:Boolean = false;
            var problem:Error = null;
            try
            {
                hasMore = load.step();
            }
            catch (error:Error)
            {
                problem = error is ModelError ? error : new ModelError(load.name, "", "it can't be taken in: " + error.message);
            }
            if (!hasMore && remove(load)) // a step may have cancelled its own load
            {
                _doneCount++;
                var isTold:Boolean = tell(load, problem == null ? load.model : null, problem);
                if (problem == null)
                {
                    dispatchEvent(new ModelEvent(ModelEvent.LOADED, load.model));
                }
                else if (!isTold || hasEventListener(ErrorEvent.ERROR))
                {
                    dispatchEvent(new ErrorEvent(ErrorEvent.ERROR, false, false, problem.message));
                }
            }
        }

        // Whether there is a function to tell.
        private static function tell(load:ModelLoad, model:Model, problem:Error):Boolean
        {
            if (load.whenOver != null)
            {
                load.whenOver(model, problem);
            }
            return load.whenOver != null;
        }

        // Whether it was still there.
        private function remove(load:ModelLoad):Boolean
        {
            var place:int = _queue.indexOf(load);
            if (place >= 0)
            {
                _queue.splice(place, 1);
                _receiver.expectNoMore(load.name);
            }
            return place >= 0;
        }

        private function report():void
        {
            if (!_isWorking)
            {
                return; // a handler has cancelled the rest
            }
            var done:Number = _doneCount;
            for each (var pending:ModelLoad in _queue)
            {
                done += pending.progress;
            }
            var total:Number = 100 * (_doneCount + _queue.length);
            dispatchEvent(new ProgressEvent(ProgressEvent.PROGRESS, false, false, Math.floor(100 * done), total));
            if (_queue.length == 0 && _isWorking)
            {
                rest();
                dispatchEvent(new Event(Event.COMPLETE));
            }
        }
    }
}
