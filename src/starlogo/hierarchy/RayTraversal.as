package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.intersection.ray.crossStructure;
    import starlogo.intersection.ray.rayBox;

    use namespace engine;

    /**
     * Finds where a ray first meets a tree: at the nearest node that decides. The ray's origin is a tree of one node without extents.
     *
     * <p>The ray meets a node no earlier than the node's ancestors. So a greater depth never finds a smaller distance.</p>
     *
     * @private
     */
    public final class RayTraversal extends NodePairTraversal
    {
        private var _ray:Ray;
        private var _standing:RelativePose = new RelativePose();
        private var _origin:BoxTree = BoxTree.ofOneNode();
        private var _boxes:Vector.<Number>;
        private var _part:Ray = new Ray();
        private var _all:RayCrossings = null;
        private var _slack:Number = 0;
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);

        /**
         * Narrows a ray to the part behind its first hit.
         *
         * @param tree the tree
         * @param depth how many of its levels are visited
         * @param ray in the tree's space; its beginning becomes the hit, with the normal there
         * @return whether there is a hit; if not, the ray stays as it was
         */
        public function findHit(tree:BoxTree, depth:int, ray:Ray):Boolean
        {
            _ray = ray;
            _all = null;
            bounds.lowest = ray.from;
            if (!find(_standing, tree, depth, _origin, 1, null))
            {
                return false;
            }
            ray.faceBack();
            if (bounds.least > ray.from)
            {
                rayBox(ray, tree.writeBox(firstA, _box));
            }
            ray.from = bounds.least;
            return true;
        }

        /**
         * Adds where a ray enters and leaves each node that decides.
         *
         * @param tree the tree
         * @param depth how many of its levels are visited
         * @param ray in the tree's space; it is not changed
         * @param slack how far a place may be wrong because of rounding
         * @param out the crossings are added to it
         */
        public function findAll(tree:BoxTree, depth:int, ray:Ray, slack:Number, out:RayCrossings):void
        {
            _ray = ray;
            _all = out;
            _slack = slack;
            bounds.lowest = ray.from;
            find(_standing, tree, depth, _origin, 1, null);
        }

        /** @inheritDoc */
        override protected function settle(treeA:BoxTree, a:int, treeB:BoxTree, b:int, leaves:LeafTest, out:NodePairBounds):void
        {
            if (_all != null)
            {
                crossStructure(_ray, treeA.writeBox(a, _box), _slack, _part, null, _all);
                // so the search does not end
                out.current = Infinity;
            }
        }

        /** @inheritDoc */
        override protected function begin(pose:RelativePose, a:BoxTree, b:BoxTree):void
        {
            _boxes = a.boxes;
        }

        /** @inheritDoc */
        override protected function estimate(a:int, b:int, out:NodePairBounds):void
        {
            // For each axis, as Ray.cutAlong(). A call for each would take most of the time.
            var ray:Ray = _ray;
            var boxes:Vector.<Number> = _boxes;
            var at:int = 6 * a;
            var enter:Number = out.current;
            var leave:Number = ray.to;
            var offset:Number = ray.x - boxes[at];
            var speed:Number = ray.directionX == 0 ? 0 : ray.directionX;
            var reach:Number = speed < 0 ? -boxes[int(at + 3)] : boxes[int(at + 3)];
            var place:Number = (reach - offset) / speed;
            leave = place < leave ? place : leave;
            place = (-reach - offset) / speed;
            enter = place > enter ? place : enter;
            offset = ray.y - boxes[int(at + 1)];
            speed = ray.directionY == 0 ? 0 : ray.directionY;
            reach = speed < 0 ? -boxes[int(at + 4)] : boxes[int(at + 4)];
            place = (reach - offset) / speed;
            leave = place < leave ? place : leave;
            place = (-reach - offset) / speed;
            enter = place > enter ? place : enter;
            offset = ray.z - boxes[int(at + 2)];
            speed = ray.directionZ == 0 ? 0 : ray.directionZ;
            reach = speed < 0 ? -boxes[int(at + 5)] : boxes[int(at + 5)];
            place = (reach - offset) / speed;
            leave = place < leave ? place : leave;
            place = (-reach - offset) / speed;
            enter = place > enter ? place : enter;
            out.current = enter <= leave ? enter : Infinity;
        }
    }
}
