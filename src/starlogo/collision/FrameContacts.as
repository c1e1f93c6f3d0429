package starlogo.collision
{
    import starlogo.data.IntPairMap;
    import starlogo.engine;
    import starlogo.search.FoundPairs;

    use namespace engine;

    /** The contacts of a frame's pairs, for the pairs whose handlers take contacts. */
    internal final class FrameContacts
    {
        // A system of the game's own may leave numbers of a contact as they are.
        private static const UNSET:Contact = new Contact();

        // The contacts that were computed in this frame, and objects for more of them.
        private var _contacts:Vector.<Contact> = new Vector.<Contact>();
        private var _count:int = 0;

        // By pair: the index of its contact.
        private var _indices:IntPairMap = new IntPairMap();

        // The contact passed to handlers, which may change it.
        private var _given:Contact = new Contact();

        /** Begins a frame. */
        public function begin():void
        {
            _count = 0;
            _indices.clear();
        }

        /** Computes the contact of a pair of the frame, and returns its index. @param system computes it @param pairs those of the frame */
        public function compute(pair:int, pairs:FoundPairs, system:BaseCollider):int
        {
            if (_count == _contacts.length)
            {
                _contacts.push(new Contact());
            }
            var contact:Contact = _contacts[_count];
            contact.copyFrom(UNSET);
            contact.copyFrom(system.contactOf(pairs.firstOf(pair), pairs.secondOf(pair), contact) || contact);
            _indices.set (pair, 0, _count);
            return _count++;
        }

        /**
         * Returns the contact of a pair, in an object that the next call overwrites. If a handler has changed a breed, the contact may not be
         * known yet. The collision system then computes it as the frame has seen the two agents.
         *
         * @param isSecondCollider whether the second agent is the collider
         */
        public function contactFor(pair:int, isSecondCollider:Boolean, pairs:FoundPairs, system:BaseCollider):Contact
        {
            var index:int = _indices.find(pair, 0);
            if (index < 0)
            {
                index = compute(pair, pairs, system);
            }
            _given.copyFrom(_contacts[index]);
            if (isSecondCollider)
            {
                _given.normal.negate();
            }
            return _given;
        }
    }
}
