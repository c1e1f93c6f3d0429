package starlogo.collision
{
    import starlogo.agents.Agent;

    /** The contacts of a frame's pairs, for the pairs whose handlers take contacts. */
    internal final class FrameContacts
    {
        private static const SIZE:int = 9;

        private var _system:BaseCollider = null;

        // Indexed by the pairs' numbers. There may be more entries than pairs. Each contact is SIZE numbers.
        private var _areKnown:Vector.<Boolean> = new Vector.<Boolean>();
        private var _numbers:Vector.<Number> = new Vector.<Number>();

        // The contact passed to handlers.
        private var _given:Contact = new Contact();

        /** Begins a frame with pairs that the collision system has found. */
        public function begin(system:BaseCollider, pairCount:int):void
        {
            _system = system;
            for (var i:int = 0; i < pairCount; i++)
            {
                _areKnown[i] = false;
            }
        }

        /** Ends the frame. */
        public function end():void
        {
            _system = null;
        }

        /** Computes the contact of a pair. */
        public function find(pair:int, first:Agent, second:Agent):void
        {
            var at:int = SIZE * pair;
            if (_numbers.length < at + SIZE)
            {
                // grows by an eighth, because a vector that grows by one element is copied each time
                _numbers.length = at + (at >> 3) + SIZE;
            }
            var found:Contact = _system.contactOf(first, second, _given);
            _numbers[at] = found.time;
            _numbers[int(at + 1)] = found.depth;
            _numbers[int(at + 2)] = found.approachSpeed;
            _numbers[int(at + 3)] = found.point.x;
            _numbers[int(at + 4)] = found.point.y;
            _numbers[int(at + 5)] = found.point.z;
            _numbers[int(at + 6)] = found.normal.x;
            _numbers[int(at + 7)] = found.normal.y;
            _numbers[int(at + 8)] = found.normal.z;
            _areKnown[pair] = true;
        }

        /**
         * Returns the contact of a pair, in an object that the next call overwrites. If a handler has changed a breed, the contact may not be
         * known yet. The collision system then computes it as the frame has seen the two agents.
         *
         * @param pair the number of the pair, from 0
         * @param first the first agent of the pair
         * @param second the second agent
         * @param isBack whether the second agent is the collider
         */
        public function contactFor(pair:int, first:Agent, second:Agent, isBack:Boolean):Contact
        {
            if (!_areKnown[pair])
            {
                find(pair, first, second);
            }
            var at:int = SIZE * pair;
            var sign:Number = isBack ? -1 : 1;
            _given.time = _numbers[at];
            _given.depth = _numbers[int(at + 1)];
            _given.approachSpeed = _numbers[int(at + 2)];
            _given.point.setTo(_numbers[int(at + 3)], _numbers[int(at + 4)], _numbers[int(at + 5)]);
            _given.normal.setTo(sign * _numbers[int(at + 6)], sign * _numbers[int(at + 7)], sign * _numbers[int(at + 8)]);
            return _given;
        }
    }
}
