package soak
{
    /** The memory in the course of a soak: samples at equal distances, the first of them of a program that is not warm yet. */
    public final class SoakMemory
    {
        private static const WARM_UP:Number = 0.25;

        private var _samples:Array = [];

        /** @param bytes in use, or the size of the player's memory */
        public function add(bytes:Number):void
        {
            _samples.push(bytes);
        }

        /** The samples after the warm-up. */
        public function get warm():Array
        {
            return _samples.slice(Math.floor(WARM_UP * _samples.length));
        }

        /** The median of the first or the last tenth after the warm-up, in bytes. */
        public function at(isEnd:Boolean):Number
        {
            var all:Array = warm;
            var count:int = Math.ceil(all.length / 10);
            var some:Array = isEnd ? all.slice(-count) : all.slice(0, count);
            some.sort(Array.NUMERIC);
            return some[some.length >> 1];
        }

        /** How many bytes it grows after the warm-up, by the line of least squares. */
        public function get growth():Number
        {
            var all:Array = warm;
            var middle:Number = (all.length - 1) / 2;
            var products:Number = 0;
            var squares:Number = 0;
            for (var i:int = 0; i < all.length; i++)
            {
                products += (i - middle) * all[i];
                squares += (i - middle) * (i - middle);
            }
            return squares > 0 ? products / squares * (all.length - 1) : 0;
        }
    }
}
