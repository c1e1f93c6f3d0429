package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.intersection.ray.Ray;
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
        private var _origin:HierarchyNode = new HierarchyNode();
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);

        /**
         * Narrows a ray to the part behind its first hit.
         *
         * @param root the tree's root
         * @param depth how many of its levels are visited
         * @param ray in the tree's space; its beginning becomes the hit, with the normal there
         * @return whether there is a hit; if not, the ray stays as it was
         */
        public function findHit(root:HierarchyNode, depth:int, ray:Ray):Boolean
        {
            _ray = ray;
            lowest = ray.from;
            if (!find(_standing, root, depth, _origin, 1, null))
            {
                return false;
            }
            ray.faceBack();
            if (least > ray.from)
            {
                rayBox(ray, firstA.writeBox(_box));
            }
            ray.from = least;
            return true;
        }

        /** @inheritDoc */
        override protected function estimate(a:HierarchyNode, b:HierarchyNode):void
        {
            // For each axis, as Ray.cutAlong(). A call for each would take most of the time.
            var ray:Ray = _ray;
            var enter:Number = bound;
            var leave:Number = ray.to;
            var offset:Number = ray.x - a.x;
            var speed:Number = ray.directionX == 0 ? 0 : ray.directionX;
            var reach:Number = speed < 0 ? -a.halfX : a.halfX;
            var place:Number = (reach - offset) / speed;
            leave = place < leave ? place : leave;
            place = (-reach - offset) / speed;
            enter = place > enter ? place : enter;
            offset = ray.y - a.y;
            speed = ray.directionY == 0 ? 0 : ray.directionY;
            reach = speed < 0 ? -a.halfY : a.halfY;
            place = (reach - offset) / speed;
            leave = place < leave ? place : leave;
            place = (-reach - offset) / speed;
            enter = place > enter ? place : enter;
            offset = ray.z - a.z;
            speed = ray.directionZ == 0 ? 0 : ray.directionZ;
            reach = speed < 0 ? -a.halfZ : a.halfZ;
            place = (reach - offset) / speed;
            leave = place < leave ? place : leave;
            place = (-reach - offset) / speed;
            enter = place > enter ? place : enter;
            bound = enter <= leave ? enter : Infinity;
        }
    }
}
