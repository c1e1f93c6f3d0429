package starlogo.fitting
{
    /** The least and the greatest coordinates of a set of points, and which points have them: three of each, along x, y and z. */
    internal final class ExtremePoints
    {
        /** The least coordinates. */
        public var low:Vector.<Number> = new Vector.<Number>(3, true);

        /** The greatest coordinates. */
        public var high:Vector.<Number> = new Vector.<Number>(3, true);

        /** The first point that has the least. */
        public var lowest:Vector.<int> = new Vector.<int>(3, true);

        /** The first point that has the greatest. */
        public var highest:Vector.<int> = new Vector.<int>(3, true);

        /**
         * @param points x, y, z each
         */
        public function ExtremePoints(points:Vector.<Number>)
        {
            for (var axis:int = 0; axis < 3; axis++)
            {
                var least:Number = Infinity;
                var most:Number = -Infinity;
                for (var i:int = axis; i < points.length; i += 3)
                {
                    var coordinate:Number = points[i];
                    if (coordinate < least)
                    {
                        least = coordinate;
                        lowest[axis] = i / 3;
                    }
                    if (coordinate > most)
                    {
                        most = coordinate;
                        highest[axis] = i / 3;
                    }
                }
                low[axis] = least;
                high[axis] = most;
            }
        }

        /** The middle between the least and the greatest along an axis. */
        public function middle(axis:int):Number
        {
            return (low[axis] + high[axis]) / 2;
        }

        /** The axis along which the points are farthest apart; the first of equal ones. */
        public function get widest():int
        {
            var result:int = high[1] - low[1] > high[0] - low[0] ? 1 : 0;
            return high[2] - low[2] > high[result] - low[result] ? 2 : result;
        }
    }
}
