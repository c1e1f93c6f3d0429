package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /**
     * The cores of two shapes, where they are, and what a search has to find out about them.
     *
     * <p>The first shape is the one that comes first by its place, not the one that was asked about first. So rounding does not depend on the order
     * of the arguments.</p>
     */
    internal final class CorePair
    {
        /** The two shapes. */
        public var first:ConvexShape = null;
        public var second:ConvexShape = null;

        /** Whether the second shape is the one that was asked about first. */
        public var isSwapped:Boolean = false;

        /** The vector from the second shape's origin to the first one's. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The motion of the first shape. Of two displacements that are equally short, the one against it is taken. */
        public var motionX:Number = 0;
        public var motionY:Number = 0;
        public var motionZ:Number = 0;

        /** The distance of the cores up to which the shapes touch. */
        public var touchingDistance:Number = 0;

        /** A search for the distance may end when it knows that the cores are farther apart than this. */
        public var maxDistance:Number = Infinity;

        /**
         * The time that is left for the motion. A search may end when it knows that the shapes do not touch in this time. Infinity if the search is
         * for the distance.
         */
        public var timeLeft:Number = Infinity;

        // The vector from the second shape's origin to the first one's at time 0.
        private var _startX:Number = 0;
        private var _startY:Number = 0;
        private var _startZ:Number = 0;

        /** Sets two shapes, where they are stored. The distance at which they touch includes no margin of a motion. */
        public function setShapes(asked:ConvexShape, other:ConvexShape):void
        {
            isSwapped = isAfter(asked, other);
            var a:ConvexShape = isSwapped ? other : asked;
            var b:ConvexShape = isSwapped ? asked : other;
            // Writing an object to a field costs Adobe's VM more than comparing it first.
            if (first !== a)
            {
                first = a;
            }
            if (second !== b)
            {
                second = b;
            }
            x = a.x - b.x;
            y = a.y - b.y;
            z = a.z - b.z;
            maxDistance = timeLeft = Infinity;
            touchingDistance = (a.radius + b.radius) * Tolerances.TOUCHING + (a.margin + b.margin) + Tolerances.CORES * (a.extent + b.extent);
        }

        /** Sets the motion of the shape that was asked about first, and moves the first one to where it is at the motion's time. */
        public function setMotion(motion:RelativeMotion):void
        {
            // If the shapes are swapped, the first one moves in the opposite direction as seen from the second.
            var side:int = isSwapped ? -1 : 1;
            _startX = x + side * motion.startX;
            _startY = y + side * motion.startY;
            _startZ = z + side * motion.startZ;
            motionX = side * motion.x;
            motionY = side * motion.y;
            motionZ = side * motion.z;
            moveTo(motion);
        }

        /** Moves the first shape to where it is at the motion's time. */
        public function moveTo(motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            x = _startX + time * motionX;
            y = _startY + time * motionY;
            z = _startZ + time * motionZ;
        }

        // Whether a shape comes after another one: by their places, or at the same place by the numbers that they are made of.
        private static function isAfter(a:ConvexShape, b:ConvexShape):Boolean
        {
            if (a.x != b.x)
            {
                return a.x > b.x;
            }
            if (a.y != b.y)
            {
                return a.y > b.y;
            }
            if (a.z != b.z)
            {
                return a.z > b.z;
            }
            if (a.radius != b.radius || a.end != b.end)
            {
                return a.radius > b.radius || a.radius == b.radius && a.end > b.end;
            }
            for (var i:int = 0; i < a.end; i++)
            {
                if (a.points[i] != b.points[i])
                {
                    return a.points[i] > b.points[i];
                }
            }
            return false;
        }
    }
}
