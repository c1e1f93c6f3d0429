package starlogo.convex
{
    import starlogo.geometry.compareVectors;
    import starlogo.geometry.Tolerances;

    /**
     * The cores of two shapes, where they are, and what a search has to find out about them. First and second are the shapes a and b of a question in
     * the order of their places. So rounding does not depend on the order of the arguments: in the other order they get the same answer, to the last
     * bit. There are two exceptions. Of two equal shapes in one place, the first argument moves upwards. The point of a contact on a motion is rounded.
     */
    internal final class CorePair
    {
        /** The two shapes. */
        public var first:ConvexShape = null;
        public var second:ConvexShape = null;

        /** Whether the first shape is b. */
        public var isSwapped:Boolean = false;

        /** The vector from the second shape's origin to the first one's. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The motion of the first shape. Of two displacements that are equally short, the one against it is taken. */
        public var motionX:Number = 0;
        public var motionY:Number = 0;
        public var motionZ:Number = 0;

        /** A search may end when it knows that the cores are farther apart than this: where they touch, or a distance to beat. Infinity if there is none. */
        public var searchLimit:Number = Infinity;

        /** How much of the motion is left. Cores that come near enough in this time are not too far apart. */
        public var timeLeft:Number = 0;

        /** Sets two shapes, which stand where they are stored. No distance is too far. */
        public function setShapes(a:ConvexShape, b:ConvexShape):void
        {
            isSwapped = isAfter(a, b);
            first = isSwapped ? b : a;
            second = isSwapped ? a : b;
            x = first.origin.x - second.origin.x;
            y = first.origin.y - second.origin.y;
            z = first.origin.z - second.origin.z;
            motionX = motionY = motionZ = 0;
            timeLeft = 0;
            searchLimit = Infinity;
        }

        /** Sets how far apart the cores may be to as far as the shapes touch. The margin of a motion is not included. */
        public function limitToTouching():void
        {
            searchLimit = (first.radius + second.radius) * Tolerances.TOUCHING + (first.margin + second.margin)
                + Tolerances.CORES * (first.boundingRadius + second.boundingRadius);
        }

        /** Sets the motion of a, and moves the first shape to where it is at the motion's time. */
        public function setMotion(motion:RelativeMotion):void
        {
            // If the shapes are swapped, the first one moves in the opposite direction as seen from the second.
            var sign:int = isSwapped ? -1 : 1;
            motionX = sign * motion.x;
            motionY = sign * motion.y;
            motionZ = sign * motion.z;
            moveTo(motion);
        }

        /** Moves the first shape to where it is at the motion's time. */
        public function moveTo(motion:RelativeMotion):void
        {
            var sign:int = isSwapped ? -1 : 1;
            var time:Number = motion.time;
            x = first.origin.x - second.origin.x + sign * motion.startX + time * motionX;
            y = first.origin.y - second.origin.y + sign * motion.startY + time * motionY;
            z = first.origin.z - second.origin.z + sign * motion.startZ + time * motionZ;
            timeLeft = motion.latestTime - time;
        }

        // Whether a shape comes after another one: by their places, or at the same place by the numbers that they are made of.
        private static function isAfter(shape:ConvexShape, other:ConvexShape):Boolean
        {
            var order:Number = compareVectors(shape.origin, other.origin) || shape.radius - other.radius || shape.pointsEnd - other.pointsEnd;
            for (var i:int = 0; order == 0 && i < shape.pointsEnd; i++)
            {
                order = shape.points[i] - other.points[i];
            }
            return order > 0;
        }
    }
}
