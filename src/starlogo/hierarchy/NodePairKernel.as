package starlogo.hierarchy
{
    import flash.errors.IllegalOperationError;

    /**
     * Decides about the pairs of nodes at which a traversal ends, by their items. Abstract: a subclass knows the two trees and their items. If a traversal
     * has no kernel, the nodes' boxes decide.
     *
     * @private
     */
    public class NodePairKernel
    {
        /** Whether items of two nodes, which stand, touch. */
        public function areTouching(a:int, b:int):Boolean
        {
            throw new IllegalOperationError(this + " does not implement areTouching");
        }

        /**
         * Finds when items of two nodes first touch.
         *
         * @param best receives the time and the two items, if they are the first ones to touch so far
         */
        public function findEarlier(a:int, b:int, best:BestPair):void
        {
            throw new IllegalOperationError(this + " does not implement findEarlier");
        }

        /**
         * Finds the closest points of the items of two nodes.
         *
         * @param best receives the points and their distance, if they are nearer than those of the best pair so far
         */
        public function findCloser(a:int, b:int, best:BestPair):void
        {
            throw new IllegalOperationError(this + " does not implement findCloser");
        }
    }
}
