package starlogo.models.gltf
{
    import starlogo.models.ModelError;
    import starlogo.models.text.TextWords;

    /** The JSON of a glTF file. Each value is checked when it is read. An error names the place in the JSON. */
    internal final class GltfJson
    {
        /** The outermost object. */
        public var root:Object;

        /** The model's name. */
        public var name:String;

        /**
         * @param name the model's name
         * @param root the result of the player's parser
         * @throws ModelError if it is no object
         */
        public function GltfJson(name:String, root:Object)
        {
            this.name = name;
            this.root = root;
            refuseIf(!isObject(root), "its JSON is no object", "");
        }

        /** Throws a ModelError if something is wrong. The message is built in any case. @param place where in the JSON; "" for no place */
        public function refuseIf(isWrong:Boolean, problem:String, place:String):void
        {
            if (isWrong)
            {
                throw new ModelError(name, place, problem);
            }
        }

        /** A list that is a property of an object; an empty one if there is none. */
        public function listIn(owner:Object, key:String, place:String):Array
        {
            var found:* = owner[key];
            refuseIf(found !== undefined && !(found is Array), "expected a list, but found " + shown(found), placeIn(place, key));
            return found === undefined ? [] : found;
        }

        /** An object that is a property of another object; null if there is none. */
        public function objectIn(owner:Object, key:String, place:String):Object
        {
            var found:* = owner[key];
            refuseIf(found !== undefined && !isObject(found), "expected an object, but found " + shown(found), placeIn(place, key));
            return found === undefined ? null : found;
        }

        /** The length of a list of the file, for example "nodes". */
        public function count(list:String):int
        {
            return listIn(root, list, "").length;
        }

        /** An entry of a list of the file, for example "nodes". */
        public function entry(list:String, index:int):Object
        {
            return elementOf(listIn(root, list, ""), index, list);
        }

        /** An element of a list of objects. */
        public function elementOf(list:Array, index:int, place:String):Object
        {
            var found:* = list[index];
            refuseIf(!isObject(found), "expected an object, but found " + shown(found), place + "[" + index + "]");
            return found;
        }

        /** The index of the entry of a list to which an object refers; -1 if it refers to none. */
        public function reference(owner:Object, key:String, place:String, list:String):int
        {
            return owner[key] === undefined ? -1 : checkedIndex(owner[key], placeIn(place, key), list);
        }

        /** Checks an index of an entry of a list, and returns it. */
        public function checkedIndex(value:*, place:String, list:String):int
        {
            var most:int = count(list);
            value = JsonMeter.restored(value);
            refuseIf(!isWhole(value, most - 1), "expected the number of one of " + most + " " + list + ", but found " + shown(value), place);
            return value;
        }

        /** An integer property from 0 to a maximum; the preset value if there is none. */
        public function whole(owner:Object, key:String, place:String, most:int, preset:int):int
        {
            var found:* = JsonMeter.restored(owner[key]);
            if (found === undefined && preset >= 0)
            {
                return preset;
            }
            refuseIf(!isWhole(found, most), "expected an integer from 0 to " + most + ", but found " + shown(found), placeIn(place, key));
            return found;
        }

        /** A property that is a list of finite numbers; the preset value if there is none. @param length the list's length; -1 for any */
        public function numbers(owner:Object, key:String, place:String, length:int, preset:Vector.<Number> = null):Vector.<Number>
        {
            if (owner[key] === undefined)
            {
                return preset;
            }
            var list:Array = listIn(owner, key, place);
            refuseIf(length >= 0 && list.length != length, "expected " + length + " numbers, but found " + list.length, placeIn(place, key));
            var all:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < list.length; i++)
            {
                var found:* = JsonMeter.restored(list[i]);
                refuseIf(!(found is Number) || found - found != 0, "expected a finite number, but found " + shown(found), placeIn(place, key) + "[" + i + "]");
                all.push(found);
            }
            return all;
        }

        /** Whether an object has an extension. */
        public function hasExtension(owner:Object, extension:String, place:String):Boolean
        {
            var extensions:Object = objectIn(owner, "extensions", place);
            return extensions != null && extensions[extension] !== undefined;
        }

        /** The path of a key in an object. */
        private static function placeIn(place:String, key:String):String
        {
            return place == "" ? key : place + "." + key;
        }

        private static function isObject(value:*):Boolean
        {
            return value is Object && !(value is Array || value is String || value is Number || value is Boolean);
        }

        private static function isWhole(value:*, most:int):Boolean
        {
            return value is Number && value >= 0 && value <= most && int(value) == value;
        }

        private static function shown(value:*):String
        {
            value = JsonMeter.restored(value);
            if (value === undefined || value === null)
            {
                return value === null ? "null" : "nothing";
            }
            if (value is String)
            {
                return "\"" + TextWords.shorten(value) + "\"";
            }
            return value is Array ? "a list" : (isObject(value) ? "an object" : String(value));
        }
    }
}
