package starlogo.intersection.boxes
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.isAfter;

    /**
     * Tests whether two boxes that stand touch: see boxBox.
     *
     * @private
     */
    public final class BoxSeparation
    {
        // The pair of two boxes that are given as structures.
        private static const BOXES:BoxPair = new BoxPair();

        /** Whether two boxes touch: see boxBox. */
        public static function areTouching(a:Box, b:Box):Boolean
        {
            var centerA:Vector3D = a.center;
            var centerB:Vector3D = b.center;
            // For most boxes x alone decides about the order, without a call. Boxes with the same centre touch, so their order does not matter.
            if (centerA.x > centerB.x || centerA.x == centerB.x && isAfter(centerA, centerB))
            {
                var first:Box = b;
                b = a;
                a = first;
                centerA = a.center;
                centerB = b.center;
            }
            var touchingFactor:Number = Tolerances.TOUCHING;
            var toX:Number = (centerB.x - centerA.x) / touchingFactor;
            var toY:Number = (centerB.y - centerA.y) / touchingFactor;
            var toZ:Number = (centerB.z - centerA.z) / touchingFactor;
            // the vector between the centres, in a's axes
            var axis:Vector3D = a.axisX;
            var x:Number = toX * axis.x + toY * axis.y + toZ * axis.z;
            axis = a.axisY;
            var y:Number = toX * axis.x + toY * axis.y + toZ * axis.z;
            axis = a.axisZ;
            var z:Number = toX * axis.x + toY * axis.y + toZ * axis.z;
            var halfX:Number = a.halfX;
            var halfY:Number = a.halfY;
            var halfZ:Number = a.halfZ;
            var bX:Number = b.halfX;
            var bY:Number = b.halfY;
            var bZ:Number = b.halfZ;
            // the squared distance of b's centre from a, to compare with the two spheres of b
            include "../squaredToBox.inc";
            if (squaredDistance > bX * bX + bY * bY + bZ * bZ)
            {
                return false;
            }
            var inner:Number = bX < bY ? bX : bY;
            inner = inner < bZ ? inner : bZ;
            if (squaredDistance <= inner * inner)
            {
                return true;
            }
            var pair:BoxPair = BOXES;
            pair.x = x;
            pair.y = y;
            pair.z = z;
            pair.aX = halfX;
            pair.aY = halfY;
            pair.aZ = halfZ;
            pair.bX = bX;
            pair.bY = bY;
            pair.bZ = bZ;
            pair.axes.setTo(a, b);
            if (!overlapAlongFaces(pair))
            {
                return false;
            }
            if (haveParallelEdges(pair.axes))
            {
                return areUpright(pair.axes) || BoxSweep.areTouching(a, b);
            }
            return overlapAcrossEdges(pair);
        }

        // Whether two boxes overlap along the normals of their faces: first those of a, then those of b.
        private static function overlapAlongFaces(pair:BoxPair):Boolean
        {
            var b:BoxAxes = pair.axes;
            var x:Number = pair.x;
            var y:Number = pair.y;
            var z:Number = pair.z;
            var aX:Number = pair.aX;
            var aY:Number = pair.aY;
            var aZ:Number = pair.aZ;
            var bX:Number = pair.bX;
            var bY:Number = pair.bY;
            var bZ:Number = pair.bZ;
            var radius:Number = aX + bX * b.abs00 + bY * b.abs01 + bZ * b.abs02;
            var overlap:Boolean = x <= radius && x >= -radius;
            radius = aY + bX * b.abs10 + bY * b.abs11 + bZ * b.abs12;
            overlap = overlap && y <= radius && y >= -radius;
            radius = aZ + bX * b.abs20 + bY * b.abs21 + bZ * b.abs22;
            overlap = overlap && z <= radius && z >= -radius;
            var along:Number = x * b.m00 + y * b.m10 + z * b.m20;
            radius = bX + aX * b.abs00 + aY * b.abs10 + aZ * b.abs20;
            overlap = overlap && along <= radius && along >= -radius;
            along = x * b.m01 + y * b.m11 + z * b.m21;
            radius = bY + aX * b.abs01 + aY * b.abs11 + aZ * b.abs21;
            overlap = overlap && along <= radius && along >= -radius;
            along = x * b.m02 + y * b.m12 + z * b.m22;
            radius = bZ + aX * b.abs02 + aY * b.abs12 + aZ * b.abs22;
            return overlap && along <= radius && along >= -radius;
        }

        // Whether edges of two boxes are so nearly parallel that their cross product would cancel.
        private static function haveParallelEdges(b:BoxAxes):Boolean
        {
            var near:Number = 1 - Tolerances.NEARLY_PARALLEL / 2;
            return b.abs22 > near || b.abs21 > near || b.abs20 > near
                || b.abs12 > near || b.abs11 > near || b.abs10 > near
                || b.abs02 > near || b.abs01 > near || b.abs00 > near;
        }

        // Whether the z axes of two boxes are parallel. Then their faces are enough: the cross products of other edges are along z or across it.
        private static function areUpright(b:BoxAxes):Boolean
        {
            return b.m02 * b.m02 + b.m12 * b.m12 <= Tolerances.PARALLEL;
        }

        /**
         * Whether two boxes overlap along the cross products of their edges: those of a in order, each with the three of b. Edges must not be nearly
         * parallel, unless the absolute values of the axes allow for rounding.
         */
        public static function overlapAcrossEdges(pair:BoxPair):Boolean
        {
            var b:BoxAxes = pair.axes;
            var x:Number = pair.x;
            var y:Number = pair.y;
            var z:Number = pair.z;
            var aX:Number = pair.aX;
            var aY:Number = pair.aY;
            var aZ:Number = pair.aZ;
            var bX:Number = pair.bX;
            var bY:Number = pair.bY;
            var bZ:Number = pair.bZ;
            var along:Number = z * b.m10 - y * b.m20;
            var radius:Number = aY * b.abs20 + aZ * b.abs10 + bY * b.abs02 + bZ * b.abs01;
            var overlap:Boolean = along <= radius && along >= -radius;
            along = z * b.m11 - y * b.m21;
            radius = aY * b.abs21 + aZ * b.abs11 + bZ * b.abs00 + bX * b.abs02;
            overlap = overlap && along <= radius && along >= -radius;
            along = z * b.m12 - y * b.m22;
            radius = aY * b.abs22 + aZ * b.abs12 + bX * b.abs01 + bY * b.abs00;
            overlap = overlap && along <= radius && along >= -radius;
            along = x * b.m20 - z * b.m00;
            radius = aZ * b.abs00 + aX * b.abs20 + bY * b.abs12 + bZ * b.abs11;
            overlap = overlap && along <= radius && along >= -radius;
            along = x * b.m21 - z * b.m01;
            radius = aZ * b.abs01 + aX * b.abs21 + bZ * b.abs10 + bX * b.abs12;
            overlap = overlap && along <= radius && along >= -radius;
            along = x * b.m22 - z * b.m02;
            radius = aZ * b.abs02 + aX * b.abs22 + bX * b.abs11 + bY * b.abs10;
            overlap = overlap && along <= radius && along >= -radius;
            along = y * b.m00 - x * b.m10;
            radius = aX * b.abs10 + aY * b.abs00 + bY * b.abs22 + bZ * b.abs21;
            overlap = overlap && along <= radius && along >= -radius;
            along = y * b.m01 - x * b.m11;
            radius = aX * b.abs11 + aY * b.abs01 + bZ * b.abs20 + bX * b.abs22;
            overlap = overlap && along <= radius && along >= -radius;
            along = y * b.m02 - x * b.m12;
            radius = aX * b.abs12 + aY * b.abs02 + bX * b.abs21 + bY * b.abs20;
            return overlap && along <= radius && along >= -radius;
        }
    }
}
