package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayTriangleTest;

    use namespace engine;

    /**
     * Finds the first triangle of a model that a ray meets. It uses the boxes of the model's hierarchy, the nearer of two children first.
     */
    internal final class TriangleRayTraversal
    {
        private var _triangles:RayTriangleTest = new RayTriangleTest();

        // The nodes still to visit, and where the ray enters them.
        private var _stack:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _enters:Vector.<Number> = new Vector.<Number>();

        /** The place on the ray where it meets the triangle found. */
        public function get at():Number
        {
            return _triangles.at;
        }

        /**
         * Finds the triangle. If a component of the direction is 0, a ray in a face's plane gives NaN, which decides nothing.
         *
         * @param root the node around all triangles
         * @param corners the triangles' corners
         * @param ray in the triangles' space
         * @return the triangle's index in the hierarchy's order, or -1
         */
        public function find(root:HierarchyNode, corners:Vector.<Number>, ray:Ray):int
        {
            var triangles:RayTriangleTest = _triangles;
            var stack:Vector.<HierarchyNode> = _stack;
            var enters:Vector.<Number> = _enters;
            var x:Number = ray.x;
            var y:Number = ray.y;
            var z:Number = ray.z;
            var inverseX:Number = ray.directionX == 0 ? Infinity : 1 / ray.directionX;
            var inverseY:Number = ray.directionY == 0 ? Infinity : 1 / ray.directionY;
            var inverseZ:Number = ray.directionZ == 0 ? Infinity : 1 / ray.directionZ;
            // the side of a box on which the ray leaves it
            var sideX:Number = inverseX < 0 ? -1 : 1;
            var sideY:Number = inverseY < 0 ? -1 : 1;
            var sideZ:Number = inverseZ < 0 ? -1 : 1;
            var from:Number = ray.from;
            var half:Number;
            var middle:Number;
            var place:Number;
            var top:int = 0;
            var node:HierarchyNode = root;
            triangles.begin(ray, reachOf(root));
            while (true)
            {
                var low:HierarchyNode = node.low;
                if (low == null)
                {
                    triangles.look(corners, node.first, node.end);
                }
                else
                {
                    var high:HierarchyNode = node.high;
                    var enter:Number;
                    var leave:Number;
                    var child:HierarchyNode = high;
                    include "rayAndNode.inc";
                    var enterHigh:Number = enter;
                    var leaveHigh:Number = leave;
                    child = low;
                    include "rayAndNode.inc";
                    if (enter <= leave)
                    {
                        node = low;
                        if (enterHigh <= leaveHigh)
                        {
                            if (enterHigh < enter)
                            {
                                stack[top] = low;
                                enters[top] = enter;
                                node = high;
                            }
                            else
                            {
                                stack[top] = high;
                                enters[top] = enterHigh;
                            }
                            top++;
                        }
                        continue;
                    }
                    if (enterHigh <= leaveHigh)
                    {
                        node = high;
                        continue;
                    }
                }
                do
                {
                    if (top == 0)
                    {
                        return triangles.triangle;
                    }
                    top--;
                }
                while (enters[top] > triangles.at);
                node = stack[top];
            }
            return -1;
        }

        // The radius of a sphere about the model's origin that encloses all triangles. The rounding error is relative to it.
        private static function reachOf(root:HierarchyNode):Number
        {
            var reach:Number = Math.max(Math.abs(root.x) + root.halfX, Math.abs(root.y) + root.halfY);
            return Math.sqrt(3) * Math.max(reach, Math.abs(root.z) + root.halfZ);
        }
    }
}
