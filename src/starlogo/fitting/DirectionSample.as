package starlogo.fitting
{
    /** A direction, and the volume of the smallest box with an axis along it. */
    internal final class DirectionSample
    {
        /** Of the direction, a unit vector. */
        public var x:Number;

        /** @copy #x */
        public var y:Number;

        /** @copy #x */
        public var z:Number;

        /** The box's volume. */
        public var volume:Number;

        /**
         * @param x of the direction
         * @param y of the direction
         * @param z of the direction
         * @param volume of the box
         */
        public function DirectionSample(x:Number, y:Number, z:Number, volume:Number)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.volume = volume;
        }

        /** Sorts by volume, the smallest first. */
        public static function compare(a:DirectionSample, b:DirectionSample):Number
        {
            return a.volume < b.volume ? -1 : (a.volume > b.volume ? 1 : 0);
        }

        /** Whether the two directions, or one and the other's opposite, are less than an angle (radians, small) apart. */
        public function isNear(other:DirectionSample, angle:Number):Boolean
        {
            var crossX:Number = y * other.z - z * other.y;
            var crossY:Number = z * other.x - x * other.z;
            var crossZ:Number = x * other.y - y * other.x;
            return crossX * crossX + crossY * crossY + crossZ * crossZ < angle * angle;
        }
    }
}
