package starlogo.models.animation
{
    import starlogo.geometry.AffineTransform;

    /**
     * How much each point of a skin follows which joints, in a file of any format. A point follows each of its influences: a joint, by a weight. The
     * lists have the influences of all points, one point after the other. The readers of formats fill them.
     *
     * @private
     */
    public final class JointInfluences
    {
        /** The first influence of each point, and one entry more: the number of influences. */
        public var offsets:Vector.<int> = new <int>[0];

        /** The index of each influence's joint. */
        public var joints:Vector.<int> = new Vector.<int>();

        /** The weight of each influence. */
        public var weights:Vector.<Number> = new Vector.<Number>();

        /**
         * Moves some of the points to where their joints put them. The weights of a point are divided by their sum. A point without weights follows the
         * first joint.
         *
         * @param points x, y, z of each point
         * @param jointMatrices what each joint does to points
         * @param first the index of the first point
         * @param end the index after the last one
         * @return whether all new coordinates are finite
         */
        public function skinPoints(points:Vector.<Number>, jointMatrices:Vector.<AffineTransform>, first:int, end:int):Boolean
        {
            var moved:Vector.<Number> = new Vector.<Number>(3);
            var differences:Number = 0;
            for (var i:int = first; i < end; i++)
            {
                var at:int = 3 * i;
                var sum:Number = 0;
                var x:Number = 0;
                var y:Number = 0;
                var z:Number = 0;
                for (var k:int = offsets[i]; k < offsets[int(i + 1)]; k++)
                {
                    var weight:Number = weights[k];
                    jointMatrices[joints[k]].transformPoints(points, i, i + 1, moved, 0);
                    sum += weight;
                    x += weight * moved[0];
                    y += weight * moved[1];
                    z += weight * moved[2];
                }
                if (sum == 0)
                {
                    jointMatrices[0].transformPoints(points, i, i + 1, points, i);
                }
                else
                {
                    points[at] = x / sum;
                    points[int(at + 1)] = y / sum;
                    points[int(at + 2)] = z / sum;
                }
                var all:Number = points[at] + points[int(at + 1)] + points[int(at + 2)];
                differences += all - all; // 0, but NaN if the sum is not finite, and then differences stays NaN
            }
            return differences == 0;
        }
    }
}
