package starlogo.fitting
{
    /** A capsule along some direction, from which MinimalCapsuleFitter goes on. */
    internal final class CapsuleStart
    {
        /** The direction, a unit vector. */
        public var x:Number;

        /** @copy #x */
        public var y:Number;

        /** @copy #x */
        public var z:Number;

        /** Where the segment starts along the direction, seen from the plane through the origin. */
        public var low:Number;

        /** Where it ends. */
        public var high:Number;

        /** The ends, x, y, z of either. */
        public var ends:Vector.<Number>;

        /** The capsule's volume. */
        public var volume:Number;

        /** Filled by MinimalCapsuleFitter. */
        public function CapsuleStart()
        {
        }

        /** Sorts by volume, the smallest first. */
        public static function compare(a:CapsuleStart, b:CapsuleStart):Number
        {
            return a.volume < b.volume ? -1 : (a.volume > b.volume ? 1 : 0);
        }

        /** Whether the two directions, or one and the other's opposite, are less than an angle (radians, small) apart. */
        public function isNear(other:CapsuleStart, angle:Number):Boolean
        {
            var crossX:Number = y * other.z - z * other.y;
            var crossY:Number = z * other.x - x * other.z;
            var crossZ:Number = x * other.y - y * other.x;
            return crossX * crossX + crossY * crossY + crossZ * crossZ < angle * angle;
        }
    }
}
