package starlogo.hierarchy
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.timeOfImpact;

    use namespace engine;

    /**
     * Decides when two trees touch that pass each other, or a tree and a node that stands for a single structure, where nodes may have spheres
     * or capsules: the first moment at which two nodes that are leaves or at their depth limit touch, and all pairs that a
     * StructureTraversal visits before them. A child's structure may reach out of its parent's: hence a pair is looked at for as long
     * only as those before it touch.
     *
     * @private
     */
    public final class SweptStructureTraversal extends StructureTraversal
    {
        private var _part:RelativeMotion = new RelativeMotion();

        /** @inheritDoc */
        public function SweptStructureTraversal(pose:RelativePose)
        {
            super(pose);
        }

        /** @inheritDoc */
        override protected function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            placeStructures(a, b);
            _part.takePart(pose.motion, from, to);
            var share:Number = timeOfImpact(movedB, structureA, _part);
            from += (to - from) * share;
            return share <= 1;
        }

        /** @inheritDoc */
        override protected function divide(a:HierarchyNode, aEnds:Boolean, b:HierarchyNode, bEnds:Boolean):void
        {
            // a tree's boxes hold those of their children
            if (b.level > 0 || structureA.kind != BoundingStructure.BOX)
            {
                // the last time that they touch is the first one on the way back
                _part.takePart(pose.motion, to, from);
                var share:Number = timeOfImpact(movedB, structureA, _part);
                to = share <= 1 ? to - (to - from) * share : from;
            }
            super.divide(a, aEnds, b, bEnds);
        }

        /** @inheritDoc */
        override protected function isRightFirst(a:HierarchyNode):Boolean
        {
            return false;
        }
    }
}
