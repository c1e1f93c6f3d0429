package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.rayStructure;

    use namespace engine;

    /**
     * Finds where a ray first meets a hierarchy, visited to a depth: at the nearest node that is a leaf or at the depth limit.
     *
     * <p>The ray meets a node where it is inside of the node and of all its ancestors. So a greater depth never finds a smaller distance. The
     * nearer child is visited first. Nodes are skipped if a nearer one has been met.</p>
     *
     * @private
     */
    public final class RayTraversal
    {
        // The nodes still to visit, the part of the ray that is inside of their ancestors, and the ancestor on whose surface this part
        // begins, or null.
        private var _nodes:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _entered:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _from:Vector.<Number> = new Vector.<Number>();
        private var _to:Vector.<Number> = new Vector.<Number>();

        // The place of the nearest hit so far.
        private var _best:Number = 0;

        // Holds a node's box.
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);

        /**
         * Narrows a ray to the part behind its first hit.
         *
         * @param root the hierarchy's root
         * @param depth how many levels are visited
         * @param ray in the hierarchy's space; its beginning becomes the hit, with the normal there
         * @return whether there is a hit; if not, the ray's part stays as it was
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
                if (node.stopDepth >= depth)
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
                    rayStructure(ray, hit.writeBox(_box));
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

        // Narrows the ray to the part inside of a node. Returns whether anything is left.
        private static function meets(node:HierarchyNode, ray:Ray):Boolean
        {
            ray.beginWhole();
            ray.cut(ray.x - node.x, ray.directionX, node.halfX);
            ray.cut(ray.y - node.y, ray.directionY, node.halfY);
            ray.cut(ray.z - node.z, ray.directionZ, node.halfZ);
            return ray.narrow();
        }

        // Whether the ray enters the left child first, if it meets both.
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
