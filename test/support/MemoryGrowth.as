package support
{
    import headless.Host;
    import org.flexunit.asserts.assertTrue;

    /**
     * How much the player's memory grows by what is done. The player collects nothing while a test runs, so that whatever is allocated
     * counts. Memory grows by pages: what fits into the last one is told by how many small objects fit in beside it.
     */
    public final class MemoryGrowth
    {
        private static var sLast:SmallObject;

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
            var full:Number = Host.memory;
            assertTrue("the runner tells the memory", full > 0);
            var room:int;
            if (!Garbage.isCounted)
            {
                fillRoom();
                full = Host.memory;
                room = fillRoom();
            }
            var before:Number = Host.memory;
            for (i = 0; i < times; i++)
            {
                action(i);
            }
            var grown:Number = Host.memory - before;
            return Garbage.isCounted ? grown : grown + (before - full) * (1 - fillRoom() / room);
        }

        /** Makes small objects and forgets all but the last: what the measure must see. */
        public static function makeObjects(count:int):void
        {
            for (var i:int = 0; i < count; i++)
            {
                sLast = new SmallObject();
            }
        }

        // Until the player has to ask for more: how many objects that takes.
        private static function fillRoom():int
        {
            var before:Number = Host.memory;
            var count:int = 0;
            while (Host.memory == before)
            {
                makeObjects(1);
                count++;
            }
            return count;
        }
    }
}

final class SmallObject
{
    public var x:Number;
}
