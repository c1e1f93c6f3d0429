package growth
{
    import flash.display.Shape;
    import flash.events.Event;
    import flash.events.EventDispatcher;
    import headless.Host;

    /**
     * Measures rows at n, 2n and 4n, a run in each frame, and prints a line for each row. Dispatches Event.COMPLETE.
     *
     * <p>n is doubled from the row's least until each of RUNS runs takes CALM_MS milliseconds, so that neither the clock's noise nor a machine
     * that still compiles decides. The time is the least of RUNS runs; of two, if both take long. Times below FLOOR_MS and memory below
     * FLOOR_BYTES count as if they were these. The exponent is the slope of the line of least squares through the logarithms.</p>
     *
     * <p>The command fails if a row's exponent of time or memory is above its limit, if a run takes longer than TOO_LONG_MS, or if reading a
     * file needs more than FLOOR_BYTES and BYTES_PER_BYTE for each of its bytes. A row that is too slow is measured up to MOST_ATTEMPTS times,
     * and the least times count.</p>
     */
    public final class GrowthRun extends EventDispatcher
    {
        private static const CALM_MS:Number = 60;
        private static const FLOOR_MS:Number = 8;
        private static const LONG_MS:Number = 1500;
        private static const TOO_LONG_MS:Number = 15000;
        private static const RUNS:int = 3;
        private static const SIZES:int = 3;
        private static const MOST_ATTEMPTS:int = 4;
        private static const FLOOR_BYTES:Number = 67108864;
        private static const BYTES_PER_BYTE:Number = 1000;

        /** The clock, in milliseconds of this process: <code>():Number</code>. Tests have one of their own. */
        public var clock:Function = processorMs;

        /** The names of the rows that failed, and why. */
        public var failures:Array = [];

        private var _rows:Array;
        private var _shape:Shape = new Shape();
        private var _row:GrowthRow;
        private var _n:int;
        private var _size:int;
        private var _runs:int;
        private var _attempt:int;
        private var _best:Number;
        private var _problem:String;
        private var _baseMemory:Number = -1;

        // of n, 2n and 4n: the least time, and the most memory so far
        private var _times:Array;
        private var _memories:Array;
        private var _kept:Object;

        /** @param rows GrowthRows */
        public function GrowthRun(rows:Array)
        {
            _rows = rows.concat();
        }

        /** The two lines above the first row's. */
        public static function get head():String
        {
            return "| row | n | ms at n, 2n, 4n | exponent | MB | exponent | |\n|---|---|---|---|---|---|---|";
        }

        /** Begins. */
        public function start():void
        {
            _shape.addEventListener(Event.ENTER_FRAME, onFrame);
        }

        /**
         * The slope of the line of least squares through the logarithms of three costs at n, 2n and 4n. The middle one has no influence on
         * it.
         *
         * @param least smaller costs count as this
         */
        public static function exponentOf(costs:Array, least:Number):Number
        {
            return Math.log(Math.max(least, costs[2]) / Math.max(least, costs[0])) / Math.log(4);
        }

        private function onFrame(event:Event):void
        {
            if (_row != null)
            {
                measure();
            }
            else if (_rows.length > 0)
            {
                beginRow(_rows.shift());
            }
            else
            {
                _shape.removeEventListener(Event.ENTER_FRAME, onFrame);
                dispatchEvent(new Event(Event.COMPLETE));
            }
        }

        private function beginRow(row:GrowthRow):void
        {
            _row = row;
            _n = row.start;
            _runs = 0;
            _size = 0;
            _attempt = 1;
            _problem = "";
            _times = [];
            _memories = [];
            if (_baseMemory < 0)
            {
                Host.collect();
                _baseMemory = Host.mostMemory;
            }
        }

        private function measure():void
        {
            var action:Function = _row.begin(_n << _size);
            Host.collect();
            var start:Number = clock();
            _kept = action();
            var ms:Number = clock() - start;
            var memory:Number = Host.mostMemory - _baseMemory;
            _best = _runs++ == 0 ? ms : Math.min(_best, ms);
            if (_size == 0 && _attempt == 1 && _best < CALM_MS && 8 * _n <= _row.most)
            {
                _n *= 2;
                _runs = 0;
                return;
            }
            if (_runs < RUNS && (_best <= LONG_MS || _runs == 1))
            {
                return; // a single long run may be the garbage collector's
            }
            if (_best > TOO_LONG_MS)
            {
                _problem = (_best / 1000).toFixed(0) + " s at " + (_n << _size);
                endRow();
            }
            else
            {
                _times[_size] = _attempt == 1 ? _best : Math.min(_best, _times[_size]);
                _memories[_size] = memory;
                _runs = 0;
                if (++_size == SIZES)
                {
                    endAttempt();
                }
            }
        }

        private function endAttempt():void
        {
            // another program of the machine may have taken its time: it can only add
            if (isTooSlow && _attempt < MOST_ATTEMPTS)
            {
                _attempt++;
                _size = 0;
                return;
            }
            check();
            endRow();
        }

        private function get isTooSlow():Boolean
        {
            return exponentOf(_times, FLOOR_MS) > _row.exponent;
        }

        private function check():void
        {
            var most:Number = FLOOR_BYTES + BYTES_PER_BYTE * _row.bytes;
            if (isTooSlow)
            {
                _problem = "too slow";
            }
            else if (exponentOf(_memories, FLOOR_BYTES) > _row.exponent || _row.bytes > 0 && _memories[SIZES - 1] > most)
            {
                _problem = "too much memory";
            }
        }

        private function endRow():void
        {
            var outcome:String = _kept is Error ? Error(_kept).message : "";
            var isMeasured:Boolean = _times.length == SIZES;
            trace("| " + [_row.name, _n + " " + _row.grows, _times.map(inMs).join(", "),
                        isMeasured ? exponentOf(_times, FLOOR_MS).toFixed(2) : "",
                        Host.mostMemory < 0 ? "not measured" : _memories.map(inMegabytes).join(", "),
                        isMeasured && Host.mostMemory >= 0 ? exponentOf(_memories, FLOOR_BYTES).toFixed(2) : "",
                        _problem == "" ? outcome.substr(0, 60) : "FAILS: " + _problem].join(" | ") + " |");
            if (_problem != "")
            {
                failures.push(_row.name + ": " + _problem);
            }
            _row = null;
            _kept = null;
        }

        private static function processorMs():Number
        {
            return Host.processorMs;
        }

        private static function inMs(ms:Number, index:int, all:Array):String
        {
            return ms.toFixed(ms < 10 ? 1 : 0);
        }

        private static function inMegabytes(bytes:Number, index:int, all:Array):String
        {
            return (bytes / 1048576).toFixed(0);
        }
    }
}
