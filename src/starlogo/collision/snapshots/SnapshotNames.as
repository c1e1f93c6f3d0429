package starlogo.collision.snapshots
{
    import flash.utils.ByteArray;
    import starlogo.agents.Breeds;

    /**
     * The names of breeds and models in a snapshot. Other parts of the snapshot mention a name by its index.
     *
     * @private
     */
    internal final class SnapshotNames
    {
        // A text stands before each key, because a model may be called "hasOwnProperty".
        private static const PREFIX:String = ":";

        private var _names:Vector.<String> = new Vector.<String>();

        // By the number of a breed: the index of its name, plus 1. By the name of a model: the same. The model asked for last, and its index.
        private var _ofBreeds:Vector.<int> = new Vector.<int>();
        private var _ofModels:Object = {};
        private var _last:String = null;
        private var _lastIndex:int = 0;

        /** The index of a breed's name. */
        public function ofBreed(number:int):int
        {
            if (number >= _ofBreeds.length)
            {
                _ofBreeds.length = number + 1;
            }
            if (_ofBreeds[number] == 0)
            {
                _ofBreeds[number] = _names.push(Breeds.nameOf(number));
            }
            return _ofBreeds[number] - 1;
        }

        /** The index of a model's name. */
        public function ofModel(name:String):int
        {
            if (name != _last)
            {
                _last = name;
                _lastIndex = int(_ofModels[PREFIX + name]) - 1;
                if (_lastIndex < 0)
                {
                    _lastIndex = _names.push(name) - 1;
                    _ofModels[PREFIX + name] = _lastIndex + 1;
                }
            }
            return _lastIndex;
        }

        /** The name with an index. @throws RangeError if there is none */
        public function nameAt(index:uint):String
        {
            if (index >= _names.length)
            {
                throw new RangeError("there is no name with the index " + index);
            }
            return _names[index];
        }

        /** Writes the names. */
        public function write(bytes:ByteArray):void
        {
            bytes.writeInt(_names.length);
            for (var i:int = 0; i < _names.length; i++)
            {
                var name:ByteArray = new ByteArray();
                name.writeUTFBytes(_names[i]);
                bytes.writeInt(name.length);
                bytes.writeBytes(name);
            }
        }

        /** Reads names. @throws RangeError if one is empty */
        public function read(bytes:ByteArray):void
        {
            for (var left:uint = bytes.readUnsignedInt(); left > 0; left--)
            {
                var name:String = bytes.readUTFBytes(bytes.readUnsignedInt());
                if (name == "")
                {
                    throw new RangeError("a name is empty");
                }
                _names.push(name);
            }
        }
    }
}
