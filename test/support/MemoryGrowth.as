package support
{
    import headless.Host;
    import org.flexunit.asserts.assertTrue;

    /**
     * How much the player's memory grows by what is done. The player collects nothing while a test runs, so that whatever is allocated
     * counts once the room that there was is full.
     */
    public final class MemoryGrowth
    {
        private static var sKept:Array = [];

        /**
         * Does something many times.
         *
         * @param times how often
         * @param warmUp how often before, uncounted
         * @param action <code>function(i:int):void</code>
         * @return bytes
         */
        public static function during(times:int, warmUp:int, action:Function):Number
        {
            for (var i:int = 0; i < warmUp; i++)
            {
                action(i);
            }
            if (!Garbage.isCounted)
            {
                takeAllRoom();
            }
            var before:Number = Host.memory;
            assertTrue("the runner tells the memory", before > 0);
            for (i = 0; i < times; i++)
            {
                action(i);
            }
            var grown:Number = Host.memory - before;
            sKept = [];
            return grown;
        }

        /**
         * As <code>during</code>, done again while memory has grown, three times at most: where nothing is allocated, it may grow by a page now
         * and then, but not each time.
         */
        public static function lasting(times:int, warmUp:int, action:Function):Number
        {
            var grown:Number = during(times, warmUp, action);
            for (var again:int = 0; again < 3 && grown > 0; again++)
            {
                grown = Math.min(grown, during(times, 0, action));
            }
            return grown;
        }

        /** Makes small objects and forgets all but the last: what the measure must see. */
        public static function makeObjects(count:int):void
        {
            for (var i:int = 0; i < count; i++)
            {
                sKept[0] = new SmallObject();
            }
        }

        // Until the player has to ask for more.
        private static function takeAllRoom():void
        {
            sKept = [];
            var before:Number = Host.memory;
            while (Host.memory == before)
            {
                for (var i:int = 0; i < 1000; i++)
                {
                    sKept.push(new SmallObject());
                }
            }
        }
    }
}

final class SmallObject
{
    public var x:Number;
}
