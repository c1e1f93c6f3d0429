package starlogo.collision.snapshots
{
    import flash.utils.ByteArray;
    import starlogo.agents.NameNumbers;

    /**
     * The names of breeds and models in a snapshot. Other parts of the snapshot mention a name by its number here.
     *
     * @private
     */
    internal final class SnapshotNames
    {
        // By number.
        private var _names:Vector.<String> = new Vector.<String>();

        // Those of the names that are written. What was read is only looked up by number.
        private var _numbers:NameNumbers = new NameNumbers(new Vector.<String>());

        /** The number of a name here. */
        public function numberOf(name:String):int
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
                // older versions wrote a breed's name that is a model's too once for each
                _names.push(name);
            }
        }
    }
}
