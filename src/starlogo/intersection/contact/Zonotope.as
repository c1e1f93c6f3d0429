package starlogo.intersection.contact
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.sweep.RelativeMotion;

    /**
     * A box, a capsule's axis or a sphere's centre as a sum of segments about a middle: three segments for a box, one for an axis.
     *
     * @private
     */
    public final class Zonotope
    {
        /** The middle. */
        public var x:Number;
        public var y:Number;
        public var z:Number;

        /** The segments' directions: unit vectors, or 0 for a segment without length. */
        public var directions:Vector.<Number> = new Vector.<Number>(9, true);

        /** The index after the last number of the directions. */
        public var end:int;

        /** How far the sum extends from its middle in the direction of the last <code>measure()</code>. */
        public var reach:Number = 0;

        private var _halves:Vector.<Number> = new Vector.<Number>(3, true);

        /**
         * Sets the sum to a structure.
         *
         * @param structure a Box, a Capsule whose axis is taken, or a Sphere whose centre is taken
         * @param displacement moves the structure from its stored place
         */
        public function setTo(structure:BoundingStructure, displacement:RelativeMotion):void
        {
            x = displacement.startX;
            y = displacement.startY;
            z = displacement.startZ;
            end = 0;
            if (structure.kind == BoundingStructure.BOX)
            {
                var box:Box = Box(structure);
                moveBy(box.center, 1);
                add(box.axisX);
                add(box.axisY);
                add(box.axisZ);
                _halves[0] = box.halfX;
                _halves[1] = box.halfY;
                _halves[2] = box.halfZ;
                return;
            }
            if (structure.kind == BoundingStructure.SPHERE)
            {
                var sphere:Sphere = Sphere(structure);
                moveBy(sphere.center, 1);
                return;
            }
            var capsule:Capsule = Capsule(structure);
            moveBy(capsule.start, 0.5);
            moveBy(capsule.end, 0.5);
            var alongX:Number = capsule.end.x - capsule.start.x;
            var alongY:Number = capsule.end.y - capsule.start.y;
            var alongZ:Number = capsule.end.z - capsule.start.z;
            var length:Number = Math.sqrt(alongX * alongX + alongY * alongY + alongZ * alongZ);
            _halves[0] = length / 2;
            length = length > 0 ? length : 1;
            directions[0] = alongX / length;
            directions[1] = alongY / length;
            directions[2] = alongZ / length;
            end = 3;
        }

        /** Measures how far the sum extends in a direction, which must be a unit vector. */
        public function measure(direction:Vector3D):void
        {
            var toX:Number = direction.x;
            var toY:Number = direction.y;
            var toZ:Number = direction.z;
            var sum:Number = 0;
            for (var at:int = 0; at < end; at += 3)
            {
                var along:Number = directions[at] * toX + directions[int(at + 1)] * toY + directions[int(at + 2)] * toZ;
                sum += _halves[int(at / 3)] * Math.abs(along);
            }
            reach = sum;
        }

        /** Writes the feature that is farthest in a direction: a corner, an edge or a face. */
        public function supportInto(feature:ContactFeature, direction:Vector3D):void
        {
            feature.clear();
            feature.setVector(x, y, z);
            feature.add();
            for (var at:int = 0; at < end; at += 3)
            {
                var dx:Number = directions[at];
                var dy:Number = directions[int(at + 1)];
                var dz:Number = directions[int(at + 2)];
                var half:Number = _halves[int(at / 3)];
                var along:Number = dx * direction.x + dy * direction.y + dz * direction.z;
                half = along < -Tolerances.DIRECTION ? -half : half;
                feature.setVector(half * dx, half * dy, half * dz);
                if (along > Tolerances.DIRECTION || along < -Tolerances.DIRECTION)
                {
                    feature.move();
                }
                else if (half > 0)
                {
                    feature.widen();
                }
            }
        }

        private function moveBy(point:Vector3D, share:Number):void
        {
            x += share * point.x;
            y += share * point.y;
            z += share * point.z;
        }

        private function add(axis:Vector3D):void
        {
            directions[end] = axis.x;
            directions[int(end + 1)] = axis.y;
            directions[int(end + 2)] = axis.z;
            end += 3;
        }
    }
}
