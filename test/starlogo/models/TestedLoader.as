package starlogo.models
{
    import evaluation.pairs.SeededRandom;
    import flash.events.ProgressEvent;
    import flash.net.URLLoader;
    import support.RecordingURLLoader;

    /**
     * A ModelLoader whose clock goes on by some milliseconds whenever it is asked, that counts how it keeps to its budget,
     * and whose files come by hand.
     */
    internal class TestedLoader extends ModelLoader
    {
        private static const LONGEST_TICK:int = 4;

        /** What fetches the files, in the order in which they were asked for; if null, they come by themselves. */
        public var fetches:Vector.<RecordingURLLoader> = new Vector.<RecordingURLLoader>();

        /** How many steps it has done. */
        public var stepCount:int = 0;

        /** How many of them it began when its budget was spent. */
        public var lateStepCount:int = 0;

        /** How many frames it had work in. */
        public var frameCount:int = 0;

        /** In how many of them it stopped before its budget was spent. */
        public var shortFrameCount:int = 0;

        private var _random:SeededRandom = new SeededRandom(5);
        private var _time:int = 0;

        // the times that were told in this frame: its start, and the end of each step
        private var _times:Vector.<int> = new Vector.<int>();

        public function TestedLoader(receiver:ModelReceiver, budget:Number)
        {
            super(receiver, budget);
            addEventListener(ProgressEvent.PROGRESS, onFrameEnd);
        }

        override internal function now():int
        {
            _time += _random.integer(0, LONGEST_TICK);
            _times.push(_time);
            return _time;
        }

        override internal function newURLLoader():URLLoader
        {
            if (fetches == null)
            {
                return super.newURLLoader();
            }
            var fetch:RecordingURLLoader = new RecordingURLLoader();
            fetches.push(fetch);
            return fetch;
        }

        private function onFrameEnd(event:ProgressEvent):void
        {
            var steps:int = _times.length - 1;
            for (var i:int = 1; i < steps; i++)
            {
                lateStepCount += _times[i] - _times[0] >= budget ? 1 : 0;
            }
            if (steps > 0)
            {
                stepCount += steps;
                frameCount++;
                shortFrameCount += _times[steps] - _times[0] < budget ? 1 : 0;
            }
            _times.length = 0;
        }
    }
}
