package starlogo.queries
{
    import starlogo.engine;

    use namespace engine;

    /**
     * Objects of one class that keep what a question under way has found: one object for each question. A filter's <code>accepts</code> may ask
     * another question while a question is under way. That one has the next object, by the depth of nesting (SeenAgents.callbackDepth).
     *
     * <p><code>accepts</code> is called by Collector.askAcceptsBelow alone: in NearSearch.find, between nodes, and where a search ends
     * (<code>Collector.end()</code>, and what calls it, for example NearRows.findAlong and PlatformCarry.find). After such a call a
     * question may use its arguments, its locals, and its objects of this kind: a Collector, a NearSearch, a MovingBody, a WalkState, or the
     * RayHits of a ray. A nested question may have written all other fields of the classes that answer questions: the SweptBoxSearch, the ray, a
     * motion, its result, what a Slider or a WalkPlanner computes with. A question writes these before it reads them, and ends with them before the
     * next call.</p>
     *
     * @private
     */
    public final class NestedPool
    {
        private var _seen:SeenAgents;
        private var _type:Class;

        // By depth of nesting.
        private var _objects:Array = [];

        /**
         * @param seen the agents that the questions are about
         * @param type the class of the objects. Its constructor takes these agents
         */
        public function NestedPool(seen:SeenAgents, type:Class)
        {
            _seen = seen;
            _type = type;
        }

        /** The object of the question that begins now. Its class is the type. */
        public function get current():Object
        {
            var depth:int = _seen.callbackDepth;
            while (_objects.length <= depth)
            {
                _objects.push(new _type(_seen));
            }
            return _objects[depth];
        }
    }
}
