package starlogo.collision.snapshots
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;

    use namespace engine;

    /**
     * The names of breeds and models in a snapshot. Other parts of the snapshot mention a name by its index.
     *
     * @private
     */
    internal final class SnapshotNames
    {
        private var _names:Vector.<String> = new Vector.<String>();

        // By the number of a breed's or a model's name: the index of the name, plus 1.
        private var _ofBreeds:Vector.<int> = new Vector.<int>();
        private var _ofModels:Vector.<int> = new Vector.<int>();

        /** The index of a breed's name. */
        public function ofBreed(number:int):int
        {
            return indexOf(Breeds.NAMES.nameOf(number), _ofBreeds, number);
        }

        /** The index of a model's name. */
        public function ofModel(number:int):int
        {
            return indexOf(Agent.MODEL_NAMES.nameOf(number), _ofModels, number);
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

        // The index of a name, which it gets here if it is new.
        private function indexOf(name:String, indices:Vector.<int>, number:int):int
        {
            if (number >= indices.length)
            {
                indices.length = number + 1;
            }
            if (indices[number] == 0)
            {
                indices[number] = _names.push(name);
            }
            return indices[number] - 1;
        }
    }
}
