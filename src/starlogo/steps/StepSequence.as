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
     * <p>Every class of the engine that works in phases has them as parts. An internal class extends this one and adds its parts in the
     * constructor; a class that clients name keeps a sequence in a field, and its <code>step()</code> calls that of the sequence. A loop over many
     * things is <code>slices()</code>, with a constant <code>THINGS_PER_STEP</code> for their number; a loop whose end only the work itself knows
     * is <code>repeat()</code>; work that starts anew adds its parts again.</p>
     */
    public class StepSequence implements Steps
    {
        // what is done with a part: called once, called until it returns false, or called for the work that it returns
        private static const ONCE:int = 0;
        private static const AGAIN:int = 1;
        private static const MAKES_WORK:int = 2;

        // the parts, what is done with each, and the number of the one whose turn it is; no closures: making one costs as much as a small part
        private var _parts:Vector.<Function> = new Vector.<Function>();
        private var _kinds:Vector.<int> = new Vector.<int>();
        private var _next:int = 0;

        // the work that this part has made
        private var _made:Steps = null;

        /** A sequence without parts: one step that does nothing. */
        public function StepSequence()
        {
        }

        /** Adds work to do; returns the sequence. */
        public function add(work:Steps):StepSequence
        {
            return repeat(work.step);
        }

        /** Adds a step; returns the sequence. @param action <code>():void</code> */
        public function call(action:Function):StepSequence
        {
            return addPart(action, ONCE);
        }

        /**
         * Adds work on a row of things, as Slices does it; returns the sequence.
         *
         * @param count how many things there are
         * @param size how many of them a step does
         * @param work <code>(first:int, end:int):void</code>; does the things from one number up to another
         */
        public function slices(count:int, size:int, work:Function):StepSequence
        {
            return add(new Slices(count, size, work));
        }

        /**
         * Adds work that a function makes when its turn has come, in a separate step; returns the sequence.
         *
         * @param make <code>():Steps</code>; the work that it returns is done next; null for none
         */
        public function begin(make:Function):StepSequence
        {
            return addPart(make, MAKES_WORK);
        }

        /**
         * Adds steps that one function does; returns the sequence.
         *
         * @param advance <code>():Boolean</code>, called a step at a time for as long as it returns true
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

        // Does a step of a part; whether there is more of it.
        private function advancePart(part:Function, kind:int):Boolean
        {
            switch (kind)
            {
                case ONCE:
                    part();
                    return false;
                case AGAIN:
                    return part();
                default:
                    _made = _made == null ? part() : (_made.step() ? _made : null);
                    return _made != null;
            }
        }
    }
}
