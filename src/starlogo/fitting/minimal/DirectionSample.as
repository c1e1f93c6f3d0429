package starlogo.fitting.minimal
{
    /**
     * A direction that a search may go on from, and the volume of what was found along it.
     *
     * @private
     */
    public final class DirectionSample
    {
        /** The direction, a unit vector. */
        public var x:Number;

        /** @copy #x */
        public var y:Number;

        /** @copy #x */
        public var z:Number;

        /** The volume of the structure that was found. */
        public var volume:Number;

        /** The ends of a capsule that was found, x, y, z of each. */
        public var ends:Vector.<Number> = null;

        /**
         * @param x of the direction
         * @param y of the direction
         * @param z of the direction
         * @param volume of the structure that was found
         */
        public function DirectionSample(x:Number, y:Number, z:Number, volume:Number = Infinity)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.volume = volume;
        }

        /**
         * The samples of the smallest volumes, none of them close to a better one.
         *
         * @param samples of many directions; sorted here
         * @param count how many at most
         * @param apart how far two directions have to be from each other, opposite ones being the same; radians, small
         */
        public static function best(samples:Vector.<DirectionSample>, count:int, apart:Number):Vector.<DirectionSample>
        {
            samples.sort(compare);
            var chosen:Vector.<DirectionSample> = new Vector.<DirectionSample>();
            for (var i:int = 0; i < samples.length && chosen.length < count; i++)
            {
                var isNew:Boolean = true;
                for (var k:int = 0; k < chosen.length && isNew; k++)
                {
                    isNew = !samples[i].isNear(chosen[k], apart);
                }
                if (isNew)
                {
                    chosen.push(samples[i]);
                }
            }
            return chosen;
        }

        private static function compare(a:DirectionSample, b:DirectionSample):Number
        {
            return a.volume < b.volume ? -1 : (a.volume > b.volume ? 1 : 0);
        }

        private function isNear(other:DirectionSample, angle:Number):Boolean
        {
            var crossX:Number = y * other.z - z * other.y;
            var crossY:Number = z * other.x - x * other.z;
            var crossZ:Number = x * other.y - y * other.x;
            return crossX * crossX + crossY * crossY + crossZ * crossZ < angle * angle;
        }
    }
}
