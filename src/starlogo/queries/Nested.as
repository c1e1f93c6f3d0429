package starlogo.queries
{
    import starlogo.engine;

    use namespace engine;

    /**
     * What a question needs after a call of a filter's <code>accepts</code>: one thing for each depth of nesting (SeenAgents.nesting). The function
     * may ask any question, which then has the thing of the next depth.
     *
     * <p><code>accepts</code> is called by Collector.askBelow alone: in NearSearch.find, between nodes, and where a search ends
     * (<code>Collector.end()</code>, and what calls it: MovingBody.collectRowsAlong and collectRowsWithin, PlatformCarry.find). After such a call a
     * question may use its arguments, its locals, and its Nested things: a Collector, NearSearch, Hits, MovingBody or Walk. A nested question may
     * have written all other fields of the classes that answer questions: the SweptBoxSearch, the ray, a motion, its result, what a Slider or a
     * WalkMover computes with. A question writes these before it reads them, and ends with them before the next call.</p>
     *
     * @private
     */
    public final class Nested
    {
        private var _seen:SeenAgents;
        private var _type:Class;

        // By depth of nesting.
        private var _things:Array = [];

        /**
         * @param seen the agents that the questions are about
         * @param type the class of the things. Its constructor takes these agents
         */
        public function Nested(seen:SeenAgents, type:Class)
        {
            _seen = seen;
            _type = type;
        }

        /** The thing of a question that begins now. */
        public function get current():*
        {
            var depth:int = _seen.nesting;
            while (_things.length <= depth)
            {
                _things.push(new _type(_seen));
            }
            return _things[depth];
        }
    }
}
