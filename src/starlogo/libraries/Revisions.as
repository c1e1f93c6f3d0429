package starlogo.libraries
{
    /**
     * Counts how often what is known under a name was replaced or removed: what was kept of it is void when its number has changed.
     *
     * @private
     */
    public final class Revisions
    {
        // in front of every key: a model may be called "hasOwnProperty"
        private static const PREFIX:String = ":";

        /** Of all names together. */
        public var total:int = 0;

        private var _byName:Object = {};

        /** Nothing was replaced yet. */
        public function Revisions()
        {
        }

        /** Of one name. */
        public function of(name:String):int
        {
            return int(_byName[PREFIX + name]);
        }

        /** Counts one more. */
        public function note(name:String):void
        {
            _byName[PREFIX + name] = of(name) + 1;
            total++;
        }
    }
}
