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
        private var _numbers:NameNumbers = new NameNumbers(new Vector.<String>());

        /** The number here of a breed's name. */
        public function ofBreed(breed:int):int
        {
            return _numbers.numberOf(Breeds.NAMES.nameOf(breed));
        }

        /** The number here of a model's name. */
        public function ofModel(model:int):int
        {
            return _numbers.numberOf(Agent.MODEL_NAMES.nameOf(model));
        }

        /** The name with a number. @throws RangeError if there is none */
        public function nameAt(number:uint):String
        {
            if (number >= _numbers.count)
            {
                throw new RangeError("there is no name with the number " + number);
            }
            return _numbers.nameOf(number);
        }

        /** Writes the names. */
        public function write(bytes:ByteArray):void
        {
            bytes.writeInt(_numbers.count);
            for (var number:int = 0; number < _numbers.count; number++)
            {
                var name:ByteArray = new ByteArray();
                name.writeUTFBytes(_numbers.nameOf(number));
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
                // older versions wrote a breed's name that is a model's too once for each
                _numbers.append(name);
            }
        }
    }
}
