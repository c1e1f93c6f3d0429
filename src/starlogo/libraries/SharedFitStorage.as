package starlogo.libraries
{
    import flash.net.SharedObject;
    import flash.net.SharedObjectFlushStatus;
    import flash.utils.ByteArray;

    /**
     * Keeps fits as shared objects, one for each name (thesis §7.9): in the player on the user's disk, in the ES module in the
     * page's local storage. Where these are switched off nothing is kept.
     *
     * <p>The player lets a site have 100 KB unasked. It asks the user about more, which nobody waits for: what he has to be asked
     * about is not kept.</p>
     */
    public final class SharedFitStorage implements FitStorage
    {
        private static const PREFIX:String = "starlogo-fits/";

        /** The player's shared objects of this site. */
        public function SharedFitStorage()
        {
        }

        /** @inheritDoc */
        public function read(name:String):ByteArray
        {
            try
            {
                var kept:ByteArray = SharedObject.getLocal(PREFIX + name, "/").data.bytes as ByteArray;
                return kept == null ? null : copyOf(kept);
            }
            catch (error:Error)
            {
            }
            return null;
        }

        /** @inheritDoc */
        public function write(name:String, bytes:ByteArray):Boolean
        {
            var isKept:Boolean = false;
            try
            {
                var shared:SharedObject = SharedObject.getLocal(PREFIX + name, "/");
                shared.data.bytes = copyOf(bytes);
                isKept = shared.flush() == SharedObjectFlushStatus.FLUSHED;
            }
            catch (error:Error)
            {
            }
            if (!isKept)
            {
                remove(name);
            }
            return isKept;
        }

        /** @inheritDoc */
        public function remove(name:String):void
        {
            try
            {
                SharedObject.getLocal(PREFIX + name, "/").clear();
            }
            catch (error:Error)
            {
            }
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
