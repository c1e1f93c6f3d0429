package soak
{
    import flash.display.Shape;
    import flash.events.Event;
    import flash.events.EventDispatcher;
    import headless.Host;

    /**
     * A soak: a game of some thousand frames, a few of them in each frame of the player's, which collects garbage in between. Dispatches
     * Event.COMPLETE when it has ended, well or not.
     */
    public final class SoakRun extends EventDispatcher
    {
        private static const SEED:uint = 15;
        private static const FRAMES_AT_ONCE:int = 4;
        private static const SAMPLES:int = 200;
        private static const REPORTS:int = 10;

        // below this a quarter of the frames leaves the memory that of a program that begins
        private static const FEWEST_FRAMES_FOR_MEMORY:int = 20000;

        // what the memory may grow by after the warm-up, in bytes: less than one agent in ten that are removed takes
        private static const MOST_GROWTH:Number = 2097152;

        private var _frames:int;
        private var _game:SoakGame;
        private var _memory:SoakMemory = new SoakMemory();
        private var _shape:Shape;
        private var _frame:int = 0;
        private var _problem:String = "";

        /**
         * @param frames how many
         * @param checkEvery how many frames from one check to the next, a multiple of four
         * @throws ArgumentError if these don't go together
         */
        public function SoakRun(frames:int, checkEvery:int)
        {
            if (!(frames >= checkEvery && checkEvery > 0 && checkEvery % FRAMES_AT_ONCE == 0))
            {
                throw new ArgumentError("a check every " + checkEvery + " of " + frames + " frames: expected a multiple of " + FRAMES_AT_ONCE);
            }
            _frames = frames;
            _game = new SoakGame(SEED, checkEvery);
        }

        /** What was wrong; "" if nothing was. */
        public function get problem():String
        {
            return _problem;
        }

        /** A hash of all that the game has seen so far: the same on every machine. */
        public function get hash():String
        {
            return _game.hash;
        }

        /** What has happened so far. */
        public function get counts():SoakCounts
        {
            return _game.counts;
        }

        /** Begins. */
        public function start():void
        {
            awaitFrame();
        }

        // A new listener is the last in its frame. So each loader does one step between two turns of the game, in every player. Players differ
        // in when they call a listener that comes again, as the loaders' does when one of them gets work.
        private function awaitFrame():void
        {
            _shape = new Shape();
            _shape.addEventListener(Event.ENTER_FRAME, onFrame);
        }

        private function onFrame(event:Event):void
        {
            _shape.removeEventListener(Event.ENTER_FRAME, onFrame);
            try
            {
                for (var i:int = 0; i < FRAMES_AT_ONCE && _frame < _frames; i++)
                {
                    playFrame();
                }
            }
            catch (error:Error)
            {
                _problem = error.message;
            }
            if (_problem != "" || _frame == _frames)
            {
                end();
            }
            else
            {
                awaitFrame();
            }
        }

        private function playFrame():void
        {
            _game.play();
            _frame++;
            if (_frame % Math.ceil(_frames / SAMPLES) == 0)
            {
                Host.collect();
                _memory.add(Host.memory);
            }
            if (_frame % Math.ceil(_frames / REPORTS) == 0)
            {
                trace("  frame " + _frame + ": " + megabytes(Host.memory) + " MB, hash " + hash);
            }
        }

        private function end():void
        {
            trace(_game.counts + "\n" + describeMemory() + "\n  hash of all that the game has seen: " + hash);
            if (_problem == "" && _game.counts.missing.length > 0)
            {
                _problem = "never happened: " + _game.counts.missing.join(", ");
            }
            if (_problem == "" && _frames >= FEWEST_FRAMES_FOR_MEMORY && _memory.growth > MOST_GROWTH)
            {
                _problem = "the memory grows";
            }
            dispatchEvent(new Event(Event.COMPLETE));
        }

        private function describeMemory():String
        {
            return "  memory after a quarter of the frames " + megabytes(_memory.at(false)) + " MB, at the end " +
                megabytes(_memory.at(true)) + " MB; slope " + (_memory.growth / (0.75 * _frames)).toFixed(1) + " bytes a frame";
        }

        private static function megabytes(bytes:Number):String
        {
            return (bytes / 1048576).toFixed(2);
        }
    }
}
