package starlogo.collision.snapshots
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.agents.NameNumbers;
    import starlogo.engine;

    use namespace engine;

    /**
     * The names of breeds and models in a snapshot. Other parts of the snapshot mention a name by its number here.
     *
     * @private
     */
    internal final class SnapshotNames
    {
        // By number here: the name. Bytes of older versions may have one twice, as a breed's and as a model's.
        private var _names:Vector.<String> = new Vector.<String>();

        // The numbers here of names that are written.
        private var _numbers:NameNumbers = new NameNumbers(new Vector.<String>());

        /** The number here of a breed's name. */
        public function ofBreed(breed:int):int
        {
            return numberOf(Breeds.NAMES.nameOf(breed));
        }

        /** The number here of a model's name. */
        public function ofModel(model:int):int
        {
            return numberOf(Agent.MODEL_NAMES.nameOf(model));
        }

        private function numberOf(name:String):int
        {
            var number:int = _numbers.numberOf(name);
            _names[number] = name;
            return number;
        }

        /** The name with a number. @throws RangeError if there is none */
        public function nameAt(number:uint):String
        {
            if (number >= _names.length)
            {
                throw new RangeError("there is no name with the number " + number);
            }
            return _names[number];
        }

        /** Writes the names. */
        public function write(bytes:ByteArray):void
        {
            bytes.writeInt(_names.length);
            for (var number:int = 0; number < _names.length; number++)
            {
                var name:ByteArray = new ByteArray();
                name.writeUTFBytes(_names[number]);
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
