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
     * <p>Most methods that return work have names like reading() or cutting(). A method that does some of it has a name like readSome() or
     * cut().</p>
     *
     * <p>Nothing is called before the first step. A part is released when it is done. If a part is added when no step was left, there are
     * steps again.</p>
     *
     * <p>Use it in every class of the engine that works in phases. An internal class extends this one and adds its parts in the
     * constructor. A class that clients name keeps a sequence in a field, and its <code>step()</code> calls the sequence's. Use
     * <code>slices()</code> for a loop over many things, with a constant <code>THINGS_PER_STEP</code> for the size. Use
     * <code>repeat()</code> for a loop whose end only the work itself knows. To do the work again, add its parts again.</p>
     */
    public class StepSequence implements Steps
    {
        // how a part is done: one call, calls until it returns false, one call that returns the work to do, or such calls until one
        // returns null
        private static const ONCE:int = 0;
        private static const AGAIN:int = 1;
        private static const MAKES_WORK:int = 2;
        private static const MAKES_EACH:int = 3;

        // The parts, how each is done, and the index of the present part. Only slices() wraps its part in a closure, because creating one
        // costs as much as a small part.
        private var _parts:Vector.<Function> = new Vector.<Function>();
        private var _kinds:Vector.<int> = new Vector.<int>();
        private var _next:int = 0;

        // the work that the present part returned
        private var _made:Steps = null;

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
            return addPart(action, ONCE);
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
                    var first:int = next;
                    next = Math.min(first + size, count);
                    work(first, next);
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
            return addPart(make, MAKES_WORK);
        }

        /**
         * Adds pieces of work that a function creates, each when the one before is done. Returns the sequence.
         *
         * @param make <code>():Steps</code>; null ends the part
         */
        public function beginEach(make:Function):StepSequence
        {
            return addPart(make, MAKES_EACH);
        }

        /**
         * Adds the steps of one function. Returns the sequence.
         *
         * @param advance <code>():Boolean</code>; each call is a step; it is called until it returns false
         */
        public function repeat(advance:Function):StepSequence
        {
            return addPart(advance, AGAIN);
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            if (_next < _parts.length && !advancePart(_parts[_next], _kinds[_next]))
            {
                _parts[_next++] = null;
            }
            return _next < _parts.length;
        }

        private function addPart(part:Function, kind:int):StepSequence
        {
            _parts.push(part);
            _kinds.push(kind);
            return this;
        }

        // Does a step of a part. Returns whether the part has more steps.
        private function advancePart(part:Function, kind:int):Boolean
        {
            switch (kind)
            {
                case ONCE:
                    part();
                    return false;
                case AGAIN:
                    return part();
                case MAKES_EACH:
                    _made = _made != null && _made.step() ? _made : part();
                    return _made != null;
                default:
                    _made = _made == null ? part() : (_made.step() ? _made : null);
                    return _made != null;
            }
        }
    }
}
