package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.HierarchyNode;

    use namespace engine;

    /**
     * Whether a point has an open side: from there, a ray along an axis meets no node of a tree. Then no surface is around the point. This needs
     * nothing but the tree. It is asked before the inside of a model is known, because a level is mostly open to the sky.
     */
    internal final class AxisEscapeTest
    {
        private var _x:Number;
        private var _y:Number;
        private var _z:Number;
        private var _margin:Number;

        // The ray's axis, and 1 or -1 along it.
        private var _axis:int;
        private var _side:int;

        /** Whether a ray from the point along one of the six directions of the axes meets no node of the tree. */
        public function hasOpenSide(point:Vector3D, root:HierarchyNode):Boolean
        {
            _x = point.x;
            _y = point.y;
            _z = point.z;
            // Corners may move when seams are welded.
            _margin = 8 * Tolerances.WELDING * (root.radius + Math.abs(root.x) + Math.abs(root.y) + Math.abs(root.z));
            for (var i:int = 5; i >= 0; i--)
            {
                _axis = i >> 1;
                _side = (i & 1) == 0 ? -1 : 1;
                if (!meets(root))
                {
                    return true;
                }
            }
            return false;
        }

        private function meets(node:HierarchyNode):Boolean
        {
            return reaches(0, node.x - _x, node.halfX) && reaches(1, node.y - _y, node.halfY) && reaches(2, node.z - _z, node.halfZ)
                && (node.low == null || meets(node.low) || meets(node.high));
        }

        private function reaches(axis:int, middle:Number, half:Number):Boolean
        {
            half += _margin;
            return axis == _axis ? _side * middle >= -half : middle <= half && middle >= -half;
        }
    }
}
