package starlogo.steps
{
    /** Work on things that are numbered from 0. Each step does some of them. */
    public final class Slices implements Steps
    {
        private var _count:int;
        private var _size:int;
        private var _work:Function;
        private var _next:int = 0;
        private var _isDone:Boolean = false;

        /**
         * Creates the work. None of its steps is done yet.
         *
         * @param count the number of things
         * @param size the number of things in each step
         * @param work does the things from one number up to another: <code>function(first:int, end:int):void</code>. If there are none, it
         * is called once with two zeros
         */
        public function Slices(count:int, size:int, work:Function)
        {
            _count = count;
            _size = size;
            _work = work;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            if (!_isDone)
            {
                var first:int = _next;
                _next = Math.min(first + _size, _count);
                _work(first, _next);
                _isDone = _next >= _count;
            }
            return !_isDone;
        }
    }
}
