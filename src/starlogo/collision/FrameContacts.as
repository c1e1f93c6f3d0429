package starlogo.collision
{
    import starlogo.data.IntSet;
    import starlogo.engine;
    import starlogo.search.FoundPairs;

    use namespace engine;

    /** The contacts of a frame's pairs, for the pairs whose handlers take contacts. */
    internal final class FrameContacts
    {
        private var _system:BaseCollider = null;
        private var _pairs:FoundPairs = null;

        // By pair: the contact.
        private var _contacts:Vector.<Contact> = new Vector.<Contact>();

        // The pairs whose contacts were computed in this frame.
        private var _found:IntSet = new IntSet();

        // The contact passed to handlers, which may change it.
        private var _given:Contact = new Contact();

        /** Begins a frame. @param system computes its contacts @param pairs its pairs */
        public function setTo(system:BaseCollider, pairs:FoundPairs):void
        {
            _system = system;
            _pairs = pairs;
            _found.clear(pairs.count);
        }

        /** Computes the contact of a pair of the frame. */
        public function find(pair:int):void
        {
            while (_contacts.length <= pair)
            {
                _contacts.push(new Contact());
            }
            _system.contactOf(_pairs.firstOf(pair), _pairs.secondOf(pair), _contacts[pair]);
            _found.add(pair);
        }

        /**
         * Returns the contact of a pair, in an object that the next call overwrites. If a handler has changed a breed, the contact may not be
         * known yet. The collision system then computes it as the frame has seen the two agents.
         *
         * @param pair the index of a pair of the frame
         * @param isSecondCollider whether the second agent is the collider
         */
        public function contactFor(pair:int, isSecondCollider:Boolean):Contact
        {
            if (!_found.has(pair))
            {
                find(pair);
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
