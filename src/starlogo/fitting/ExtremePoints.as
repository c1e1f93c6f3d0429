package starlogo.fitting
{
    /** The least and the greatest coordinates of a set of points, and which points have them. */
    internal final class ExtremePoints
    {
        /** The least x; the others alike. */
        public var lowX:Number = Infinity;

        /** @copy #lowX */
        public var lowY:Number = Infinity;

        /** @copy #lowX */
        public var lowZ:Number = Infinity;

        /** The greatest x; the others alike. */
        public var highX:Number = -Infinity;

        /** @copy #highX */
        public var highY:Number = -Infinity;

        /** @copy #highX */
        public var highZ:Number = -Infinity;

        /** The first point whose x is the least; the others alike. */
        public var lowestX:int;

        /** @copy #lowestX */
        public var lowestY:int;

        /** @copy #lowestX */
        public var lowestZ:int;

        /** The first point whose x is the greatest; the others alike. */
        public var highestX:int;

        /** @copy #highestX */
        public var highestY:int;

        /** @copy #highestX */
        public var highestZ:int;

        /**
         * @param points x, y, z each
         */
        public function ExtremePoints(points:Vector.<Number>)
        {
            for (var i:int = 0; i < points.length; i += 3)
            {
                var x:Number = points[i];
                var y:Number = points[i + 1];
                var z:Number = points[i + 2];
                if (x < lowX)
                {
                    lowX = x;
                    lowestX = i / 3;
                }
                if (x > highX)
                {
                    highX = x;
                    highestX = i / 3;
                }
                if (y < lowY)
                {
                    lowY = y;
                    lowestY = i / 3;
                }
                if (y > highY)
                {
                    highY = y;
                    highestY = i / 3;
                }
                if (z < lowZ)
                {
                    lowZ = z;
                    lowestZ = i / 3;
                }
                if (z > highZ)
                {
                    highZ = z;
                    highestZ = i / 3;
                }
            }
        }
    }
}
