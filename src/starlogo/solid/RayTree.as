package starlogo.solid
{
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.TriangleRay;

    /**
     * A tree of boxes around a solid's triangles that goes on below the leaves of the hierarchy, down to a few triangles: for rays. Made by a
     * RayTreeBuilder.
     *
     * <p>A node has the boxes of its two children side by side. For each inner node it takes 104 bytes, for each triangle 4: some 45 bytes
     * a triangle in all.</p>
     */
    internal final class RayTree
    {
        /** How many triangles a leaf has at most. */
        public static const LEAF_SIZE:int = 4;

        /** Numbers of a node: minX, minY, minZ, maxX, maxY, maxZ of its first child, then of its second. */
        public static const PER_NODE:int = 12;

        /** Of each node twelve numbers: the boxes are wider by as much as the widest of a hierarchy. */
        public var boxes:Vector.<Number> = new Vector.<Number>();

        /** Of each node its two children: the number of a node; or for leaves ~(LEAF_SIZE first + count - 1), with the first of their triangles in the order. */
        public var children:Vector.<int> = new Vector.<int>();

        /** The radius of a sphere about the model's origin around all triangles. */
        public var reach:Number = 0;

        /** What holds all triangles: as a child. */
        public var root:int = 0;

        /** The triangles, by their numbers in the solid, those of a leaf side by side. */
        public var order:Vector.<int>;

        // Children that are to be visited yet, and where the ray enters them.
        private var _stack:Vector.<int> = new Vector.<int>();
        private var _enters:Vector.<Number> = new Vector.<Number>();

        /** Without nodes. */
        public function RayTree()
        {
        }

        /**
         * Finds the first triangle that a ray meets. The boxes of a node's children are entered where the last pair of their faces is, in this order:
         * along x, y, z for the first child, then for the second. Where a component of the direction is 0, what is on a face is NaN,
         * and decides nothing.
         *
         * @param ray in the space of the solid
         * @param corners of the solid's triangles
         * @param triangles begun with the ray; has the result
         */
        public function find(ray:Ray, corners:Vector.<Number>, triangles:TriangleRay):void
        {
            var all:Vector.<Number> = boxes;
            var nodes:Vector.<int> = children;
            var stack:Vector.<int> = _stack;
            var enters:Vector.<Number> = _enters;
            var x:Number = ray.x;
            var y:Number = ray.y;
            var z:Number = ray.z;
            var inverseX:Number = ray.directionX == 0 ? Infinity : 1 / ray.directionX;
            var inverseY:Number = ray.directionY == 0 ? Infinity : 1 / ray.directionY;
            var inverseZ:Number = ray.directionZ == 0 ? Infinity : 1 / ray.directionZ;
            // which of a box's faces the ray comes to first
            var nearX:int = inverseX < 0 ? 3 : 0;
            var nearY:int = inverseY < 0 ? 4 : 1;
            var nearZ:int = inverseZ < 0 ? 5 : 2;
            var farX:int = 3 - nearX;
            var farY:int = 5 - nearY;
            var farZ:int = 7 - nearZ;
            var from:Number = ray.from;
            var top:int = 0;
            var node:int = root;
            while (true)
            {
                // set in each round, or V8 carries them from round to round as objects
                var enter:Number = from;
                var leave:Number = triangles.at;
                var enterOther:Number = from;
                var leaveOther:Number = leave;
                var place:Number = 0;
                if (node < 0)
                {
                    var leaf:int = ~node;
                    var first:int = leaf >> 2;
                    triangles.look(corners, order, first, first + (leaf & 3) + 1);
                }
                else
                {
                    var box:int = PER_NODE * node;
                    place = (all[int(box + nearX)] - x) * inverseX;
                    enter = place > enter ? place : enter;
                    place = (all[int(box + farX)] - x) * inverseX;
                    leave = place < leave ? place : leave;
                    place = (all[int(box + nearY)] - y) * inverseY;
                    enter = place > enter ? place : enter;
                    place = (all[int(box + farY)] - y) * inverseY;
                    leave = place < leave ? place : leave;
                    place = (all[int(box + nearZ)] - z) * inverseZ;
                    enter = place > enter ? place : enter;
                    place = (all[int(box + farZ)] - z) * inverseZ;
                    leave = place < leave ? place : leave;
                    box += 6;
                    place = (all[int(box + nearX)] - x) * inverseX;
                    enterOther = place > enterOther ? place : enterOther;
                    place = (all[int(box + farX)] - x) * inverseX;
                    leaveOther = place < leaveOther ? place : leaveOther;
                    place = (all[int(box + nearY)] - y) * inverseY;
                    enterOther = place > enterOther ? place : enterOther;
                    place = (all[int(box + farY)] - y) * inverseY;
                    leaveOther = place < leaveOther ? place : leaveOther;
                    place = (all[int(box + nearZ)] - z) * inverseZ;
                    enterOther = place > enterOther ? place : enterOther;
                    place = (all[int(box + farZ)] - z) * inverseZ;
                    leaveOther = place < leaveOther ? place : leaveOther;
                    var child:int = node << 1;
                    if (enter <= leave)
                    {
                        node = nodes[child];
                        if (enterOther <= leaveOther)
                        {
                            var other:int = nodes[int(child + 1)];
                            if (enterOther < enter)
                            {
                                stack[top] = node;
                                enters[top] = enter;
                                node = other;
                            }
                            else
                            {
                                stack[top] = other;
                                enters[top] = enterOther;
                            }
                            top++;
                        }
                        continue;
                    }
                    if (enterOther <= leaveOther)
                    {
                        node = nodes[int(child + 1)];
                        continue;
                    }
                }
                do
                {
                    if (top == 0)
                    {
                        return;
                    }
                    top--;
                }
                while (enters[top] > triangles.at);
                node = stack[top];
            }
        }
    }
}
