package starlogo.collision
{
    import starlogo.data.HashTable;
    import starlogo.engine;
    import starlogo.search.FoundPairs;

    use namespace engine;

    /** The contacts of a frame's pairs, for the pairs whose handlers take contacts. */
    internal final class FrameContacts
    {
        // The system and the pairs of the frame; null between frames.
        private var _system:BaseCollider = null;
        private var _pairs:FoundPairs = null;

        // The contacts that were computed in this frame, and objects for more of them.
        private var _contacts:Vector.<Contact> = new Vector.<Contact>();
        private var _count:int = 0;

        // By pair: the index of its contact.
        private var _indices:HashTable = new HashTable();

        // The contact passed to handlers, which may change it.
        private var _given:Contact = new Contact();

        /** Begins a frame. @param system computes its contacts @param pairs its pairs */
        public function begin(system:BaseCollider, pairs:FoundPairs):void
        {
            _system = system;
            _pairs = pairs;
            _count = 0;
            _indices.clear();
        }

        /** Ends a frame, also one that has not begun. */
        public function end():void
        {
            _system = null;
            _pairs = null;
        }

        /** Computes the contact of a pair of the frame. */
        public function find(pair:int):void
        {
            if (_count == _contacts.length)
            {
                _contacts.push(new Contact());
            }
            _system.contactOf(_pairs.firstOf(pair), _pairs.secondOf(pair), _contacts[_count]);
            _indices.set (pair, 0, _count);
            _count++;
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
            if (_indices.find(pair, 0) < 0)
            {
                find(pair);
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
