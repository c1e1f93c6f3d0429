package starlogo.models.gltf
{
    import starlogo.models.ModelError;
    import starlogo.models.files.shortened;

    /**
     * An object in the JSON of a glTF file. Its methods check what they read, and errors name the place. Only textOrNull() refuses
     * nothing, and <code>raw</code> is as it was read. The outermost object has the file's lists: its nodes, for example.
     */
    internal final class GltfJson
    {
        /** Stands for the length of a list that may have any. */
        internal static const ANY_LENGTH:int = -1;

        /** The object, as it was read. */
        public var raw:Object;

        /** Its place in the JSON, for errors; "" for the outermost object. */
        public var place:String;

        /** The model's name. */
        public var modelName:String;

        private var _root:GltfJson;

        /**
         * @param modelName the model's name
         * @param value the object
         * @param place its place
         * @param root the outermost object; null if this is it
         * @throws ModelError if the value is no object
         */
        public function GltfJson(modelName:String, value:*, place:String = "", root:GltfJson = null)
        {
            this.modelName = modelName;
            raw = value;
            this.place = place;
            _root = root || this;
            if (!isObject(value))
            {
                throw error(root == null ? "its JSON is no object" : "expected an object, but found " + shown(value));
            }
        }

        /** Throws a ModelError if something is wrong. The message is built in any case. @param key the property that is wrong; "" for the object */
        public function refuseIf(isWrong:Boolean, problem:String, key:String = ""):void
        {
            if (isWrong)
            {
                throw error(problem, key);
            }
        }

        /** The error for something that is wrong with the object. @param key as for refuseIf() */
        public function error(problem:String, key:String = ""):ModelError
        {
            return new ModelError(modelName, placeOf(key), problem);
        }

        /** Whether there is a property. */
        public function has(key:String):Boolean
        {
            return raw[key] !== undefined;
        }

        /** A property that is a text; null if it is something else, or empty. */
        public function textOrNull(key:String):String
        {
            return raw[key] is String && raw[key] != "" ? raw[key] : null;
        }

        /** A property that is a list; an empty one if there is none. */
        public function list(key:String):Array
        {
            var found:* = raw[key];
            if (found !== undefined && !(found is Array))
            {
                throw error("expected a list, but found " + shown(found), key);
            }
            return found === undefined ? [] : found;
        }

        /** The length of a list; 0 if there is none. */
        public function count(key:String):int
        {
            return list(key).length;
        }

        /** An element of a list of objects. */
        public function element(key:String, index:int):GltfJson
        {
            return new GltfJson(modelName, list(key)[index], placeOf(key) + "[" + index + "]", _root);
        }

        /** An element of a list of indices of the entries of one of the file's lists. */
        public function indexIn(key:String, index:int, entries:String):int
        {
            return checkedIndex(list(key)[index], key + "[" + index + "]", entries);
        }

        /** A property that is an object; null if there is none. */
        public function object(key:String):GltfJson
        {
            return has(key) ? new GltfJson(modelName, raw[key], placeOf(key), _root) : null;
        }

        /** An entry of one of the file's lists, for example "nodes". */
        public function rootEntry(list:String, index:int):GltfJson
        {
            return _root.element(list, index);
        }

        /** The index of the entry of one of the file's lists to which a property refers; -1 if there is none. */
        public function indexOrNone(key:String, list:String):int
        {
            return has(key) ? checkedIndex(raw[key], key, list) : -1;
        }

        private function checkedIndex(index:*, key:String, list:String):int
        {
            var most:int = _root.count(list);
            if (!isInteger(index, most - 1))
            {
                throw error("expected the number of one of " + most + " " + list + ", but found " + shown(index), key);
            }
            return index;
        }

        /** An integer property from 0 to a maximum; the preset value if there is none. */
        public function integer(key:String, most:int, preset:int):int
        {
            return has(key) ? requiredInteger(key, most) : preset;
        }

        /** An integer property from 0 to a maximum. @throws ModelError if there is none */
        public function requiredInteger(key:String, most:int):int
        {
            var found:* = raw[key];
            refuseIf(!isInteger(found, most), "expected an integer from 0 to " + most + ", but found " + shown(found), key);
            return found;
        }

        /** A property that is a list of finite numbers; the preset value if there is none. @param length the list's length, or ANY_LENGTH */
        public function numbers(key:String, length:int, preset:Vector.<Number> = null):Vector.<Number>
        {
            if (!has(key))
            {
                return preset;
            }
            var found:Array = list(key);
            refuseIf(length != ANY_LENGTH && found.length != length, "expected " + length + " numbers, but found " + found.length, key);
            var all:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < found.length; i++)
            {
                var number:* = found[i];
                refuseIf(!(number is Number && isFinite(number)), "expected a finite number, but found " + shown(number), key + "[" + i + "]");
                all.push(number);
            }
            return all;
        }

        /** Whether there is an extension. */
        public function hasExtension(extension:String):Boolean
        {
            var extensions:GltfJson = object("extensions");
            return extensions != null && extensions.has(extension);
        }

        private function placeOf(key:String):String
        {
            return place == "" || key == "" ? place + key : place + "." + key;
        }

        private static function isObject(value:*):Boolean
        {
            return value is Object && !(value is Array || value is String || value is Number || value is Boolean);
        }

        private static function isInteger(value:*, most:int):Boolean
        {
            return value is Number && value >= 0 && value <= most && int(value) == value;
        }

        /** A value of the JSON, as errors show it. */
        public static function shown(value:*):String
        {
            if (value === undefined || value === null)
            {
                return value === null ? "null" : "nothing";
            }
            if (value is String)
            {
                return "\"" + shortened(value) + "\"";
            }
            return value is Array ? "a list" : (isObject(value) ? "an object" : String(value));
        }
    }
}
