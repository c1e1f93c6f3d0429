package starlogo.intersection.boxes
{
    /**
     * The separating axes of two boxes that stand: see boxBox.
     *
     * @private
     */
    public final class BoxSeparation
    {
        /** Whether two boxes overlap along the normals of a's faces. The axes have length 1. */
        public static function overlapAlongFacesOfA(pair:BoxPair):Boolean
        {
            var b:BoxAxes = pair.axes;
            var bX:Number = pair.bX;
            var bY:Number = pair.bY;
            var bZ:Number = pair.bZ;
            var radius:Number = pair.aX + bX * b.abs00 + bY * b.abs01 + bZ * b.abs02;
            var overlap:Boolean = pair.x <= radius && pair.x >= -radius;
            radius = pair.aY + bX * b.abs10 + bY * b.abs11 + bZ * b.abs12;
            overlap = overlap && pair.y <= radius && pair.y >= -radius;
            radius = pair.aZ + bX * b.abs20 + bY * b.abs21 + bZ * b.abs22;
            return overlap && pair.z <= radius && pair.z >= -radius;
        }

        /** Whether two boxes overlap along the normals of b's faces. */
        public static function overlapAlongFacesOfB(pair:BoxPair):Boolean
        {
            var b:BoxAxes = pair.axes;
            var x:Number = pair.x;
            var y:Number = pair.y;
            var z:Number = pair.z;
            var aX:Number = pair.aX;
            var aY:Number = pair.aY;
            var aZ:Number = pair.aZ;
            var along:Number = x * b.m00 + y * b.m10 + z * b.m20;
            var radius:Number = b.length * pair.bX + aX * b.abs00 + aY * b.abs10 + aZ * b.abs20;
            var overlap:Boolean = along <= radius && along >= -radius;
            along = x * b.m01 + y * b.m11 + z * b.m21;
            radius = b.length * pair.bY + aX * b.abs01 + aY * b.abs11 + aZ * b.abs21;
            overlap = overlap && along <= radius && along >= -radius;
            along = x * b.m02 + y * b.m12 + z * b.m22;
            radius = b.length * pair.bZ + aX * b.abs02 + aY * b.abs12 + aZ * b.abs22;
            return overlap && along <= radius && along >= -radius;
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
