package starlogo.intersection.boxes
{
    import starlogo.geometry.Placement;

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
            var bHalfX:Number = pair.bHalfX;
            var bHalfY:Number = pair.bHalfY;
            var bHalfZ:Number = pair.bHalfZ;
            var radius:Number = pair.aHalfX + bHalfX * pair.abs00 + bHalfY * pair.abs01 + bHalfZ * pair.abs02;
            var isOverlapping:Boolean = pair.offsetX <= radius && pair.offsetX >= -radius;
            radius = pair.aHalfY + bHalfX * pair.abs10 + bHalfY * pair.abs11 + bHalfZ * pair.abs12;
            isOverlapping = isOverlapping && pair.offsetY <= radius && pair.offsetY >= -radius;
            radius = pair.aHalfZ + bHalfX * pair.abs20 + bHalfY * pair.abs21 + bHalfZ * pair.abs22;
            return isOverlapping && pair.offsetZ <= radius && pair.offsetZ >= -radius;
        }

        /** Whether two boxes overlap along the normals of b's faces. */
        public static function overlapAlongFacesOfB(pair:BoxPair):Boolean
        {
            var rotation:Placement = pair.rotation;
            var x:Number = pair.offsetX;
            var y:Number = pair.offsetY;
            var z:Number = pair.offsetZ;
            var aHalfX:Number = pair.aHalfX;
            var aHalfY:Number = pair.aHalfY;
            var aHalfZ:Number = pair.aHalfZ;
            var projection:Number = x * rotation.r00 + y * rotation.r10 + z * rotation.r20;
            var radius:Number = pair.bHalfX + aHalfX * pair.abs00 + aHalfY * pair.abs10 + aHalfZ * pair.abs20;
            var isOverlapping:Boolean = projection <= radius && projection >= -radius;
            projection = x * rotation.r01 + y * rotation.r11 + z * rotation.r21;
            radius = pair.bHalfY + aHalfX * pair.abs01 + aHalfY * pair.abs11 + aHalfZ * pair.abs21;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = x * rotation.r02 + y * rotation.r12 + z * rotation.r22;
            radius = pair.bHalfZ + aHalfX * pair.abs02 + aHalfY * pair.abs12 + aHalfZ * pair.abs22;
            return isOverlapping && projection <= radius && projection >= -radius;
        }

        /**
         * Whether two boxes overlap along the cross products of their edges: those of a in order, each with the three of b (the sums are those of
         * Ericson, "Real-Time Collision Detection", table 4.1). Edges must not be nearly parallel, unless the absolute values of the rotation allow for
         * rounding.
         */
        public static function overlapAcrossEdges(pair:BoxPair):Boolean
        {
            var rotation:Placement = pair.rotation;
            var x:Number = pair.offsetX;
            var y:Number = pair.offsetY;
            var z:Number = pair.offsetZ;
            var aHalfX:Number = pair.aHalfX;
            var aHalfY:Number = pair.aHalfY;
            var aHalfZ:Number = pair.aHalfZ;
            var bHalfX:Number = pair.bHalfX;
            var bHalfY:Number = pair.bHalfY;
            var bHalfZ:Number = pair.bHalfZ;
            var projection:Number = z * rotation.r10 - y * rotation.r20;
            var radius:Number = aHalfY * pair.abs20 + aHalfZ * pair.abs10 + bHalfY * pair.abs02 + bHalfZ * pair.abs01;
            var isOverlapping:Boolean = projection <= radius && projection >= -radius;
            projection = z * rotation.r11 - y * rotation.r21;
            radius = aHalfY * pair.abs21 + aHalfZ * pair.abs11 + bHalfZ * pair.abs00 + bHalfX * pair.abs02;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = z * rotation.r12 - y * rotation.r22;
            radius = aHalfY * pair.abs22 + aHalfZ * pair.abs12 + bHalfX * pair.abs01 + bHalfY * pair.abs00;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = x * rotation.r20 - z * rotation.r00;
            radius = aHalfZ * pair.abs00 + aHalfX * pair.abs20 + bHalfY * pair.abs12 + bHalfZ * pair.abs11;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = x * rotation.r21 - z * rotation.r01;
            radius = aHalfZ * pair.abs01 + aHalfX * pair.abs21 + bHalfZ * pair.abs10 + bHalfX * pair.abs12;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = x * rotation.r22 - z * rotation.r02;
            radius = aHalfZ * pair.abs02 + aHalfX * pair.abs22 + bHalfX * pair.abs11 + bHalfY * pair.abs10;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = y * rotation.r00 - x * rotation.r10;
            radius = aHalfX * pair.abs10 + aHalfY * pair.abs00 + bHalfY * pair.abs22 + bHalfZ * pair.abs21;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = y * rotation.r01 - x * rotation.r11;
            radius = aHalfX * pair.abs11 + aHalfY * pair.abs01 + bHalfZ * pair.abs20 + bHalfX * pair.abs22;
            isOverlapping = isOverlapping && projection <= radius && projection >= -radius;
            projection = y * rotation.r02 - x * rotation.r12;
            radius = aHalfX * pair.abs12 + aHalfY * pair.abs02 + bHalfX * pair.abs21 + bHalfY * pair.abs20;
            return isOverlapping && projection <= radius && projection >= -radius;
        }
    }
}
