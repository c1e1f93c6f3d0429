package starlogo.collision
{
    import starlogo.engine;
    import starlogo.search.FoundPairs;

    use namespace engine;

    /** The contacts of a frame's pairs, for the pairs whose handlers take contacts. */
    internal final class FrameContacts
    {
        private var _system:BaseCollider = null;

        // By pair: the contact.
        private var _contacts:Vector.<Contact> = new Vector.<Contact>();

        // By pair: the frame in which the contact was computed.
        private var _frames:Vector.<int> = new Vector.<int>();

        // The number of the present frame.
        private var _frame:int = 0;

        // The contact passed to handlers, which may change it.
        private var _given:Contact = new Contact();

        /** Begins a frame. @param system computes its contacts */
        public function begin(system:BaseCollider):void
        {
            _system = system;
            _frame++;
        }

        /** Computes the contact of a pair of the frame. */
        public function find(pairs:FoundPairs, pair:int):void
        {
            while (_contacts.length <= pair)
            {
                _contacts.push(new Contact());
                _frames.push(0);
            }
            _system.contactOf(pairs.firstOf(pair), pairs.secondOf(pair), _contacts[pair]);
            _frames[pair] = _frame;
        }

        /**
         * Returns the contact of a pair, in an object that the next call overwrites. If a handler has changed a breed, the contact may not be
         * known yet. The collision system then computes it as the frame has seen the two agents.
         *
         * @param pairs the pairs of the frame
         * @param pair the index of one of them
         * @param isSecondCollider whether the second agent is the collider
         */
        public function contactFor(pairs:FoundPairs, pair:int, isSecondCollider:Boolean):Contact
        {
            if (pair >= _frames.length || _frames[pair] != _frame)
            {
                find(pairs, pair);
            }
            _given.copyFrom(_contacts[pair]);
            if (isSecondCollider)
            {
                _given.normal.negate();
            }
            return _given;
        }
    }
}
