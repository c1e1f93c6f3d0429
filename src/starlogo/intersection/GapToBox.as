package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;

    /**
     * Finds a direction along which a structure and an axis-aligned box are apart, and how far. The gap is a lower bound of their distance:
     * exact for spheres, nearly exact for capsules and boxes. The results are fields, because V8 makes objects for Numbers that are passed.
     *
     * @private
     */
    public final class GapToBox
    {
        /** The box: its least corner and its greatest corner. */
        public var low:Vector3D = new Vector3D();
        public var high:Vector3D = new Vector3D();

        /** How far the two are apart along the direction; less than 0 if no such direction was found. */
        public var gap:Number = 0;

        /** The direction, from the box to the structure. */
        public var along:Vector3D = new Vector3D();

        private var _core:Vector3D = new Vector3D();
        private var _place:Vector3D = new Vector3D();

        /** Finds the direction and the gap. */
        public function find(structure:BoundingStructure):void
        {
            _place.setTo((low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2);
            for (var i:int = 0; i < 2; i++)
            {
                moveToCore(structure);
                _place.setTo(Math.max(low.x, Math.min(high.x, _core.x)), Math.max(low.y, Math.min(high.y, _core.y)), Math.max(low.z, Math.min(high.z, _core.z)));
            }
            moveToCore(structure);
            along.setTo(_core.x - _place.x, _core.y - _place.y, _core.z - _place.z);
            var length:Number = Math.sqrt(along.x * along.x + along.y * along.y + along.z * along.z);
            gap = -1;
            if (length > 0)
            {
                along.scaleBy(1 / length);
                findGap(structure);
            }
        }

        // Finds the point of the structure's core that is nearest to the place.
        private function moveToCore(structure:BoundingStructure):void
        {
            if (structure.kind == BoundingStructure.BOX)
            {
                var box:Box = Box(structure);
                _core.copyFrom(box.center);
                goAlong(box.axisX, box.halfX, box.center);
                goAlong(box.axisY, box.halfY, box.center);
                goAlong(box.axisZ, box.halfZ, box.center);
            }
            else if (structure.kind == BoundingStructure.CAPSULE)
            {
                var capsule:Capsule = Capsule(structure);
                var x:Number = capsule.end.x - capsule.start.x;
                var y:Number = capsule.end.y - capsule.start.y;
                var z:Number = capsule.end.z - capsule.start.z;
                var part:Number = (x * (_place.x - capsule.start.x) + y * (_place.y - capsule.start.y) + z * (_place.z - capsule.start.z)) / (x * x + y * y + z * z);
                part = part > 0 ? Math.min(part, 1) : 0;
                _core.setTo(capsule.start.x + part * x, capsule.start.y + part * y, capsule.start.z + part * z);
            }
            else
            {
                var sphere:Sphere = Sphere(structure);
                _core.copyFrom(sphere.center);
            }
        }

        private function goAlong(axis:Vector3D, half:Number, center:Vector3D):void
        {
            var by:Number = axis.x * (_place.x - center.x) + axis.y * (_place.y - center.y) + axis.z * (_place.z - center.z);
            by = Math.max(-half, Math.min(half, by));
            _core.x += by * axis.x;
            _core.y += by * axis.y;
            _core.z += by * axis.z;
        }

        // Measures the gap along the direction.
        private function findGap(structure:BoundingStructure):void
        {
            gap = -Math.max(along.x * high.x, along.x * low.x) - Math.max(along.y * high.y, along.y * low.y) - Math.max(along.z * high.z, along.z * low.z);
            if (structure.kind == BoundingStructure.BOX)
            {
                var box:Box = Box(structure);
                gap += lengthAlong(box.center) - Math.abs(lengthAlong(box.axisX)) * box.halfX - Math.abs(lengthAlong(box.axisY)) * box.halfY
                    - Math.abs(lengthAlong(box.axisZ)) * box.halfZ;
            }
            else if (structure.kind == BoundingStructure.CAPSULE)
            {
                var capsule:Capsule = Capsule(structure);
                gap += Math.min(lengthAlong(capsule.start), lengthAlong(capsule.end)) - capsule.radius;
            }
            else
            {
                var sphere:Sphere = Sphere(structure);
                gap += lengthAlong(sphere.center) - sphere.radius;
            }
        }

        private function lengthAlong(vector:Vector3D):Number
        {
            return along.x * vector.x + along.y * vector.y + along.z * vector.z;
        }
    }
}
