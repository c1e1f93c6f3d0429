package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.rayStructure;

    use namespace engine;

    /**
     * Finds where a ray first meets a hierarchy, visited to a depth: the nearest of the nodes that are leaves or at the depth limit.
     *
     * <p>A node is met where the ray is in it and in all of its ancestors, so that a greater depth never finds a smaller distance: a child's
     * sphere may reach out of its parent's. The nearer child is visited first; nodes are left out where a nearer one has been met.</p>
     *
     * @private
     */
    public final class RayTraversal
    {
        // Nodes that are to be visited yet; the part of the ray that is in their ancestors, and the ancestor at whose surface it begins, or null.
        private var _nodes:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _entered:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _from:Vector.<Number> = new Vector.<Number>();
        private var _to:Vector.<Number> = new Vector.<Number>();

        // Where the nearest hit so far is.
        private var _best:Number = 0;

        // Stands for a node.
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);

        /** Nothing visited yet. */
        public function RayTraversal()
        {
        }

        /**
         * Narrows a ray to what is behind its first hit.
         *
         * @param root the hierarchy's
         * @param depth how many levels are visited
         * @param ray in the hierarchy's space; its beginning becomes the hit, with the normal there
         * @return whether there is a hit; if not, the ray's part is as it was
         */
        public function find(root:HierarchyNode, depth:int, ray:Ray):Boolean
        {
            var start:Number = ray.from;
            var end:Number = ray.to;
            var hit:HierarchyNode = null;
            var isHit:Boolean = false;
            _best = Infinity;
            var waiting:int = push(0, root, null, ray);
            while (waiting > 0)
            {
                waiting--;
                var node:HierarchyNode = _nodes[waiting];
                var entered:HierarchyNode = _entered[waiting];
                ray.from = _from[waiting];
                ray.to = _to[waiting];
                if (isHit && ray.from >= _best || !meets(node, ray))
                {
                    continue;
                }
                if (ray.from > _from[waiting])
                {
                    entered = node;
                }
                if (node.cutoffLevel >= depth)
                {
                    if (!isHit || ray.from < _best)
                    {
                        isHit = true;
                        hit = entered;
                        _best = ray.from;
                    }
                }
                else if (isLeftFirst(node, ray))
                {
                    waiting = push(waiting, node.high, entered, ray);
                    waiting = push(waiting, node.low, entered, ray);
                }
                else
                {
                    waiting = push(waiting, node.low, entered, ray);
                    waiting = push(waiting, node.high, entered, ray);
                }
            }
            ray.from = start;
            ray.to = end;
            if (isHit)
            {
                ray.faceBack();
                if (hit != null)
                {
                    rayStructure(ray, hit.hierarchy.boundsKind == BoundingStructure.BOX ? hit.writeBox(_box) : hit.structure);
                }
                ray.from = _best;
                ray.to = end;
            }
            return isHit;
        }

        private function push(at:int, node:HierarchyNode, entered:HierarchyNode, ray:Ray):int
        {
            _nodes[at] = node;
            _entered[at] = entered;
            _from[at] = ray.from;
            _to[at] = ray.to;
            return at + 1;
        }

        // Narrows the ray to what is inside of a node.
        private static function meets(node:HierarchyNode, ray:Ray):Boolean
        {
            if (node.hierarchy.boundsKind != BoundingStructure.BOX)
            {
                return rayStructure(ray, node.structure);
            }
            ray.beginWhole();
            ray.offset = ray.x - node.x;
            ray.speed = ray.directionX;
            ray.half = node.halfX;
            ray.cut();
            ray.offset = ray.y - node.y;
            ray.speed = ray.directionY;
            ray.half = node.halfY;
            ray.cut();
            ray.offset = ray.z - node.z;
            ray.speed = ray.directionZ;
            ray.half = node.halfZ;
            ray.cut();
            return ray.narrow();
        }

        // Whether the ray comes through the left child sooner, if through both.
        private static function isLeftFirst(node:HierarchyNode, ray:Ray):Boolean
        {
            if (node.splitAxis == 0)
            {
                return ray.directionX >= 0;
            }
            return node.splitAxis == 1 ? ray.directionY >= 0 : ray.directionZ >= 0;
        }
    }
}
