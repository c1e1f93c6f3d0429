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
            var absolutes:Vector.<Number> = pair.absolutes;
            var halvesB:Vector.<Number> = pair.halvesB;
            for (var i:int = 0; i < 3; i++)
            {
                var projection:Number = pair.offset[i];
                var radius:Number = pair.halvesA[i] + halvesB[0] * absolutes[int(3 * i)] + halvesB[1] * absolutes[int(3 * i + 1)] + halvesB[2] * absolutes[int(3 * i + 2)];
                if (!(projection <= radius && projection >= -radius))
                {
                    return false;
                }
            }
            return true;
        }

        /** Whether two boxes overlap along the normals of b's faces. */
        public static function overlapAlongFacesOfB(pair:BoxPair):Boolean
        {
            var rotation:Vector.<Number> = pair.rotation;
            var absolutes:Vector.<Number> = pair.absolutes;
            var offset:Vector.<Number> = pair.offset;
            var halvesA:Vector.<Number> = pair.halvesA;
            for (var i:int = 0; i < 3; i++)
            {
                var projection:Number = offset[0] * rotation[i] + offset[1] * rotation[int(i + 3)] + offset[2] * rotation[int(i + 6)];
                var radius:Number = pair.halvesB[i] + halvesA[0] * absolutes[i] + halvesA[1] * absolutes[int(i + 3)] + halvesA[2] * absolutes[int(i + 6)];
                if (!(projection <= radius && projection >= -radius))
                {
                    return false;
                }
            }
            return true;
        }

        /**
         * Whether two boxes overlap along the cross products of their edges: those of a in order, each with the three of b (the sums are those of
         * Ericson, "Real-Time Collision Detection", table 4.1). Edges must not be nearly parallel, unless the absolute values of the rotation allow for
         * rounding.
         */
        public static function overlapAcrossEdges(pair:BoxPair):Boolean
        {
            var rotation:Vector.<Number> = pair.rotation;
            var absolutes:Vector.<Number> = pair.absolutes;
            for (var i:int = 0; i < 3; i++)
            {
                // the other two edges of a, and all rows of the rotation
                var j:int = i == 2 ? 0 : i + 1;
                var k:int = 3 - i - j;
                var row:int = 3 * i;
                var halfJ:Number = pair.halvesA[j];
                var halfK:Number = pair.halvesA[k];
                var offsetJ:Number = pair.offset[j];
                var offsetK:Number = pair.offset[k];
                for (var p:int = 0; p < 3; p++)
                {
                    var q:int = p == 2 ? 0 : p + 1;
                    var r:int = 3 - p - q;
                    var jp:int = 3 * j + p;
                    var kp:int = 3 * k + p;
                    var projection:Number = offsetK * rotation[jp] - offsetJ * rotation[kp];
                    var radius:Number = halfJ * absolutes[kp] + halfK * absolutes[jp] + pair.halvesB[q] * absolutes[int(row + r)] + pair.halvesB[r] * absolutes[int(row + q)];
                    if (!(projection <= radius && projection >= -radius))
                    {
                        return false;
                    }
                }
            }
            return true;
        }
    }
}
