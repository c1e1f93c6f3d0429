package starlogo.collision
{
    import starlogo.engine;
    import starlogo.search.BaseShapeChoice;

    use namespace engine;

    /**
     * The base class of the HierarchicalCollider and the CombinationCollider: a game that has either can set how far hierarchies are tested. It is
     * there for games alone. The engine does not use this class as a type.
     */
    public class TreeCollider extends Collider
    {
        /**
         * Only HierarchicalCollider and CombinationCollider call it.
         *
         * @param choice chooses the shapes of agents
         */
        public function TreeCollider(choice:BaseShapeChoice)
        {
            super(choice);
        }

        /**
         * The number of levels of a hierarchy that a test visits, for agents whose own traversalDepth is 0 (§4.8). The root is level 1. If the
         * number is larger than the number of levels, a test visits all of them. A greater depth finds fewer false collisions, and never one
         * that a smaller depth does not find.
         *
         * @throws RangeError if it is set to less than 1
         */
        public function get maxDepth():int
        {
            return narrowPhase.treeLimits.maxDepth;
        }

        public function set maxDepth(value:int):void
        {
            narrowPhase.treeLimits.maxDepth = value;
        }

        /**
         * If true, the triangles of hierarchies decide, in frames, contacts and all questions. Depth limits do not apply. Two hierarchies collide
         * if two of their triangles touch. A hierarchy and a structure collide if a triangle touches the solid sphere, capsule, box or hull. A model
         * or structure inside another model collides with it if the outer surface is closed, even if the surfaces do not touch. If a model has
         * no triangles, its leaves decide.
         *
         * <p>The first frame in which an exact collider tests a model prepares its triangles. This takes tens of milliseconds for thousands of
         * triangles, unless GreatLand.prepareExact was set when the model was added. Other tree colliders prepare them too, when they first test
         * the model without finding a collision, because triangles decide at every depth whether one model is inside the other.</p>
         */
        public function get exact():Boolean
        {
            return narrowPhase.treeLimits.isExact;
        }

        public function set exact(value:Boolean):void
        {
            narrowPhase.treeLimits.isExact = value;
        }
    }
}
