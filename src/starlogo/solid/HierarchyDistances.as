package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxDistances;
    import starlogo.hierarchy.DistanceTraversal;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.RelativePose;
    import starlogo.intersection.distance.ClosestPair;

    use namespace engine;

    /**
     * Finds how far two hierarchies are apart, or one and a structure, and between which points: of the nodes that a HierarchyTraversal tests,
     * or of the triangles. Whether they touch is for that one to say: of those that do, a point of both is found.
     *
     * <p>Scratch objects are reused: nothing is allocated once the stacks have grown and the models' triangles were prepared.</p>
     *
     * @private
     */
    public final class HierarchyDistances
    {
        private var _pose:RelativePose = new RelativePose();
        private var _boxes:BoxDistances;
        private var _structures:DistanceTraversal;
        private var _triangles:NearestTriangles;
        private var _containment:ContainmentTest;

        // Stands for a structure.
        private var _leaf:HierarchyNode = new HierarchyNode();

        /** Nothing found yet. */
        public function HierarchyDistances()
        {
            _boxes = new BoxDistances(_pose);
            _structures = new DistanceTraversal(_pose);
            _triangles = new NearestTriangles(_pose);
            _containment = new ContainmentTest(_pose);
            _leaf.x = _leaf.y = _leaf.z = 0;
        }

        /** Pairs of nodes that were visited. */
        public function get nodeVisits():int
        {
            return _boxes.nodeVisits + _structures.nodeVisits;
        }

        /** Pairs of triangles that were measured. */
        public function get triangleTests():int
        {
            return _triangles.triangleTests;
        }

        /**
         * Finds how far two models are apart by their hierarchies.
         *
         * @param a the first model's hierarchy
         * @param placementA where the first model stands
         * @param depthA how many levels of it are visited
         * @param b the second model's hierarchy
         * @param placementB where the second model stands
         * @param depthB how many levels of that are visited
         * @param exact whether, for two hierarchies of triangles, depths do not count and triangles decide
         * @param areTouching whether the two touch, by the HierarchyTraversal
         * @param out takes it, in the world
         */
        public function betweenHierarchies(a:SolidHierarchy, placementA:Placement, depthA:int, b:SolidHierarchy, placementB:Placement,
                depthB:int, exact:Boolean, areTouching:Boolean, out:ClosestPair):void
        {
            _pose.relate(placementA, placementB);
            if (exact && a.hasTriangles && b.hasTriangles)
            {
                _triangles.begin(a.solid, b.solid);
                _boxes.find(a.root, int.MAX_VALUE, b.root, int.MAX_VALUE, _triangles);
                out.copyPoints(_triangles.nearest.points);
                out.distance = _triangles.least;
            }
            else
            {
                var areBoxes:Boolean = a.boundsKind == BoundingStructure.BOX && b.boundsKind == BoundingStructure.BOX;
                var traversal:DistanceTraversal = areBoxes ? _boxes : _structures;
                traversal.find(a.root, depthA, b.root, depthB, null);
                traversal.writePoints(out);
            }
            var isInside:Boolean = areTouching && out.distance > 0 && _containment.isOneInside(a, b);
            finish(placementA, placementB, areTouching, isInside, out);
        }

        /**
         * Finds how far a model's hierarchy and a structure are apart.
         *
         * @param a the model's hierarchy
         * @param placementA where the model stands
         * @param depth how many levels of it are visited
         * @param structure represents another model, in that model's space
         * @param placementB where the other model stands
         * @param areTouching whether the two touch, by the HierarchyTraversal
         * @param out takes it, in the world
         */
        public function toStructure(a:SolidHierarchy, placementA:Placement, depth:int, structure:BoundingStructure, placementB:Placement,
                areTouching:Boolean, out:ClosestPair):void
        {
            _pose.relate(placementA, placementB);
            if (_leaf.structure !== structure)
            {
                _leaf.structure = structure;
            }
            setReach(structure);
            _structures.find(a.root, depth, _leaf, 1, null);
            _structures.writePoints(out);
            var isInside:Boolean = areTouching && out.distance > 0 && _containment.isStructureInside(a, structure);
            finish(placementA, placementB, areTouching, isInside, out);
        }

        // How far the structure reaches from its middle, or a little farther.
        private function setReach(structure:BoundingStructure):void
        {
            if (structure.kind == BoundingStructure.BOX)
            {
                var box:Box = Box(structure);
                _leaf.radius = box.halfX + box.halfY + box.halfZ;
                return;
            }
            if (structure.kind == BoundingStructure.SPHERE)
            {
                _leaf.radius = Sphere(structure).radius;
                return;
            }
            var capsule:Capsule = Capsule(structure);
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            _leaf.radius = capsule.radius + Math.abs(end.x - start.x) + Math.abs(end.y - start.y) + Math.abs(end.z - start.z);
        }

        // Takes the points into the world, where the spaces are those of two placements.
        private function finish(placementA:Placement, placementB:Placement, areTouching:Boolean, isInside:Boolean, out:ClosestPair):void
        {
            out.distance *= placementA.size;
            if (isInside)
            {
                var point:Vector3D = _containment.innerPoint;
                out.aX = out.bX = point.x;
                out.aY = out.bY = point.y;
                out.aZ = out.bZ = point.z;
            }
            out.settle(areTouching);
            out.place(isInside && _containment.isPointOfSecond ? placementB : placementA);
        }
    }
}
