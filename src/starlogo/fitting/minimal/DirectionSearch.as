package starlogo.fitting.minimal
{
    /**
     * Searches all directions for the smallest structure. It measures many directions, and descends from the best of them. The subclass
     * measures and descends.
     *
     * @private
     */
    public class DirectionSearch
    {
        private static const STARTS:int = 6;

        /** For subclasses only. */
        public function DirectionSearch()
        {
        }

        /**
         * Measures directions, and descends from the best ones.
         *
         * @param directions unit vectors, x, y, z of each; opposite ones count as one
         * @param apart the smallest angle between two directions to descend from: radians, small
         */
        public function search(directions:Vector.<Number>, apart:Number):void
        {
            var volumes:Array = [];
            var i:int;
            for (i = 0; i < directions.length; i += 3)
            {
                volumes.push(measure(directions[i], directions[i + 1], directions[i + 2]));
            }
            var order:Array = volumes.sort(Array.NUMERIC | Array.RETURNINDEXEDARRAY);
            var starts:Vector.<Number> = new Vector.<Number>();
            for (i = 0; i < order.length && starts.length < 3 * STARTS; i++)
            {
                var at:int = 3 * order[i];
                if (!isNear(starts, directions[at], directions[at + 1], directions[at + 2], apart))
                {
                    starts.push(directions[at], directions[at + 1], directions[at + 2]);
                    descendFrom(directions[at], directions[at + 1], directions[at + 2]);
                }
            }
        }

        /** The volume of the smallest structure along a direction. If this volume is far from the best one, the result may be larger. */
        protected function measure(x:Number, y:Number, z:Number):Number
        {
            return Infinity;
        }

        /** Changes the structure along a direction until no small change makes it smaller. Keeps the smallest of all structures. */
        protected function descendFrom(x:Number, y:Number, z:Number):void
        {
        }

        private static function isNear(others:Vector.<Number>, x:Number, y:Number, z:Number, angle:Number):Boolean
        {
            for (var i:int = 0; i < others.length; i += 3)
            {
                var crossX:Number = y * others[i + 2] - z * others[i + 1];
                var crossY:Number = z * others[i] - x * others[i + 2];
                var crossZ:Number = x * others[i + 1] - y * others[i];
                if (crossX * crossX + crossY * crossY + crossZ * crossZ < angle * angle)
                {
                    return true;
                }
            }
            return false;
        }
    }
}
