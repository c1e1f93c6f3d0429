package starlogo.steps
{
    /** Work on things that are numbered from 0, some of them in each step. */
    public final class Slices implements Steps
    {
        private var _count:int;
        private var _size:int;
        private var _work:Function;
        private var _next:int = 0;

        /**
         * Work that is not begun.
         *
         * @param count how many things there are
         * @param size how many of them a step does
         * @param work does the things from one number up to another: <code>function(first:int, end:int):void</code>; called once,
         *        with two zeros, if there are none
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
            var first:int = _next;
            _next = Math.min(first + _size, _count);
            _work(first, _next);
            return _next < _count;
        }
    }
}
