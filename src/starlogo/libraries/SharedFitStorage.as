package starlogo.libraries
{
    import flash.net.SharedObject;
    import flash.net.SharedObjectFlushStatus;
    import flash.utils.ByteArray;

    /**
     * Keeps fits as shared objects, one for each name (thesis §7.9). In the player they are on the user's disk. In the ES module they are
     * in the page's local storage. If these are switched off, nothing is kept.
     *
     * <p>The player lets a site store 100 KB without asking. For more it asks the user, and a game does not wait for the answer. So entries
     * that would need more room are not kept.</p>
     */
    public final class SharedFitStorage implements FitStorage
    {
        private static const PREFIX:String = "starlogo-fits/";

        /** Uses the player's shared objects of this site. */
        public function SharedFitStorage()
        {
        }

        /** @inheritDoc */
        public function read(name:String):ByteArray
        {
            var shared:SharedObject = sharedOf(name);
            return shared == null ? null : copyOf(shared.data.bytes as ByteArray);
        }

        /** @inheritDoc */
        public function write(name:String, bytes:ByteArray):Boolean
        {
            var shared:SharedObject = sharedOf(name);
            var isKept:Boolean = false;
            try
            {
                if (shared != null)
                {
                    shared.data.bytes = copyOf(bytes);
                    isKept = shared.flush() == SharedObjectFlushStatus.FLUSHED;
                }
            }
            catch (error:Error)
            {
                // there is no room, or the user has refused it
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
            var shared:SharedObject = sharedOf(name);
            if (shared != null)
            {
                shared.clear();
            }
        }

        // null if they are switched off
        private static function sharedOf(name:String):SharedObject
        {
            try
            {
                return SharedObject.getLocal(PREFIX + name, "/");
            }
            catch (error:Error)
            {
                // the result is null
            }
            return null;
        }

        private static function copyOf(bytes:ByteArray):ByteArray
        {
            if (bytes == null)
            {
                return null;
            }
            var copy:ByteArray = new ByteArray();
            copy.writeBytes(bytes);
            copy.position = 0;
            return copy;
        }
    }
}
