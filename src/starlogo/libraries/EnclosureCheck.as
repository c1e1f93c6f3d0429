package starlogo.libraries
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Tolerances;
    import starlogo.steps.Steps;

    /** Looks in steps whether structures contain all vertices of a model, as precisely as a fit has to: Tolerances.CONTAINMENT. */
    internal final class EnclosureCheck implements Steps
    {
        private static const VERTICES_A_STEP:int = 1500;

        private var _structures:Vector.<BoundingStructure>;
        private var _vertices:Vector.<Number>;
        private var _next:int = 0;
        private var _holds:Boolean = true;

        /**
         * @param structures spheres, capsules and boxes; null among them is left out
         * @param vertices x, y, z each
         */
        public function EnclosureCheck(structures:Vector.<BoundingStructure>, vertices:Vector.<Number>)
        {
            _structures = structures;
            _vertices = vertices;
        }

        /** Whether they do, when no step is left. */
        public function get holds():Boolean
        {
            return _holds;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            var end:int = Math.min(_next + 3 * VERTICES_A_STEP, _vertices.length);
            for each (var structure:BoundingStructure in _structures)
            {
                _holds &&= structure == null || encloses(structure, _next, end);
            }
            _next = end;
            return _holds && end < _vertices.length;
        }

        private function encloses(structure:BoundingStructure, first:int, end:int):Boolean
        {
            switch (structure.kind)
            {
                case BoundingStructure.SPHERE:
                    var sphere:Sphere = Sphere(structure);
                    return isRoundEnough(sphere.center, sphere.center, sphere.radius, first, end);
                case BoundingStructure.CAPSULE:
                    var capsule:Capsule = Capsule(structure);
                    return isRoundEnough(capsule.start, capsule.end, capsule.radius, first, end);
                default:
                    return isWideEnough(Box(structure), first, end);
            }
        }

        private function isRoundEnough(start:Vector3D, tip:Vector3D, radius:Number, first:int, end:int):Boolean
        {
            var vertices:Vector.<Number> = _vertices;
            var fromX:Number = start.x;
            var fromY:Number = start.y;
            var fromZ:Number = start.z;
            var axisX:Number = tip.x - fromX;
            var axisY:Number = tip.y - fromY;
            var axisZ:Number = tip.z - fromZ;
            var squared:Number = axisX * axisX + axisY * axisY + axisZ * axisZ;
            var reach:Number = radius + Tolerances.CONTAINMENT * (radius + Math.sqrt(squared) / 2);
            reach *= reach;
            var i:int = first;
            while (i < end)
            {
                var x:Number = vertices[i++] - fromX;
                var y:Number = vertices[i++] - fromY;
                var z:Number = vertices[i++] - fromZ;
                if (squared > 0)
                {
                    var along:Number = (x * axisX + y * axisY + z * axisZ) / squared;
                    if (along > 0)
                    {
                        if (along > 1)
                        {
                            along = 1;
                        }
                        x -= along * axisX;
                        y -= along * axisY;
                        z -= along * axisZ;
                    }
                }
                // NaN is not within reach either
                if (!(x * x + y * y + z * z <= reach))
                {
                    return false;
                }
            }
            return true;
        }

        private function isWideEnough(box:Box, first:int, end:int):Boolean
        {
            var vertices:Vector.<Number> = _vertices;
            var centerX:Number = box.center.x;
            var centerY:Number = box.center.y;
            var centerZ:Number = box.center.z;
            var xx:Number = box.axisX.x;
            var xy:Number = box.axisX.y;
            var xz:Number = box.axisX.z;
            var yx:Number = box.axisY.x;
            var yy:Number = box.axisY.y;
            var yz:Number = box.axisY.z;
            var zx:Number = box.axisZ.x;
            var zy:Number = box.axisZ.y;
            var zz:Number = box.axisZ.z;
            var slack:Number = Tolerances.CONTAINMENT * Math.max(box.halfX, box.halfY, box.halfZ);
            var halfX:Number = box.halfX + slack;
            var halfY:Number = box.halfY + slack;
            var halfZ:Number = box.halfZ + slack;
            var i:int = first;
            while (i < end)
            {
                var x:Number = vertices[i++] - centerX;
                var y:Number = vertices[i++] - centerY;
                var z:Number = vertices[i++] - centerZ;
                var onX:Number = x * xx + y * xy + z * xz;
                var onY:Number = x * yx + y * yy + z * yz;
                var onZ:Number = x * zx + y * zy + z * zz;
                if (!(onX <= halfX && onX >= -halfX && onY <= halfY && onY >= -halfY && onZ <= halfZ && onZ >= -halfZ))
                {
                    return false;
                }
            }
            return true;
        }
    }
}
