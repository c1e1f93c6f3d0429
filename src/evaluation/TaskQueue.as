package evaluation
{
    import flash.utils.getTimer;

    /**
     * Works through the tasks in steps. Then those whose times were noisy are measured once more, because the machine may be quieter now. This
     * ends after 45 seconds.
     */
    public final class TaskQueue
    {
        private static const REPEATS_MS:int = 45000;

        private var _tasks:Vector.<Task>;
        private var _next:int = 0;
        private var _progress:Progress;
        private var _areRepeats:Boolean = false;
        private var _end:int = int.MAX_VALUE;

        /** @param tasks at least one */
        public function TaskQueue(tasks:Vector.<Task>)
        {
            _tasks = tasks;
            _progress = new Progress(tasks);
        }

        /** The task whose step is next. */
        public function get current():Task
        {
            return _tasks[_next];
        }

        /** Does a step. Returns whether it was the last one. */
        public function work():Boolean
        {
            _progress.report(_next);
            if (!current.work())
            {
                return false;
            }
            if (_next + 1 < _tasks.length && getTimer() < _end)
            {
                _next++;
                return false;
            }
            _progress.finish();
            var noisy:Vector.<Task> = _areRepeats ? new Vector.<Task>() : noisyTasks();
            if (noisy.length == 0)
            {
                return true;
            }
            trace("noisy, and measured once more:");
            _tasks = noisy;
            _next = 0;
            _progress = new Progress(noisy);
            _areRepeats = true;
            _end = getTimer() + REPEATS_MS;
            return false;
        }

        private function noisyTasks():Vector.<Task>
        {
            var noisy:Vector.<Task> = new Vector.<Task>();
            for each (var task:Task in _tasks)
            {
                var measuring:MeasuringTask = task as MeasuringTask;
                if (measuring != null && measuring.isNoisy)
                {
                    measuring.repeatNoisy();
                    noisy.push(task);
                }
            }
            return noisy;
        }
    }
}
