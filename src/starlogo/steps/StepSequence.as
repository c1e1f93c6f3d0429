package starlogo.steps
{
    /**
     * Work made of parts that are done one after the other. A part may decide what the next parts are, because parts can be added while the
     * work is running.
     *
     * <listing version="3.0">
     * var loading:StepSequence = new StepSequence().call(parse).begin(newReader).call(store);
     * </listing>
     *
     * <p>A part is one call (<code>call()</code>), other work (<code>add()</code>), work that is created when its turn comes
     * (<code>begin()</code>), or a loop: over many small things (<code>slices()</code>), over things that take several steps each
     * (<code>beginEach()</code>), or as long as a function wants (<code>repeat()</code>). In a class of the engine, the size of slices is
     * a constant <code>THINGS_PER_STEP</code>.</p>
     *
     * <p>Most methods that return work have names like reading() or cutting(). A method that does some of it has a name like readSome() or
     * cut().</p>
     *
     * <p>Nothing is called before the first step. A part is released when it is done. If a part is added when no step was left, there are
     * steps again. If a step throws, its part is not over.</p>
     *
     * <p>Use it in every class of the engine that works in phases. An internal class extends this one and adds its parts in the
     * constructor. A class that clients name keeps a sequence in a field, and its <code>step()</code> calls the sequence's. To do the work
     * again, add its parts again.</p>
     */
    public class StepSequence implements Steps
    {
        // Each part is a function whose calls are steps, until it returns false. The present one is _parts[_next].
        private var _parts:Vector.<Function> = new Vector.<Function>();
        private var _next:int = 0;

        /** Creates a sequence without parts. It has one step, which does nothing. */
        public function StepSequence()
        {
        }

        /** Adds work. Returns the sequence. */
        public function add(work:Steps):StepSequence
        {
            return repeat(work.step);
        }

        /** Adds a step. Returns the sequence. @param action <code>():void</code> */
        public function call(action:Function):StepSequence
        {
            return repeat(function():Boolean
                {
                    action();
                    return false;
                });
        }

        /**
         * Adds work on things that are numbered from 0. Each step does some of them. Returns the sequence.
         *
         * @param count the number of things
         * @param size the number of things in each step
         * @param work <code>(first:int, end:int):void</code>; does the things from one number up to another. If there are none, it is called
         * once with two zeros
         */
        public function slices(count:int, size:int, work:Function):StepSequence
        {
            var next:int = 0;
            return repeat(function():Boolean
                {
                    var end:int = Math.min(next + size, count);
                    work(next, end);
                    next = end;
                    return next < count;
                });
        }

        /**
         * Adds work that a function creates when its turn comes. Calling the function is a step of its own. Returns the sequence.
         *
         * @param make <code>():Steps</code>; the work that it returns is done next; null for none
         */
        public function begin(make:Function):StepSequence
        {
            return beginEach(1, function(index:int):Steps
                {
                    return make();
                });
        }

        /**
         * Adds work on things that are numbered from 0, each of which may take several steps. A function creates the work on one thing when the
         * work on the one before is done. Returns the sequence.
         *
         * @param count the number of things
         * @param make <code>(index:int):Steps</code>; the work on one of them; null if nothing of it is left
         * @param size the number of things that one step may do, if they have no work of their own
         */
        public function beginEach(count:int, make:Function, size:int = 1):StepSequence
        {
            var next:int = 0;
            var made:Steps = null;
            return repeat(function():Boolean
                {
                    var end:int = Math.min(next + size, count);
                    made = made != null && made.step() ? made : null;
                    while (made == null && next < end)
                    {
                        made = make(next);
                        next++;
                    }
                    return made != null || next < count;
                });
        }

        /**
         * Adds the steps of one function. Returns the sequence.
         *
         * @param advance <code>():Boolean</code>; each call is a step; it is called until it returns false
         */
        public function repeat(advance:Function):StepSequence
        {
            _parts.push(advance);
            return this;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            if (_next < _parts.length)
            {
                var advance:Function = _parts[_next];
                if (!advance())
                {
                    _parts[_next++] = null;
                }
            }
            return _next < _parts.length;
        }
    }
}
