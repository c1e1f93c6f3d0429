package support
{
    import flash.utils.ByteArray;
    import starlogo.libraries.FitStorage;

    /** A FitStorage of a certain size that can be looked into. */
    public class MemoryStorage implements FitStorage
    {
        /** What is there, by name. */
        public var entries:Object = {};

        /** How many bytes it takes, all in all. */
        public var room:Number;

        /** How often something was refused. */
        public var refusalCount:int = 0;

        /** How many fits were written. */
        public var writeCount:int = 0;

        /** Takes so many bytes. */
        public function MemoryStorage(room:Number = Infinity)
        {
            this.room = room;
        }

        /** The names of the fits that are there. */
        public function get names():Array
        {
            var all:Array = [];
            for (var name:String in entries)
            {
                if (name.length == 32)
                {
                    all.push(name);
                }
            }
            return all.sort();
        }

        /** @inheritDoc */
        public function read(name:String):ByteArray
        {
            return entries[name] == undefined ? null : copyOf(entries[name]);
        }

        /** @inheritDoc */
        public function write(name:String, bytes:ByteArray):Boolean
        {
            delete entries[name];
            var used:Number = bytes.length;
            for each (var entry:ByteArray in entries)
            {
                used += entry.length;
            }
            if (used > room)
            {
                refusalCount++;
                return false;
            }
            writeCount += name.length == 32 ? 1 : 0;
            entries[name] = copyOf(bytes);
            return true;
        }

        /** @inheritDoc */
        public function remove(name:String):void
        {
            delete entries[name];
        }

        private static function copyOf(bytes:ByteArray):ByteArray
        {
            var copy:ByteArray = new ByteArray();
            copy.writeBytes(bytes);
            copy.position = 0;
            return copy;
        }
    }
}
