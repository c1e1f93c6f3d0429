package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.intersects;

    use namespace engine;

    /**
     * Decides whether two hierarchies collide, or one and a structure (thesis §4.6): depth-first, until two nodes that are
     * leaves or at their depth limit overlap; and if none do, whether a part of one is inside of the other.
     *
     * <p>The thesis puts both structures into the world for each pair of nodes (§4.5). Here one RelativePose for each pair of
     * agents takes the second model into the space of the first, and the traversal for what the hierarchies are made of does
     * the rest: UprightBoxTreeTraversal, BoxTreeTraversal or StructureTreeTraversal, with an ExactPairTest where triangles
     * decide.</p>
     *
     * <p>Answers are nested: what triangles find, nodes find at any depth, and a greater depth finds no more than a smaller one.
     * Nodes alone would not do for solids: the leaves hug the surface, and a model well inside of a closed one meets none of
     * them. Hence the ContainmentTest, whose answer no depth changes.</p>
     *
     * <p>Models may differ in size by a factor of up to 1e200, and are then placed in the space of the larger one. Scratch
     * objects are reused: nothing is allocated once the stacks have grown and the models' triangles were prepared.</p>
     *
     * @private
     */
    public final class HierarchyTraversal
    {
        // By how much the second model may be larger than the first: its sixth power does not overflow. One that is
        // larger by more is, for a structure, like a point to rounding anyway.
        private static const MUCH_LARGER:Number = 1e40;

        private var _pose:RelativePose = new RelativePose();
        private var _uprightBoxes:UprightBoxTreeTraversal;
        private var _boxes:BoxTreeTraversal;
        private var _structures:StructureTreeTraversal;
        private var _exact:ExactPairTest;
        private var _containment:ContainmentTest;

        // A box that stands for a model, with its own axes.
        private var _leaf:HierarchyNode = new HierarchyNode();

        // A model that is far smaller than the other.
        private var _point:Sphere = new Sphere(new Vector3D(), 0);

        /** Nothing counted yet. */
        public function HierarchyTraversal()
        {
            _uprightBoxes = new UprightBoxTreeTraversal(_pose);
            _boxes = new BoxTreeTraversal(_pose);
            _structures = new StructureTreeTraversal(_pose);
            _exact = new ExactPairTest(_pose);
            _containment = new ContainmentTest(_pose);
            _leaf.level = 1;
            _leaf.x = _leaf.y = _leaf.z = 0;
        }

        /** Pairs of nodes that were visited since resetCounts. */
        public function get nodeVisits():int
        {
            return _uprightBoxes.nodeVisits + _boxes.nodeVisits + _structures.nodeVisits;
        }

        /** Pairs of triangles that were tested since resetCounts. */
        public function get triangleTests():int
        {
            return _exact.triangleTests;
        }

        /** Begins to count. */
        public function resetCounts():void
        {
            _uprightBoxes.nodeVisits = _boxes.nodeVisits = _structures.nodeVisits = 0;
            _exact.triangleTests = 0;
        }

        /**
         * Whether two models collide by their hierarchies.
         *
         * @param a the first model's hierarchy
         * @param placementA where the first model stands
         * @param depthA how many levels of it are visited
         * @param b the second model's hierarchy
         * @param placementB where the second model stands
         * @param depthB how many levels of that are visited
         * @param exact whether, for two hierarchies of triangles, depths do not count and triangles decide
         */
        public function hierarchiesOverlap(a:Hierarchy, placementA:Placement, depthA:int, b:Hierarchy, placementB:Placement, depthB:int,
                exact:Boolean):Boolean
        {
            if (placementB.size > MUCH_LARGER * placementA.size)
            {
                return hierarchiesOverlap(b, placementB, depthB, a, placementA, depthA, exact);
            }
            _pose.relate(placementA, placementB);
            var decider:ExactPairTest = null;
            if (exact && _exact.prepare(a, b))
            {
                decider = _exact;
                depthA = depthB = int.MAX_VALUE;
            }
            var rootsOverlapped:Boolean;
            if (a.boundsKind != BoundingStructure.BOX || b.boundsKind != BoundingStructure.BOX)
            {
                if (_structures.overlap(a.root, depthA, b.root, depthB, decider))
                {
                    return true;
                }
                rootsOverlapped = _structures.rootsOverlapped;
            }
            else if (_pose.isYawOnly)
            {
                if (_uprightBoxes.overlap(a.root, depthA, b.root, depthB, decider))
                {
                    return true;
                }
                rootsOverlapped = _uprightBoxes.rootsOverlapped;
            }
            else
            {
                if (_boxes.overlap(a.root, depthA, b.root, depthB, decider))
                {
                    return true;
                }
                rootsOverlapped = _boxes.rootsOverlapped;
            }
            // whose roots do not overlap, as of most that are close and do not collide, are not inside of each other
            return (rootsOverlapped || decider != null) && _containment.isOneInside(a, b);
        }

        /**
         * Whether a model's hierarchy collides with a structure.
         *
         * @param a the model's hierarchy
         * @param placementA where the model stands
         * @param depth how many levels of it are visited
         * @param structure stands for another model, in that one's space
         * @param placementB where the other model stands
         */
        public function structureOverlaps(a:Hierarchy, placementA:Placement, depth:int, structure:BoundingStructure,
                placementB:Placement):Boolean
        {
            if (placementB.size > MUCH_LARGER * placementA.size)
            {
                return isPointInStructure(a.root, placementA, structure, placementB);
            }
            _pose.relate(placementA, placementB);
            if (structure.kind != BoundingStructure.BOX || a.boundsKind != BoundingStructure.BOX)
            {
                return _structures.structureOverlaps(a.root, depth, structure)
                    || (_structures.rootsOverlapped && _containment.isStructureInside(a, structure));
            }
            var box:Box = structure as Box;
            _pose.relateToAxesOf(box);
            var leaf:HierarchyNode = leafOf(box);
            return _boxes.overlap(a.root, depth, leaf, 1, null) || (_boxes.rootsOverlapped && _containment.isLeafInside(a, leaf));
        }

        // The first model is so small that it is a point of the second's space.
        private function isPointInStructure(root:HierarchyNode, placementA:Placement, structure:BoundingStructure,
                placementB:Placement):Boolean
        {
            _pose.relate(placementB, placementA);
            var relative:Placement = _pose.placement;
            _point.center.setTo(relative.x, relative.y, relative.z);
            _point.radius = relative.size * root.radius + _pose.gap;
            return intersects(_point, structure);
        }

        // The box, as wide as a node's would be, in the space of its axes.
        private function leafOf(box:Box):HierarchyNode
        {
            var leaf:HierarchyNode = _leaf;
            var middle:Vector3D = box.center;
            var distance:Number = Math.abs(middle.x) + Math.abs(middle.y) + Math.abs(middle.z);
            var margin:Number = Tolerances.ROUNDING * (box.halfX + box.halfY + box.halfZ + distance);
            var halfX:Number = box.halfX + margin;
            var halfY:Number = box.halfY + margin;
            var halfZ:Number = box.halfZ + margin;
            leaf.halfX = halfX;
            leaf.halfY = halfY;
            leaf.halfZ = halfZ;
            leaf.radius = Math.sqrt(halfX * halfX + halfY * halfY + halfZ * halfZ);
            leaf.innerRadius = halfX < halfY ? halfX : halfY;
            if (halfZ < leaf.innerRadius)
            {
                leaf.innerRadius = halfZ;
            }
            return leaf;
        }
    }
}
