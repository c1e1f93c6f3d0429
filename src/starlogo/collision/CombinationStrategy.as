package starlogo.collision
{
    import starlogo.motion.Touch;
    import starlogo.motion.Way;

    /** An agent that is hierarchical is the hierarchy of its model, any other its tightest fit (thesis §5). */
    internal final class CombinationStrategy extends ShapeStrategy
    {
        private var _tightestFit:TightestFitStrategy;
        private var _hierarchy:HierarchyStrategy;

        /**
         * @param tightestFit for those that are not hierarchical
         * @param hierarchy for pairs of which one is hierarchical at least
         */
        public function CombinationStrategy(tightestFit:TightestFitStrategy, hierarchy:HierarchyStrategy)
        {
            _tightestFit = tightestFit;
            _hierarchy = hierarchy;
        }

        /**
         * @inheritDoc
         *
         * <p>Nothing yet: the agent may become hierarchical, or cease to be, while it is bound.</p>
         */
        override public function bindModel(shape:WorldShape):void
        {
        }

        /** @inheritDoc */
        override public function updateWorldShape(shape:WorldShape):void
        {
            if (shape.agent.hierarchical)
            {
                if (shape.hierarchy == null)
                {
                    _hierarchy.bindModel(shape);
                }
                shape.isHierarchical = true;
                shape.isSphere = false;
                shape.box = null;
                _hierarchy.updateWorldShape(shape);
                return;
            }
            if (shape.structure == null)
            {
                _tightestFit.bindModel(shape);
            }
            else if (shape.isHierarchical)
            {
                _tightestFit.takeStructure(shape);
            }
            shape.isHierarchical = false;
            _tightestFit.updateWorldShape(shape);
        }

        /** @inheritDoc */
        override public function get boxFacesOnly():Boolean
        {
            return _tightestFit.boxFacesOnly;
        }

        /** @inheritDoc */
        override public function overlaps(a:WorldShape, b:WorldShape):Boolean
        {
            if (a.isHierarchical || b.isHierarchical)
            {
                return _hierarchy.overlaps(a, b);
            }
            return _tightestFit.overlaps(a, b);
        }

        /** @inheritDoc */
        override public function firstOverlap(a:WorldShape, b:WorldShape, way:Way):Number
        {
            if (a.isHierarchical || b.isHierarchical)
            {
                return _hierarchy.firstOverlap(a, b, way);
            }
            return _tightestFit.firstOverlap(a, b, way);
        }

        /** @inheritDoc */
        override public function findTouch(a:WorldShape, b:WorldShape, way:Way, time:Number, out:Touch):void
        {
            if (a.isHierarchical || b.isHierarchical)
            {
                _hierarchy.findTouch(a, b, way, time, out);
            }
            else
            {
                _tightestFit.findTouch(a, b, way, time, out);
            }
        }

        /** @inheritDoc */
        override public function resetCounts():void
        {
            _tightestFit.resetCounts();
            _hierarchy.resetCounts();
        }

        /** @inheritDoc */
        override public function countInto(statistics:CollisionStatistics):void
        {
            _tightestFit.countInto(statistics);
            _hierarchy.countInto(statistics);
        }
    }
}
