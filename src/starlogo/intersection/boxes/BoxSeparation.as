package starlogo.intersection.boxes
{
    /**
     * The separating axes of two boxes that stand: see boxBox.
     *
     * @private
     */
    public final class BoxSeparation
    {
        /** Whether two boxes overlap along the normals of a's faces. */
        public static function overlapAlongFacesOfA(pair:BoxPair):Boolean
        {
            var axes:BoxAxes = pair.axes;
            var bHalfX:Number = pair.bHalfX;
            var bHalfY:Number = pair.bHalfY;
            var bHalfZ:Number = pair.bHalfZ;
            var radius:Number = pair.aHalfX + bHalfX * axes.abs00 + bHalfY * axes.abs01 + bHalfZ * axes.abs02;
            var isOverlapping:Boolean = pair.offsetX <= radius && pair.offsetX >= -radius;
            radius = pair.aHalfY + bHalfX * axes.abs10 + bHalfY * axes.abs11 + bHalfZ * axes.abs12;
            isOverlapping = isOverlapping && pair.offsetY <= radius && pair.offsetY >= -radius;
            radius = pair.aHalfZ + bHalfX * axes.abs20 + bHalfY * axes.abs21 + bHalfZ * axes.abs22;
            return isOverlapping && pair.offsetZ <= radius && pair.offsetZ >= -radius;
        }

        /** Whether two boxes overlap along the normals of b's faces. */
        public static function overlapAlongFacesOfB(pair:BoxPair):Boolean
        {
            var axes:BoxAxes = pair.axes;
            var x:Number = pair.offsetX;
            var y:Number = pair.offsetY;
            var z:Number = pair.offsetZ;
            var aHalfX:Number = pair.aHalfX;
            var aHalfY:Number = pair.aHalfY;
            var aHalfZ:Number = pair.aHalfZ;
            var projection:Number = x * axes.m00 + y * axes.m10 + z * axes.m20;
            var radius:Number = pair.bHalfX + aHalfX * axes.abs00 + aHalfY * axes.abs10 + aHalfZ * axes.abs20;
            var isOverlapping:Boolean = projection <= radius && projection >= -radius;
            projection = x * axes.m01 + y * axes.m11 + z * axes.m21;
            radius = pair.bHalfY + aHalfX * axes.abs01 + aHalfY * axes.abs11 + aHalfZ * axes.abs21;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = x * axes.m02 + y * axes.m12 + z * axes.m22;
            radius = pair.bHalfZ + aHalfX * axes.abs02 + aHalfY * axes.abs12 + aHalfZ * axes.abs22;
            return isOverlapping && projection <= radius && projection >= -radius;
        }

        /**
         * Whether two boxes overlap along the cross products of their edges: those of a in order, each with the three of b (the sums are those of
         * Ericson, "Real-Time Collision Detection", table 4.1). Edges must not be nearly parallel, unless the absolute values of the axes allow for
         * rounding.
         */
        public static function overlapAcrossEdges(pair:BoxPair):Boolean
        {
            var axes:BoxAxes = pair.axes;
            var x:Number = pair.offsetX;
            var y:Number = pair.offsetY;
            var z:Number = pair.offsetZ;
            var aHalfX:Number = pair.aHalfX;
            var aHalfY:Number = pair.aHalfY;
            var aHalfZ:Number = pair.aHalfZ;
            var bHalfX:Number = pair.bHalfX;
            var bHalfY:Number = pair.bHalfY;
            var bHalfZ:Number = pair.bHalfZ;
            var projection:Number = z * axes.m10 - y * axes.m20;
            var radius:Number = aHalfY * axes.abs20 + aHalfZ * axes.abs10 + bHalfY * axes.abs02 + bHalfZ * axes.abs01;
            var isOverlapping:Boolean = projection <= radius && projection >= -radius;
            projection = z * axes.m11 - y * axes.m21;
            radius = aHalfY * axes.abs21 + aHalfZ * axes.abs11 + bHalfZ * axes.abs00 + bHalfX * axes.abs02;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = z * axes.m12 - y * axes.m22;
            radius = aHalfY * axes.abs22 + aHalfZ * axes.abs12 + bHalfX * axes.abs01 + bHalfY * axes.abs00;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = x * axes.m20 - z * axes.m00;
            radius = aHalfZ * axes.abs00 + aHalfX * axes.abs20 + bHalfY * axes.abs12 + bHalfZ * axes.abs11;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = x * axes.m21 - z * axes.m01;
            radius = aHalfZ * axes.abs01 + aHalfX * axes.abs21 + bHalfZ * axes.abs10 + bHalfX * axes.abs12;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = x * axes.m22 - z * axes.m02;
            radius = aHalfZ * axes.abs02 + aHalfX * axes.abs22 + bHalfX * axes.abs11 + bHalfY * axes.abs10;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = y * axes.m00 - x * axes.m10;
            radius = aHalfX * axes.abs10 + aHalfY * axes.abs00 + bHalfY * axes.abs22 + bHalfZ * axes.abs21;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = y * axes.m01 - x * axes.m11;
            radius = aHalfX * axes.abs11 + aHalfY * axes.abs01 + bHalfZ * axes.abs20 + bHalfX * axes.abs22;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = y * axes.m02 - x * axes.m12;
            radius = aHalfX * axes.abs12 + aHalfY * axes.abs02 + bHalfX * axes.abs21 + bHalfY * axes.abs20;
            return isOverlapping && projection <= radius && projection >= -radius;
        }
    }
}
