package starlogo.queries.rays
{
    /**
     * Gives lists of answers their RayHits or ShapeHits. It keeps those that no list needs at present, for lists that need more.
     *
     * @private
     */
    public final class HitPool
    {
        private var _type:Class;
        private var _free:Array = [];

        /** @param type RayHit or ShapeHit */
        public function HitPool(type:Class)
        {
            _type = type;
        }

        /**
         * Makes a list have as many hits as an answer. It removes surplus hits one at a time, because V8 frees an array's memory if its length is
         * set to less.
         *
         * @param hits a list of hits of the type
         */
        public function resize(hits:Object, length:int):void
        {
            while (hits.length > length)
            {
                var hit:Object = hits.pop();
                if (hit != null)
                {
                    hit.agent = null;
                    _free.push(hit);
                }
            }
            for (var i:int = 0; i < length; i++)
            {
                if (i == hits.length || hits[i] == null)
                {
                    var spare:Object = _free.length > 0 ? _free.pop() : new _type();
                    hits[i] = spare;
                }
            }
        }
    }
}
