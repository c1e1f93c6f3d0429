package starlogo.libraries
{
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.geometry.Fingerprint;
    import starlogo.geometry.GeometryFingerprint;
    import starlogo.libraries.cooked.FitsReader;
    import starlogo.libraries.cooked.FitsWriter;
    import starlogo.libraries.cooked.StoreIndex;
    import starlogo.libraries.cooked.TreeWriter;
    import starlogo.models.Model;
    import starlogo.models.cooked.CookedFile;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * Keeps the results computed for models from one game to the next (thesis §7.9). So each machine computes them only once. Give it to a
     * GreatLand: the GreatLand looks here before it computes, and stores new results here.
     *
     * <p>An entry is found by the model's geometry and all settings that matter. The model's name does not matter. Every entry is checked
     * like a cooked file. A changed, incomplete or forged entry is ignored and replaced. If there is not enough room, the least recently
     * used entries are removed. If nothing can be stored, games still work.</p>
     *
     * <p>Several games may share a storage at the same time, for example in several tabs. Each entry is stored separately, so no game
     * overwrites another's entries. If two games write the list of entries at the same time, an entry may be missing from the list until
     * its next use.</p>
     */
    public final class FitStore
    {
        /** The default capacity, in bytes. Flash Player lets a site store 100 KB without asking the user. */
        public static const DEFAULT_CAPACITY:int = 90000;

        private static const INDEX:String = "index";

        private var _storage:FitStorage;
        private var _capacity:Number;
        private var _isOff:Boolean = false;

        /**
         * Creates a store of a given size.
         *
         * @param capacity the most bytes to keep, 0 or more
         * @param storage where to keep them; null for the player's shared objects, or the page's local storage
         * @throws RangeError if the capacity is negative or not a number
         */
        public function FitStore(capacity:Number = DEFAULT_CAPACITY, storage:FitStorage = null)
        {
            if (!(capacity >= 0))
            {
                throw new RangeError("the capacity must be 0 bytes or more, not " + capacity);
            }
            _capacity = capacity;
            _storage = storage == null ? new SharedFitStorage() : storage;
        }

        /** The most bytes that it keeps. */
        public function get capacity():Number
        {
            return _capacity;
        }

        /** The number of bytes that it has now. */
        public function get length():Number
        {
            return readIndex().total;
        }

        /**
         * Reads the fits of a model, at once.
         *
         * @param model the model
         * @param settings the settings of the wanted fits
         * @return null if there are none, or they are damaged
         * @throws ArgumentError if one argument is null
         */
        public function read(model:Model, settings:FitSettings):ModelFits
        {
            var fits:ModelFits = new ModelFits();
            finish(reading(model, geometryOf(model, settings), settings, fits));
            return fits.structures == null && fits.tree == null ? null : fits;
        }

        /**
         * Stores the fits of a model. They replace those stored for the same settings.
         *
         * @param model the model
         * @param settings the settings with which they were computed
         * @param fits the fits
         * @return whether they are stored
         * @throws ArgumentError if one argument is null
         */
        public function write(model:Model, settings:FitSettings, fits:ModelFits):Boolean
        {
            if (fits == null)
            {
                throw new ArgumentError("the fits must not be null");
            }
            var geometry:GeometryFingerprint = geometryOf(model, settings);
            finish(geometry);
            return keep(geometry.fingerprint, settings, fits);
        }

        /** Removes all entries. */
        public function clear():void
        {
            for each (var name:String in readIndex().names)
            {
                _storage.remove(name);
            }
            _storage.remove(INDEX);
        }

        /**
         * Reads the fits of a model, in steps.
         *
         * @param model the model
         * @param geometry the fingerprint of the model; none of its steps is done yet
         * @param settings the settings of the wanted fits
         * @param fits takes the results; it keeps what it already has
         *
         * @private
         */
        engine function reading(model:Model, geometry:GeometryFingerprint, settings:FitSettings, fits:ModelFits):Steps
        {
            var file:CookedFile;
            return new StepSequence().add(geometry).begin(function():Steps
                {
                    file = new CookedFile(bytesOf(geometry.fingerprint, settings));
                    return file;
                }).call(function():void
                {
                    if (file.isFor(geometry.fingerprint))
                    {
                        FitsReader.read(file, model, settings, fits);
                    }
                });
        }

        // null if there are none
        private function bytesOf(geometry:Fingerprint, settings:FitSettings):ByteArray
        {
            var name:String = nameOf(geometry, settings);
            var bytes:ByteArray = _storage.read(name);
            if (bytes != null)
            {
                var index:StoreIndex = readIndex();
                index.put(name, bytes.length);
                _storage.write(INDEX, index.toBytes());
            }
            return bytes;
        }

        /**
         * Whether there may be room for the fits of a model.
         *
         * @private
         */
        engine function mayHold(model:Model):Boolean
        {
            var itemCount:int = (model.triangles == null ? model.vertices.length : model.triangles.length) / 3;
            return !_isOff && itemCount * TreeWriter.widthFor(itemCount) <= _capacity;
        }

        /**
         * Stores the fits of a geometry.
         *
         * @return whether they are stored
         *
         * @private
         */
        engine function keep(geometry:Fingerprint, settings:FitSettings, fits:ModelFits):Boolean
        {
            var bytes:ByteArray = FitsWriter.write(fits, settings, geometry);
            if (_isOff || bytes.length > _capacity)
            {
                return false;
            }
            var name:String = nameOf(geometry, settings);
            var index:StoreIndex = readIndex();
            index.remove(name);
            while (index.total + bytes.length > _capacity)
            {
                drop(index);
            }
            var isKept:Boolean = _storage.write(name, bytes);
            while (!isKept && index.names.length > 0)
            {
                drop(index);
                isKept = _storage.write(name, bytes);
            }
            // there is no room even for one entry
            _isOff = !isKept;
            if (isKept)
            {
                index.put(name, bytes.length);
            }
            _storage.write(INDEX, index.toBytes());
            return isKept;
        }

        private function drop(index:StoreIndex):void
        {
            var oldest:String = index.names[0];
            _storage.remove(oldest);
            index.remove(oldest);
        }

        private function readIndex():StoreIndex
        {
            return StoreIndex.read(_storage.read(INDEX));
        }

        private static function nameOf(geometry:Fingerprint, settings:FitSettings):String
        {
            return geometry.toString() + settings.toString();
        }

        /**
         * The fingerprint by which a model is found. None of its steps is done yet.
         *
         * @private
         */
        engine function geometryOf(model:Model, settings:FitSettings):GeometryFingerprint
        {
            if (model == null || settings == null)
            {
                throw new ArgumentError("the model and the settings must not be null: " + model + ", " + settings);
            }
            return new GeometryFingerprint(model.vertices, model.triangles);
        }
    }
}
