package starlogo.collision
{
    import starlogo.data.HashTable;
    import starlogo.engine;
    import starlogo.search.FoundPairs;

    use namespace engine;

    /** The contacts of a frame's pairs, for the pairs whose handlers take contacts. */
    internal final class FrameContacts
    {
        // The contacts that were computed in this frame, and objects for more of them.
        private var _contacts:Vector.<Contact> = new Vector.<Contact>();
        private var _count:int = 0;

        // By pair: the index of its contact.
        private var _indices:HashTable = new HashTable();

        // The contact passed to handlers, which may change it.
        private var _given:Contact = new Contact();

        /** Begins a frame. */
        public function begin():void
        {
            _count = 0;
            _indices.clear();
        }

        /** Computes the contact of a pair of the frame. @param system computes it @param pairs those of the frame */
        public function find(pair:int, pairs:FoundPairs, system:BaseCollider):void
        {
            if (_count == _contacts.length)
            {
                _contacts.push(new Contact());
            }
            system.contactOf(pairs.firstOf(pair), pairs.secondOf(pair), _contacts[_count]);
            _indices.set (pair, 0, _count);
            _count++;
        }

        /**
         * Returns the contact of a pair, in an object that the next call overwrites. If a handler has changed a breed, the contact may not be
         * known yet. The collision system then computes it as the frame has seen the two agents.
         *
         * @param isSecondCollider whether the second agent is the collider
         */
        public function contactFor(pair:int, isSecondCollider:Boolean, pairs:FoundPairs, system:BaseCollider):Contact
        {
            if (_indices.find(pair, 0) < 0)
            {
                find(pair, pairs, system);
            }
            _given.copyFrom(_contacts[_indices.find(pair, 0)]);
            if (isSecondCollider)
            {
                _given.normal.negate();
            }
            return _given;
        }
    }
}
