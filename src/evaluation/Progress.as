package evaluation
{
    import flash.utils.getTimer;

    /** Prints the progress of the tasks every few seconds: a bar, the running task, and the remaining time. */
    public final class Progress
    {
        private static const INTERVAL_MS:int = 5000;
        private static const BAR:int = 20;

        private var _tasks:Vector.<Task>;
        private var _total:Number = 0;
        private var _start:int = getTimer();
        private var _last:int = int.MIN_VALUE;

        /** @param tasks all tasks */
        public function Progress(tasks:Vector.<Task>)
        {
            _tasks = tasks;
            for each (var task:Task in tasks)
            {
                _total += task.weight;
            }
        }

        /** Prints the progress, if the last print was long enough ago. */
        public function report(current:int):void
        {
            var now:int = getTimer();
            if (_last == int.MIN_VALUE || now - _last >= INTERVAL_MS)
            {
                _last = now;
                trace(line(current, now - _start));
            }
        }

        /** Prints that all is done. */
        public function finish():void
        {
            trace(bar(1) + "  " + _tasks.length + (_tasks.length == 1 ? " measurement in " : " measurements in ") + seconds(getTimer() - _start));
        }

        private function line(current:int, elapsed:Number):String
        {
            var done:Number = 0;
            for (var i:int = 0; i < current; i++)
            {
                done += _tasks[i].weight;
            }
            var part:Number = done / _total;
            var text:String = bar(part) + "  " + _tasks[current].title;
            return part < 0.03 ? text : text + "; " + seconds(elapsed / part - elapsed) + " left";
        }

        private static function bar(part:Number):String
        {
            var text:String = "[";
            for (var i:int = 0; i < BAR; i++)
            {
                text += i < Math.round(part * BAR) ? "#" : ".";
            }
            return text + "] " + ("  " + Math.round(part * 100)).slice(-3) + " %";
        }

        private static function seconds(ms:Number):String
        {
            return Math.ceil(ms / 1000) + " s";
        }
    }
}
