package starlogo.steps
{
    /**
     * Work that is made of parts, done one after the other. What a part is made of may be left open until its turn comes:
     * parts may also be added while the work is under way, by another part.
     *
     * <listing version="3.0">
     * var loading:StepSequence = new StepSequence().call(parse).begin(newReader).call(store);
     * </listing>
     *
     * <p>Nothing is called before the first step; a part is let go of when it is done.</p>
     *
     * <p>Every class of the engine that works in phases has them as parts. One of the engine's own extends this class and adds its
     * parts in the constructor; one that clients name keeps a sequence, and its <code>step()</code> does that one's. A loop over
     * many things is <code>slices()</code>, with a constant <code>THINGS_PER_STEP</code> for their number; a loop whose end only
     * the work itself knows is <code>repeat()</code>; work that starts anew adds its parts again.</p>
     */
    public class StepSequence implements Steps
    {
        // what each part does in a step, function():Boolean, whether there is more of it; those left are at _next and after
        private var _parts:Vector.<Function> = new Vector.<Function>();
        private var _next:int = 0;

        /** A sequence without parts: one step that does nothing. */
        public function StepSequence()
        {
        }

        /** Adds work to do; returns the sequence. */
        public function add(work:Steps):StepSequence
        {
            return repeat(work.step);
        }

        /** Adds a step; returns the sequence. @param action function():void */
        public function call(action:Function):StepSequence
        {
            return repeat(function():Boolean
                {
                    action();
                    return false;
                });
        }

        /** Adds work on a row of things, as Slices does it; returns the sequence. @copy Slices#Slices() */
        public function slices(count:int, size:int, work:Function):StepSequence
        {
            return add(new Slices(count, size, work));
        }

        /**
         * Adds work that a step of its own makes when its turn has come; returns the sequence.
         *
         * @param make function():Steps; what it returns is done next, null is nothing to do
         */
        public function begin(make:Function):StepSequence
        {
            var work:Steps = null;
            return repeat(function():Boolean
                {
                    if (work == null)
                    {
                        work = make();
                        return work != null;
                    }
                    return work.step();
                });
        }

        /**
         * Adds steps that one function does; returns the sequence.
         *
         * @param advance function():Boolean, called a step at a time for as long as it returns true
         */
        public function repeat(advance:Function):StepSequence
        {
            _parts.push(advance);
            return this;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            if (_next < _parts.length && !_parts[_next]())
            {
                _parts[_next++] = null;
            }
            return _next < _parts.length;
        }
    }
}
