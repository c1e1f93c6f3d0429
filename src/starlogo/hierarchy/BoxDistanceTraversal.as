package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.distance.DistanceResult;
    import starlogo.intersection.distance.findClosest;

    use namespace engine;

    /**
     * Finds the distance of two trees. The gap between two boxes' extents, along the axes of one box or the other, is a lower bound of their
     * distance and takes few products. Only pairs that decide are measured exactly.
     *
     * <p>The results are nested, to the last bit: a result is never greater than the result for greater depths, or for the leaves'
     * contents. Nodes are a little larger than the nodes below them (Tolerances.NESTING). That outweighs the rounding of short distances.
     * To outweigh the rounding of long distances, a measured distance is reduced a little. The deeper the nodes are, the less it is
     * reduced.</p>
     *
     * @private
     */
    public final class BoxDistanceTraversal extends NodePairTraversal
    {
        /** What stands for the second model, in the first model's space: see StructureLeaf. Null if it is a tree. */
        public var structure:BoundingStructure = null;

        /** The closest points of the nearest pair, in the first model's space. */
        public var points:DistanceResult = new DistanceResult();

        // An estimate is smaller than the distances below it by this fraction, which is more than the errors of rounding and nesting.
        private static const SLACK:Number = 1e-12;

        // The rotation times the scale, its absolute values, and the scale.
        private var _m00:Number;
        private var _m01:Number;
        private var _m02:Number;
        private var _m10:Number;
        private var _m11:Number;
        private var _m12:Number;
        private var _m20:Number;
        private var _m21:Number;
        private var _m22:Number;
        private var _abs00:Number;
        private var _abs01:Number;
        private var _abs02:Number;
        private var _abs10:Number;
        private var _abs11:Number;
        private var _abs12:Number;
        private var _abs20:Number;
        private var _abs21:Number;
        private var _abs22:Number;
        private var _scale:Number;

        // How far both models together extend from their middles. The rounding error is relative to it.
        private var _reach:Number;

        // The vector from the first model's point to the second's at the smallest distance so far.
        private var _directionX:Number;
        private var _directionY:Number;
        private var _directionZ:Number;

        private var _measured:DistanceResult = new DistanceResult();
        private var _boxA:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        private var _boxB:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        private var _moved:BoundingStructure = _boxB.clone();

        /** @inheritDoc */
        override protected function begin(a:HierarchyNode, b:HierarchyNode):void
        {
            _directionX = _directionY = _directionZ = 0;
            var relative:Placement = pose.placement;
            var scale:Number = relative.size;
            _scale = scale;
            _reach = a.radius + b.radius * scale;
            _m00 = relative.r00 * scale;
            _m01 = relative.r01 * scale;
            _m02 = relative.r02 * scale;
            _m10 = relative.r10 * scale;
            _m11 = relative.r11 * scale;
            _m12 = relative.r12 * scale;
            _m20 = relative.r20 * scale;
            _m21 = relative.r21 * scale;
            _m22 = relative.r22 * scale;
            _abs00 = Math.abs(_m00);
            _abs01 = Math.abs(_m01);
            _abs02 = Math.abs(_m02);
            _abs10 = Math.abs(_m10);
            _abs11 = Math.abs(_m11);
            _abs12 = Math.abs(_m12);
            _abs20 = Math.abs(_m20);
            _abs21 = Math.abs(_m21);
            _abs22 = Math.abs(_m22);
        }

        /**
         * @inheritDoc
         *
         * <p>The steps are: the vector from the middle of a's box to the middle of b's box; the gaps along a's axes; the gaps along b's axes;
         * the gap along the line between the closest points so far.</p>
         */
        override protected function estimate(a:HierarchyNode, b:HierarchyNode):void
        {
            var bX:Number = b.x;
            var bY:Number = b.y;
            var bZ:Number = b.z;
            var x:Number = _m00 * bX + _m01 * bY + _m02 * bZ + pose.placement.x - a.x;
            var y:Number = _m10 * bX + _m11 * bY + _m12 * bZ + pose.placement.y - a.y;
            var z:Number = _m20 * bX + _m21 * bY + _m22 * bZ + pose.placement.z - a.z;

            bX = b.halfX;
            bY = b.halfY;
            bZ = b.halfZ;
            var halfX:Number = a.halfX;
            var halfY:Number = a.halfY;
            var halfZ:Number = a.halfZ;
            var squared:Number = 0;
            var gap:Number = x < 0 ? -x : x;
            gap -= halfX + _abs00 * bX + _abs01 * bY + _abs02 * bZ;
            if (gap > 0)
            {
                squared = gap * gap;
            }
            gap = y < 0 ? -y : y;
            gap -= halfY + _abs10 * bX + _abs11 * bY + _abs12 * bZ;
            if (gap > 0)
            {
                squared += gap * gap;
            }
            gap = z < 0 ? -z : z;
            gap -= halfZ + _abs20 * bX + _abs21 * bY + _abs22 * bZ;
            if (gap > 0)
            {
                squared += gap * gap;
            }

            // A pair that is too far away anyway need not be estimated exactly.
            var far:Number = least + pose.gap + 2 * SLACK * (least + _reach);
            if (squared > far * far)
            {
                bound = least;
                return;
            }

            // These products contain the scale.
            var scale:Number = _scale;
            var squaredInB:Number = 0;
            gap = _m00 * x + _m10 * y + _m20 * z;
            gap = gap < 0 ? -gap : gap;
            gap = (gap - _abs00 * halfX - _abs10 * halfY - _abs20 * halfZ) / scale - scale * bX;
            if (gap > 0)
            {
                squaredInB = gap * gap;
            }
            gap = _m01 * x + _m11 * y + _m21 * z;
            gap = gap < 0 ? -gap : gap;
            gap = (gap - _abs01 * halfX - _abs11 * halfY - _abs21 * halfZ) / scale - scale * bY;
            if (gap > 0)
            {
                squaredInB += gap * gap;
            }
            gap = _m02 * x + _m12 * y + _m22 * z;
            gap = gap < 0 ? -gap : gap;
            gap = (gap - _abs02 * halfX - _abs12 * halfY - _abs22 * halfZ) / scale - scale * bZ;
            if (gap > 0)
            {
                squaredInB += gap * gap;
            }
            var apart:Number = Math.sqrt(squared > squaredInB ? squared : squaredInB);

            // This line rules out most of the pairs that are not nearer.
            var toX:Number = _directionX;
            var toY:Number = _directionY;
            var toZ:Number = _directionZ;
            var length:Number = Math.sqrt(toX * toX + toY * toY + toZ * toZ);
            if (length > 0)
            {
                var reachX:Number = toX * _m00 + toY * _m10 + toZ * _m20;
                var reachY:Number = toX * _m01 + toY * _m11 + toZ * _m21;
                var reachZ:Number = toX * _m02 + toY * _m12 + toZ * _m22;
                reachX = reachX < 0 ? -reachX : reachX;
                reachY = reachY < 0 ? -reachY : reachY;
                reachZ = reachZ < 0 ? -reachZ : reachZ;
                gap = x * toX + y * toY + z * toZ - reachX * bX - reachY * bY - reachZ * bZ;
                toX = toX < 0 ? -toX : toX;
                toY = toY < 0 ? -toY : toY;
                toZ = toZ < 0 ? -toZ : toZ;
                gap = (gap - halfX * toX - halfY * toY - halfZ * toZ) / length;
                if (gap > apart)
                {
                    apart = gap;
                }
            }
            apart -= SLACK * (apart + _reach) + pose.gap;
            if (apart > bound)
            {
                bound = apart;
            }
        }

        /** @inheritDoc */
        override protected function settle(a:HierarchyNode, b:HierarchyNode, leaves:LeafTest):void
        {
            var found:DistanceResult = _measured;
            if (leaves == null)
            {
                measure(a, b);
            }
            else
            {
                leaves.least = least;
                bound = leaves.touch(a, b) ? leaves.least : Infinity;
                found = leaves.points;
            }
            if (bound < least)
            {
                points.copyPoints(found);
                _directionX = found.bX - found.aX;
                _directionY = found.bY - found.aY;
                _directionZ = found.bZ - found.aZ;
            }
        }

        // Measures the distance of two nodes.
        private function measure(a:HierarchyNode, b:HierarchyNode):void
        {
            var second:BoundingStructure = structure;
            if (second == null)
            {
                second = b.writeBox(_boxB).place(pose.placement, _moved);
                pose.widen(second);
            }
            findClosest(a.writeBox(_boxA), second, _measured);
            var distance:Number = _measured.distance;
            bound = distance - Tolerances.NESTING * (levelsBelow(a) + levelsBelow(b)) * (distance + _reach);
            if (!(bound > 0))
            {
                bound = 0;
            }
        }

        // The number of levels that a tree may have below a node, plus one. A single structure counts as the last level.
        private static function levelsBelow(node:HierarchyNode):int
        {
            var level:int = node.level;
            return level == 0 || level > Tolerances.NESTED_LEVELS ? 1 : 1 + Tolerances.NESTED_LEVELS - level;
        }
    }
}
