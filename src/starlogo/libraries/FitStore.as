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
     * Keeps from one game to the next what was computed for models (thesis §7.9), so that a machine computes it once: a
     * GreatLand that has one asks it before it computes, and gives it what it had to compute.
     *
     * <p>An entry is found by the geometry of a model, whatever its name, and by every setting that matters. What comes back is
     * checked as a cooked file is: an entry that was changed, cut off or forged is ignored, and replaced. Where there is no room, the
     * entries that were not used for longest go; where nothing can be kept, games work without.</p>
     *
     * <p>Several games at once, in several tabs say, may share a storage. Each entry is stored separately, so that no game overwrites the entries
     * of another; if two write the list of entries at the same time, one entry may be missing from it until it is used the next time.</p>
     */
    public final class FitStore
    {
        /** How many bytes of fits are kept unless told. Flash Player lets a site have 100 KB unasked. */
        public static const DEFAULT_CAPACITY:int = 90000;

        private static const INDEX:String = "index";

        private var _storage:FitStorage;
        private var _capacity:Number;
        private var _isOff:Boolean = false;

        /**
         * A store of a certain size.
         *
         * @param capacity how many bytes to keep at most
         * @param storage where; null for the player's shared objects, or the page's local storage
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

        /** How many bytes are kept at most. */
        public function get capacity():Number
        {
            return _capacity;
        }

        /** How many bytes are kept. */
        public function get length():Number
        {
            return readIndex().total;
        }

        /**
         * What is kept of a model, at once.
         *
         * @param model the model
         * @param settings what it is wanted for
         * @return null if nothing is kept, or what is kept is damaged
         * @throws ArgumentError if one of the two is null
         */
        public function read(model:Model, settings:FitSettings):ModelFits
        {
            var fits:ModelFits = new ModelFits();
            finish(reading(model, geometryOf(model, settings), settings, fits));
            return fits.structures == null && fits.tree == null ? null : fits;
        }

        /**
         * Keeps fits of a model, in place of what was kept of it for the same settings.
         *
         * @param model the model
         * @param settings what they were computed with
         * @param fits what was computed
         * @return whether they are kept now
         * @throws ArgumentError if one of the three is null
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

        /** Forgets everything. */
        public function clear():void
        {
            for each (var name:String in readIndex().names)
            {
                _storage.remove(name);
            }
            _storage.remove(INDEX);
        }

        /**
         * Reads in steps what is kept of a model.
         *
         * @param model the model
         * @param geometry what it is found by, not begun
         * @param settings what it is wanted for
         * @param fits gets what is kept; what it has already stays
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
         * Whether fits of a model may have room.
         *
         * @private
         */
        engine function mayHold(model:Model):Boolean
        {
            var itemCount:int = (model.triangles == null ? model.vertices.length : model.triangles.length) / 3;
            return !_isOff && itemCount * TreeWriter.widthFor(itemCount) <= _capacity;
        }

        /**
         * Keeps what was computed for a geometry.
         *
         * @return whether they are kept now
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
            // there is no room for even one
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
         * What a model is found by, not begun.
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
