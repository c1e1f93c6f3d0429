package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;

    /**
     * A structure's core as a sum of segments about a middle: three segments for a box, one for a capsule's axis, none for a sphere's centre. A hull
     * is no such sum. In its place stands the box around its extents, so that tests which rule out what is far still hold.
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

        /** The radius around the core: 0 for a box. */
        public var radius:Number = 0;

        /** How far the sum extends from its middle in the direction of the last <code>measure()</code>. */
        public var projectedRadius:Number = 0;

        private var _halves:Vector.<Number> = new Vector.<Number>(3, true);
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        /** Sets the sum to the core of a Box, a Capsule, a Sphere or a Hull. */
        public function setTo(structure:BoundingStructure):void
        {
            x = y = z = 0;
            end = 0;
            radius = 0;
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
            if (structure.kind > BoundingStructure.BOX)
            {
                setToExtents(structure);
                return;
            }
            if (structure.kind == BoundingStructure.SPHERE)
            {
                var sphere:Sphere = Sphere(structure);
                moveBy(sphere.center, 1);
                radius = sphere.radius;
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
            radius = capsule.radius;
        }

        /** Measures how far the sum extends in a direction of any length, as a multiple of that length. */
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
            projectedRadius = sum;
        }

        /** Finds the point of the sum that is nearest to a place, if the segments are perpendicular to each other. */
        public function nearestInto(out:Vector3D, place:Vector3D):void
        {
            var toX:Number = place.x - x;
            var toY:Number = place.y - y;
            var toZ:Number = place.z - z;
            out.setTo(x, y, z);
            for (var at:int = 0; at < end; at += 3)
            {
                var half:Number = _halves[int(at / 3)];
                var along:Number = directions[at] * toX + directions[int(at + 1)] * toY + directions[int(at + 2)] * toZ;
                along = Math.max(-half, Math.min(half, along));
                out.x += along * directions[at];
                out.y += along * directions[int(at + 1)];
                out.z += along * directions[int(at + 2)];
            }
        }

        private function setToExtents(structure:BoundingStructure):void
        {
            structure.extentsInto(_extents);
            x += (_extents[0] + _extents[1]) / 2;
            y += (_extents[2] + _extents[3]) / 2;
            z += (_extents[4] + _extents[5]) / 2;
            for (var i:int = 0; i < 3; i++)
            {
                _halves[i] = (_extents[int(2 * i + 1)] - _extents[int(2 * i)]) / 2;
            }
            add(Vector3D.X_AXIS);
            add(Vector3D.Y_AXIS);
            add(Vector3D.Z_AXIS);
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
