package starlogo.libraries
{
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.geometry.Fingerprint;
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
     * <p>An entry is a cooked file without the model. It is found by the model's geometry and all settings that matter. The model's name
     * does not matter. A changed, incomplete or forged entry is ignored and replaced. If there is not enough room, the least recently used
     * entries are removed. If nothing can be stored, games still work.</p>
     *
     * <p>Several games may share a storage at the same time, for example in several tabs. Each entry is stored separately, so no game
     * overwrites another's entries. If two games write the list of entries at the same time, an entry may be missing from the list until
     * its next use.</p>
     */
    public final class FitStore
    {
        /** The default capacity, in bytes. Flash Player lets a site store 100 KB without asking the user. */
        public static const DEFAULT_CAPACITY:int = 90000;

        // The list of entries is a text. It has a line for each entry, the least recently used one first: the name, and the length in bytes.
        private static const LIST:String = "index";
        private static const ENTRIES:RegExp = /[0-9a-f]{32} \d{1,9}\n/g;
        private static const NAME_LENGTH:int = 32;

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
            _storage = storage || new SharedFitStorage();
        }

        /** The most bytes that it keeps. */
        public function get capacity():Number
        {
            return _capacity;
        }

        /** The number of bytes that it has now. */
        public function get length():Number
        {
            return lengthOf(entriesBut(null));
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
            check(model, settings);
            var fits:ModelFits = new ModelFits();
            finish(reading(model, new Fingerprint(), settings, fits));
            return fits.hasStructures || fits.hasHierarchy ? fits : null;
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
            check(model, settings);
            var geometry:Fingerprint = new Fingerprint();
            finish(geometry.addingGeometry(model.vertices, model.triangles));
            return keep(geometry, settings, fits);
        }

        /** Removes all entries. */
        public function clear():void
        {
            for each (var entry:String in entriesBut(null))
            {
                _storage.remove(nameIn(entry));
            }
            _storage.remove(LIST);
        }

        /**
         * Reads the fits of a model, in steps.
         *
         * @param model the model
         * @param geometry receives the fingerprint of the model
         * @param settings the settings of the wanted fits
         * @param fits takes the results; it keeps what it already has
         *
         * @private
         */
        engine function reading(model:Model, geometry:Fingerprint, settings:FitSettings, fits:ModelFits):Steps
        {
            var file:CookedFile;
            return new StepSequence().add(geometry.addingGeometry(model.vertices, model.triangles)).begin(function():Steps
                {
                    var name:String = nameOf(geometry, settings);
                    var bytes:ByteArray = _storage.read(name);
                    if (bytes != null)
                    {
                        list(entriesBut(name), name, bytes);
                    }
                    file = new CookedFile(bytes);
                    return file;
                }).call(function():void
                {
                    if (file.isFor(geometry))
                    {
                        fits.readFrom(file, model, settings);
                    }
                });
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
            var bytes:ByteArray = fits.toFile(settings, geometry);
            if (_isOff || bytes.length > _capacity)
            {
                return false;
            }
            var name:String = nameOf(geometry, settings);
            var others:Array = entriesBut(name);
            var isKept:Boolean = lengthOf(others) + bytes.length <= _capacity && _storage.write(name, bytes);
            while (!isKept && others.length > 0)
            {
                _storage.remove(nameIn(others.shift()));
                isKept = lengthOf(others) + bytes.length <= _capacity && _storage.write(name, bytes);
            }
            // there is no room even for one entry
            _isOff = !isKept;
            list(others, name, isKept ? bytes : null);
            return isKept;
        }

        private static function check(model:Model, settings:FitSettings):void
        {
            if (model == null || settings == null)
            {
                throw new ArgumentError("the model and the settings must not be null: " + model + ", " + settings);
            }
        }

        // The list without one name. Damaged lines are left out.
        private function entriesBut(name:String):Array
        {
            var bytes:ByteArray = _storage.read(LIST);
            var entries:Array = [];
            for each (var entry:String in bytes == null ? null : bytes.readUTFBytes(bytes.length).match(ENTRIES))
            {
                if (nameIn(entry) != name)
                {
                    entries.push(entry);
                }
            }
            return entries;
        }

        // Writes the list, with one more entry unless its bytes are null.
        private function list(others:Array, name:String, bytes:ByteArray):void
        {
            var text:ByteArray = new ByteArray();
            text.writeUTFBytes(others.join("") + (bytes == null ? "" : name + " " + bytes.length + "\n"));
            _storage.write(LIST, text);
        }

        private static function nameOf(geometry:Fingerprint, settings:FitSettings):String
        {
            return geometry.toString() + settings;
        }

        private static function nameIn(entry:String):String
        {
            return entry.substr(0, NAME_LENGTH);
        }

        private static function lengthOf(entries:Array):Number
        {
            var sum:Number = 0;
            for each (var entry:String in entries)
            {
                sum += Number(entry.substr(NAME_LENGTH + 1));
            }
            return sum;
        }
    }
}
