package starlogo.libraries
{
    import flash.utils.ByteArray;
    import starlogo.data.Fingerprint;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.libraries.cooked.CookedTree;
    import starlogo.models.Model;
    import starlogo.models.cooked.CookedFile;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * Keeps the results computed for models from one game to the next (thesis §7.9). So each machine computes them only once. Give it to a
     * GreatLand: the GreatLand looks here before it computes, and stores new results here.
     *
     * <p>An entry is a cooked file without the model. It is found by the model's geometry and all settings that matter. The model's name
     * does not matter. A damaged or incomplete entry is ignored and replaced. An entry that somebody forged may give wrong collisions,
     * but it makes no frame throw or hang. If there is not enough room, the least recently used entries are removed. An entry for which that
     * gives no room is not stored. If nothing can be stored, games still work.</p>
     *
     * <p>Several games may share a storage at the same time, for example in several tabs. Each entry is stored separately, so no game
     * overwrites another's entries. If two games write the list of entries at the same time, an entry may be missing from the list until
     * its next use. If their stores have different capacities, each makes room by its own.</p>
     */
    public final class FitStore
    {
        /** The default capacity, in bytes. Flash Player lets a site store 100 KB without asking the user. */
        public static const DEFAULT_CAPACITY:int = 90000;

        // The list of entries is a text. It has a line for each entry, the least recently used one first: the name, and the length in bytes.
        private static const LIST:String = "index";
        private static const LINES:RegExp = /[0-9a-f]{32} \d{1,9}\n/g;
        private static const NAME_LENGTH:int = 32;

        private var _storage:FitStorage;
        private var _capacity:Number;

        // The most bytes that are tried: the capacity, or less after the storage has refused some.
        private var _usableCapacity:Number;

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
            _capacity = _usableCapacity = capacity;
            _storage = storage || new SharedFitStorage();
        }

        /** The most bytes that there are after it has stored an entry. A store with a larger capacity may leave more in the same storage. */
        public function get capacity():Number
        {
            return _capacity;
        }

        /** The number of bytes that it has now. */
        public function get length():Number
        {
            return lengthOf(lines());
        }

        /**
         * Reads the entry of a model, at once. The entry is then the one used last. A game does not need it: its GreatLand reads and writes
         * entries. It is for a program that moves entries from one store to another.
         *
         * @param model the model
         * @param settings the settings of the results
         * @return the entry's bytes; null if there is none, or it is damaged
         * @throws ArgumentError if one argument is null
         */
        public function read(model:Model, settings:FitSettings):ByteArray
        {
            var geometryKey:Fingerprint = geometryKeyOf(model);
            requireGiven("the settings", settings);
            var bytes:ByteArray = readAsUsed(geometryKey, settings);
            return isEntryOf(geometryKey, bytes) ? bytes : null;
        }

        /**
         * Stores an entry of a model. It replaces the one stored for the same settings.
         *
         * @param model the model
         * @param settings the settings of the results
         * @param bytes what <code>read()</code> of another store has returned for this model and these settings; only their position changes
         * @return whether they are stored; false if they are damaged or of another model, or there is no room for them
         * @throws ArgumentError if one argument is null
         */
        public function write(model:Model, settings:FitSettings, bytes:ByteArray):Boolean
        {
            requireGiven("the bytes", bytes);
            requireGiven("the settings", settings);
            var geometryKey:Fingerprint = geometryKeyOf(model);
            bytes.position = 0;
            return isEntryOf(geometryKey, bytes) && writeFile(geometryKey, settings, bytes);
        }

        /** Removes all entries. */
        public function clear():void
        {
            for each (var line:String in lines())
            {
                _storage.remove(nameIn(line));
            }
            _storage.remove(LIST);
            _usableCapacity = _capacity;
        }

        /**
         * The file kept for a geometry key, whose entry is then the one used last. None of its steps is done yet. It is not complete if there is none.
         *
         * @private
         */
        engine function readFile(geometryKey:Fingerprint, settings:FitSettings):CookedFile
        {
            return new CookedFile(readAsUsed(geometryKey, settings));
        }

        /**
         * Whether there may be room for the results for a model. False only if there is surely none.
         *
         * @param hasTree whether its hierarchy is one of them
         *
         * @private
         */
        engine function hasRoomFor(model:Model, hasTree:Boolean):Boolean
        {
            var primitiveCount:int = (model.triangles == null ? model.vertices.length : model.triangles.length) / 3;
            return (hasTree ? primitiveCount * CookedTree.widthFor(primitiveCount) : 0) < _usableCapacity;
        }

        /**
         * Saves the file of a geometry key. It removes the least recently used entries until there is room. A storage that refuses the file has
         * less room than the store was told: for the entries that are there, and perhaps for smaller ones than this. The file is tried once more in
         * the place of other entries, if they have as many bytes. Later files are not tried beyond this room, because the player asks the user at
         * each refusal.
         *
         * @param geometryKey the fingerprint of the model's vertices and triangles
         * @return whether it is stored
         *
         * @private
         */
        engine function writeFile(geometryKey:Fingerprint, settings:FitSettings, bytes:ByteArray):Boolean
        {
            var name:String = nameOf(geometryKey, settings);
            var others:Array = linesWithout(name);
            for (var attempt:int = 0; attempt < 2 && bytes.length <= _usableCapacity; attempt++)
            {
                while (lengthOf(others) > _usableCapacity - bytes.length)
                {
                    _storage.remove(nameIn(others.shift()));
                }
                if (_storage.write(name, bytes) && writeList(others.concat(lineOf(name, bytes))))
                {
                    return true;
                }
                _storage.remove(name);
                writeListOrEvict(others);
                _usableCapacity = Math.max(lengthOf(others), bytes.length - 1);
            }
            return false;
        }

        // Makes an entry the most recently used one. Returns a copy of its bytes; null if there is none.
        private function readAsUsed(geometryKey:Fingerprint, settings:FitSettings):ByteArray
        {
            var name:String = nameOf(geometryKey, settings);
            var bytes:ByteArray = bytesOf(name);
            if (bytes != null)
            {
                writeListOrEvict(linesWithout(name).concat(lineOf(name, bytes)));
            }
            return bytes;
        }

        // What is stored under a name, from the beginning on: a copy that a game's own storage has just written stands at its end.
        private function bytesOf(name:String):ByteArray
        {
            // in JavaScript, a game's own storage may return anything
            var bytes:ByteArray = _storage.read(name) as ByteArray;
            if (bytes != null)
            {
                bytes.position = 0;
            }
            return bytes;
        }

        private static function isEntryOf(geometryKey:Fingerprint, bytes:ByteArray):Boolean
        {
            var file:CookedFile = new CookedFile(bytes);
            finish(file);
            return file.hasKey(CookedFile.MODEL, geometryKey);
        }

        // The fingerprint of a model's vertices and triangles.
        private static function geometryKeyOf(model:Model):Fingerprint
        {
            requireGiven("the model", model);
            var geometryKey:Fingerprint = new Fingerprint();
            finish(geometryKey.addingLists(model.vertices, model.triangles));
            return geometryKey;
        }

        // The list of entries. Damaged lines are left out.
        private function lines():Array
        {
            var bytes:ByteArray = bytesOf(LIST);
            return (bytes == null ? null : bytes.readUTFBytes(bytes.length).match(LINES)) || [];
        }

        private function linesWithout(name:String):Array
        {
            return lines().filter(function(line:String, index:int, all:Array):Boolean
                {
                    return nameIn(line) != name;
                });
        }

        // Writes the list. A storage that refuses it has lost it too, so the least recently used entries are removed until there is room for it.
        private function writeListOrEvict(lines:Array):void
        {
            while (!writeList(lines) && lines.length > 0)
            {
                _storage.remove(nameIn(lines.shift()));
            }
        }

        // Returns whether it is stored. If not, there is no list.
        private function writeList(lines:Array):Boolean
        {
            var text:ByteArray = new ByteArray();
            text.writeUTFBytes(lines.join(""));
            return _storage.write(LIST, text);
        }

        private static function lineOf(name:String, bytes:ByteArray):String
        {
            return name + " " + bytes.length + "\n";
        }

        private static function nameOf(geometryKey:Fingerprint, settings:FitSettings):String
        {
            return geometryKey.toString() + settings;
        }

        private static function nameIn(line:String):String
        {
            return line.substr(0, NAME_LENGTH);
        }

        private static function lengthOf(lines:Array):Number
        {
            var sum:Number = 0;
            for each (var line:String in lines)
            {
                sum += Number(line.substr(NAME_LENGTH + 1));
            }
            return sum;
        }
    }
}
