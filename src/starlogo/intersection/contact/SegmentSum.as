package starlogo.intersection.contact
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    /**
     * A box or a capsule's axis as the sum of three segments, or one, about a middle.
     *
     * @private
     */
    public final class SegmentSum
    {
        /** The middle. */
        public var x:Number;

        /** @copy #x */
        public var y:Number;

        /** @copy #x */
        public var z:Number;

        /** The segments' directions, unit vectors. */
        public var directions:Vector.<Number> = new Vector.<Number>(9, true);

        /** The index after the last number of these. */
        public var end:int;

        private var _halves:Vector.<Number> = new Vector.<Number>(3, true);

        /** No sum yet. */
        public function SegmentSum()
        {
        }

        /**
         * Sets the sum to that of a structure.
         *
         * @param structure a Box, or a Capsule of which the axis counts
         * @param x how far it is displaced
         * @param y likewise
         * @param z likewise
         */
        public function setTo(structure:BoundingStructure, x:Number, y:Number, z:Number):void
        {
            this.x = x;
            this.y = y;
            this.z = z;
            end = 0;
            if (structure.kind == BoundingStructure.BOX)
            {
                var box:Box = Box(structure);
                moveBy(box.center, 1);
                add(box.axisX, box.halfX);
                add(box.axisY, box.halfY);
                add(box.axisZ, box.halfZ);
                return;
            }
            var capsule:Capsule = Capsule(structure);
            moveBy(capsule.start, 0.5);
            moveBy(capsule.end, 0.5);
            var alongX:Number = capsule.end.x - capsule.start.x;
            var alongY:Number = capsule.end.y - capsule.start.y;
            var alongZ:Number = capsule.end.z - capsule.start.z;
            var length:Number = Math.sqrt(alongX * alongX + alongY * alongY + alongZ * alongZ);
            if (length > 0)
            {
                directions[0] = alongX / length;
                directions[1] = alongY / length;
                directions[2] = alongZ / length;
                _halves[0] = length / 2;
                end = 3;
            }
        }

        /** How far it reaches from its middle in a direction. */
        public function reach(x:Number, y:Number, z:Number):Number
        {
            var sum:Number = 0;
            for (var at:int = 0; at < end; at += 3)
            {
                var along:Number = directions[at] * x + directions[int(at + 1)] * y + directions[int(at + 2)] * z;
                sum += _halves[int(at / 3)] * Math.abs(along);
            }
            return sum;
        }

        /** Writes the feature that is farthest out in a direction: a corner, an edge or a face. */
        public function supportInto(polygon:Polygon, x:Number, y:Number, z:Number):void
        {
            polygon.setPoint(this.x, this.y, this.z);
            for (var at:int = 0; at < end; at += 3)
            {
                var dx:Number = directions[at];
                var dy:Number = directions[int(at + 1)];
                var dz:Number = directions[int(at + 2)];
                var half:Number = _halves[int(at / 3)];
                var along:Number = dx * x + dy * y + dz * z;
                if (along > Tolerances.DIRECTION)
                {
                    polygon.moveBy(half * dx, half * dy, half * dz);
                }
                else if (along < -Tolerances.DIRECTION)
                {
                    polygon.moveBy(-half * dx, -half * dy, -half * dz);
                }
                else if (half > 0)
                {
                    polygon.widenBy(half * dx, half * dy, half * dz);
                }
            }
        }

        private function moveBy(point:Vector3D, share:Number):void
        {
            x += share * point.x;
            y += share * point.y;
            z += share * point.z;
        }

        private function add(axis:Vector3D, half:Number):void
        {
            directions[end] = axis.x;
            directions[int(end + 1)] = axis.y;
            directions[int(end + 2)] = axis.z;
            _halves[int(end / 3)] = half;
            end += 3;
        }
    }
}
