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
    import starlogo.data.requireGiven;
    import starlogo.models.building.ModelData;
    import starlogo.models.files.ModelFile;
    import starlogo.models.files.refuseModelIf;
    import starlogo.models.loading.CookedManifest;
    import starlogo.models.loading.ModelLoad;

    /** A model is loaded. From now on agents that have its shape collide. @eventType starlogo.models.ModelEvent.LOADED */
    [Event(name="modelLoaded", type="starlogo.models.ModelEvent")]

    /**
     * A model can't be loaded. The text names the model and says why. The other models go on loading. @eventType
     * flash.events.ErrorEvent.ERROR
     */
    [Event(name="error", type="flash.events.ErrorEvent")]

    /**
     * Sent every frame while there is work. <code>bytesLoaded</code> is the work done and <code>bytesTotal</code> is all work since the
     * loader last had no work. Both are in hundredths of a model. @eventType flash.events.ProgressEvent.PROGRESS
     */
    [Event(name="progress", type="flash.events.ProgressEvent")]

    /** No model is left to load. Some were loaded or have failed; others may have been cancelled. @eventType flash.events.Event.COMPLETE */
    [Event(name="complete", type="flash.events.Event")]

    /** No model is left to load, because all loads were cancelled: none was loaded, and none has failed. @eventType flash.events.Event.CANCEL */
    [Event(name="cancel", type="flash.events.Event")]

    /**
     * Loads models while a game runs. It fetches their files, reads them and gives them to a receiver, for example a GreatLand. The work is
     * split into short steps, so the game keeps its frame rate.
     *
     * <p>Models wait in a queue. The loader works on them in order, each as soon as its file has arrived. In every frame it works for
     * about <code>budget</code> milliseconds. It can't stop within a step. Most steps take less than a millisecond; the longest steps for
     * a file of 5,000 vertices take a few milliseconds.</p>
     *
     * <p>You need not keep a reference to a loader that has work. It stays alive until the work is done or cancelled.</p>
     *
     * <p>If a manifest lists a cooked file for a model, the loader fetches that file instead of the source: see <code>manifest</code>.</p>
     *
     * <p>The loader chooses the reader by the file's content: OBJ, glTF (JSON or binary, its data inside or beside it), STL (text or
     * binary), COLLADA or cooked. The file's name decides only if the content does not tell. Agents may have a shape as soon as its
     * load begins. They collide with nothing until its ModelEvent is sent.</p>
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
        /** @private Loaders that have work listen to it. It is static, so such loaders are not garbage-collected. */
        internal static var sFrames:Shape = new Shape();

        /**
         * Whether <code>load()</code> also asks for a transform file beside the model's file, as in the StarLogo Nova client:
         * <code>bear.slb</code> beside <code>bear.obj</code>. Its ModelTransform replaces the up axis. A missing or empty transform file is
         * no error. If you pass a ModelTransform to <code>load()</code>, no transform file is fetched.
         */
        public var usesTransforms:Boolean = false;

        private var _receiver:ModelReceiver;
        private var _budget:Number;

        // The loads that are not over, in the order in which they were added.
        private var _loads:Vector.<ModelLoad> = new Vector.<ModelLoad>();
        private var _doneCount:int = 0;

        // Within a frame. What a listener does then ends no work before the other listeners have heard.
        private var _isInFrame:Boolean = false;
        private var _manifest:CookedManifest = null;
        private var _longestFrame:int = 0;
        private var _longestStep:int = 0;

        /**
         * Creates a loader without work.
         *
         * @param receiver takes the loaded models
         * @param budget milliseconds of work per frame; 0 or more
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

        /**
         * Milliseconds of work per frame. If it is 0, the loader does one step per frame.
         *
         * @throws RangeError if you set it to a negative value or NaN
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
         * The address of the list of cooked files, for example "assets/manifest.json". <code>./antw cook</code> or
         * <code>starlogo-cook</code> makes it. The default is null: no list. It is fetched once. If it lists a file in its folder or
         * below, <code>load()</code> fetches only the cooked file. It contains the model and all results that the receiver would compute.
         * If the cooked file is missing, damaged, or made for another up axis, transform or scaling, the model's own file is read
         * instead. A list that can't be fetched or read counts as empty.
         */
        public function get manifest():String
        {
            return _manifest == null ? null : _manifest.url;
        }

        public function set manifest(value:String):void
        {
            _manifest = value == null ? null : new CookedManifest(value);
        }

        /** The number of models that are not loaded yet. */
        public function get pendingCount():int
        {
            return _loads.length;
        }

        /** The longest time it has worked in one frame so far, in milliseconds. */
        public function get longestFrame():int
        {
            return _longestFrame;
        }

        /** The longest time that a single step has taken so far, in milliseconds. A slow fitter can be the cause. */
        public function get longestStep():int
        {
            return _longestStep;
        }

        /** Whether a model of this name is requested but not loaded yet. */
        public function isPending(name:String):Boolean
        {
            return _loads.some(function(load:ModelLoad, index:int, all:Vector.<ModelLoad>):Boolean
                {
                    return load.name == name;
                });
        }

        /**
         * Loads a model from a file. If the file is missing or no model, an ErrorEvent is sent. An error of the arguments is thrown at once, and
         * changes nothing.
         *
         * @param name what agents call the shape
         * @param url the file's address: OBJ, glTF, STL, COLLADA or cooked
         * @param upAxis the axis that points up in an OBJ or STL file: "x", "y" or "z"; or, for any file, a ModelTransform
         * @param scaling as for <code>Model</code>
         * @throws ArgumentError if the name is null or empty, if the address is null or empty, or if the axis or the scaling is none of these
         */
        public function load(name:String, url:String, upAxis:Object = "z", scaling:String = "footprint"):void
        {
            // the default of scaling is written out, because compilers may come to this class before they know the constants of Model
            add(name, url || null, upAxis, scaling).fetch(url, usesTransforms, _manifest);
        }

        /**
         * Loads a model from a file's bytes.
         *
         * @param name what agents call the shape
         * @param bytes the whole file: OBJ, glTF, STL, COLLADA or cooked; do not change it until the model is loaded
         * @param upAxis the axis that points up in an OBJ or STL file: "x", "y" or "z"; or, for any file, a ModelTransform
         * @param scaling as for <code>Model</code>
         * @throws ArgumentError if the name is null or empty, if the bytes are null, or if the axis or the scaling is none of these
         */
        public function loadBytes(name:String, bytes:ByteArray, upAxis:Object = "z", scaling:String = "footprint"):void
        {
            add(name, bytes, upAxis, scaling).addReadSteps(new ModelFile(name, bytes));
        }

        /**
         * Loads a model from text.
         *
         * @param name what agents call the shape
         * @param text OBJ, glTF, STL or COLLADA
         * @param upAxis the axis that points up in OBJ or STL text: "x", "y" or "z"; or, for any text, a ModelTransform
         * @param scaling as for <code>Model</code>
         * @throws ArgumentError if the name is null or empty, if the text is null, or if the axis or the scaling is none of these
         */
        public function loadText(name:String, text:String, upAxis:Object = "z", scaling:String = "footprint"):void
        {
            add(name, text, upAxis, scaling).addReadSteps(new ModelFile(name, null, text));
        }

        /**
         * Loads a model that a class of your own makes.
         *
         * @param maker none of its steps is done yet; each step should take a few milliseconds at most
         * @throws ArgumentError if the maker is null, or its name is null or empty
         */
        public function loadFrom(maker:ModelMaker):void
        {
            requireGiven("the maker of the model", maker);
            add(maker.name, maker).addMakeSteps(maker);
        }

        /**
         * Cancels the loads of one name, or all loads. Their work so far is undone. Loaded models stay.
         *
         * @param name the name; null for all
         */
        public function cancel(name:String = null):void
        {
            for each (var load:ModelLoad in _loads.concat().reverse())
            {
                if (name == null || load.name == name)
                {
                    drop(load);
                }
            }
        }

        /** @private Cancels one load, if it is not over. For the promises of the ES module. */
        internal function drop(load:ModelLoad):void
        {
            if (!remove(load))
            {
                return;
            }
            _receiver.expectNoMore(load.name);
            load.cancel();
            if (load.whenOver != null)
            {
                load.whenOver(null, null);
            }
            if (_loads.length == 0 && !_isInFrame)
            {
                end();
            }
        }

        /** @private Creates a loader for one file. Tests override it. */
        internal function newURLLoader():URLLoader
        {
            return new URLLoader();
        }

        /** @private The time, in milliseconds. Tests override it. */
        internal function now():int
        {
            return getTimer();
        }

        private function add(name:String, source:Object, upAxis:Object = "z", scaling:String = "footprint"):ModelLoad
        {
            requireArguments(name, source, upAxis, scaling);
            var added:ModelLoad = new ModelLoad(name, upAxis, scaling, _receiver, newURLLoader);
            _receiver.expect(name);
            _loads.push(added);
            sFrames.addEventListener(Event.ENTER_FRAME, onFrame);
            return added;
        }

        // A mistake of the program is refused at once. Those of files are told by events.
        private static function requireArguments(name:String, source:Object, upAxis:Object, scaling:String):void
        {
            try
            {
                refuseModelIf(!name, name, "a model needs a name that is not empty");
                refuseModelIf(source == null, name, "there is nothing to load: the argument after the name is null, or an empty address");
                ModelData.requireUpAxis(name, upAxis);
                ModelData.requireScaling(name, scaling);
            }
            catch (problem:ModelError)
            {
                throw new ArgumentError(problem.message);
            }
        }

        // Says that no work is left.
        private function end():void
        {
            var type:String = _doneCount > 0 ? Event.COMPLETE : Event.CANCEL;
            sFrames.removeEventListener(Event.ENTER_FRAME, onFrame);
            _doneCount = 0;
            dispatchEvent(new Event(type));
        }

        private function onFrame(event:Event):void
        {
            var start:int = now();
            var time:int = start;
            var next:ModelLoad = nextReady();
            _isInFrame = true;
            while (next != null)
            {
                var before:int = time;
                stepLoad(next);
                time = now();
                _longestStep = Math.max(_longestStep, time - before);
                next = time - start < _budget ? nextReady() : null;
            }
            _longestFrame = Math.max(_longestFrame, time - start);
            reportProgress();
            _isInFrame = false;
            if (_loads.length == 0)
            {
                end();
            }
        }

        private function nextReady():ModelLoad
        {
            for each (var load:ModelLoad in _loads)
            {
                if (load.isReady)
                {
                    return load;
                }
            }
            return null;
        }

        // Does one step. An error ends this load only.
        private function stepLoad(load:ModelLoad):void
        {
            var hasMore:Boolean = false;
            var problem:Error = null;
            try
            {
                hasMore = load.step();
            }
            catch (error:Error)
            {
                problem = error is ModelError ? error : new ModelError(load.name, "", "it can't be added: " + error.message);
            }
            if (!hasMore && remove(load)) // the step may have cancelled its own load
            {
                _doneCount++;
                _receiver.expectNoMore(load.name, problem == null ? null : problem.message);
                if (load.whenOver != null)
                {
                    load.whenOver(problem == null ? load.model : null, problem);
                }
                if (problem == null)
                {
                    dispatchEvent(new ModelEvent(ModelEvent.LOADED, load.model));
                }
                else if (load.whenOver == null || hasEventListener(ErrorEvent.ERROR))
                {
                    dispatchEvent(new ErrorEvent(ErrorEvent.ERROR, false, false, problem.message));
                }
            }
        }

        // Returns whether the load was still in the queue.
        private function remove(load:ModelLoad):Boolean
        {
            var index:int = _loads.indexOf(load);
            if (index >= 0)
            {
                _loads.splice(index, 1);
            }
            return index >= 0;
        }

        private function reportProgress():void
        {
            if (_loads.length + _doneCount == 0)
            {
                return; // a step has cancelled all loads
            }
            var done:Number = _doneCount;
            for each (var load:ModelLoad in _loads)
            {
                done += load.progress;
            }
            var total:Number = 100 * (_doneCount + _loads.length);
            dispatchEvent(new ProgressEvent(ProgressEvent.PROGRESS, false, false, Math.floor(100 * done), total));
        }
    }
}
