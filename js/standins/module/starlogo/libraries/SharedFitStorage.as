package starlogo.libraries
{
    import flash.utils.ByteArray;
    import standin.LocalStore;

    /**
     * Keeps fits in the page's local storage, one item for each name (thesis §7.9). Workers and Node have no local storage. There, or if it
     * is switched off, nothing is kept.
     *
     * <p>A browser lets a site store about 5 MB. An item takes a third more than its bytes.</p>
     */
    public final class SharedFitStorage implements FitStorage
    {
        private static const PREFIX:String = "starlogo-fits/";

        /** Uses the page's local storage. */
        public function SharedFitStorage()
        {
        }

        /** @inheritDoc */
        public function read(name:String):ByteArray
        {
            return LocalStore.read(PREFIX + name);
        }

        /** @inheritDoc */
        public function write(name:String, bytes:ByteArray):Boolean
        {
            var isKept:Boolean = LocalStore.write(PREFIX + name, bytes);
            if (!isKept)
            {
                remove(name);
            }
            return isKept;
        }

        /** @inheritDoc */
        public function remove(name:String):void
        {
            LocalStore.remove(PREFIX + name);
        }
    }
}
