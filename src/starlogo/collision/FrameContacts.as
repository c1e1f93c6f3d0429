package starlogo.collision
{
    import starlogo.agents.AgentRecord;
    import starlogo.engine;

    use namespace engine;

    /**
     * The contacts of a frame's pairs, for those whose handlers ask for them. They are found before the first handler runs: it may
     * move the agents of other pairs.
     */
    internal final class FrameContacts
    {
        private static const NUMBERS:int = 8;

        private var _system:CollisionSystem = null;
        private var _numbers:Vector.<Number> = new Vector.<Number>();
        private var _contact:Contact = new Contact();

        /** No contacts yet. */
        public function FrameContacts()
        {
        }

        /** Begins a frame with pairs whose contacts are not known. */
        public function begin(system:CollisionSystem, pairCount:int):void
        {
            _system = system;
            _numbers.length = NUMBERS * pairCount;
            for (var at:int = 0; at < _numbers.length; at += NUMBERS)
            {
                _numbers[at] = NaN;
            }
        }

        /** Lets go of the collision system. */
        public function end():void
        {
            _system = null;
        }

        /** Finds the contact of a pair. */
        public function find(pair:int, first:AgentRecord, second:AgentRecord):void
        {
            var contact:Contact = _contact;
            var collider:Collider = _system as Collider;
            var system:ContactSystem = _system as ContactSystem;
            if (collider != null && first is WorldShape)
            {
                collider.findContactOf(first, second, contact);
            }
            else if (system != null)
            {
                system.contactOf(first.agent, second.agent, contact);
            }
            else
            {
                contact.placeBetween(first.agent, second.agent);
            }
            var at:int = NUMBERS * pair;
            _numbers[at] = contact.time;
            _numbers[int(at + 1)] = contact.point.x;
            _numbers[int(at + 2)] = contact.point.y;
            _numbers[int(at + 3)] = contact.point.z;
            _numbers[int(at + 4)] = contact.normal.x;
            _numbers[int(at + 5)] = contact.normal.y;
            _numbers[int(at + 6)] = contact.normal.z;
            _numbers[int(at + 7)] = contact.depth;
        }

        /**
         * The contact of a pair, in an object that the next call overwrites.
         *
         * @param pair its number
         * @param first for whom the contact was found as the collider
         * @param second the other
         * @param isBack whether the second is the collider
         */
        public function contactOf(pair:int, first:AgentRecord, second:AgentRecord, isBack:Boolean):Contact
        {
            var at:int = NUMBERS * pair;
            if (_numbers.length <= at || isNaN(_numbers[at]))
            {
                // its breeds have changed since the frame began
                if (_numbers.length <= at)
                {
                    _numbers.length = at + NUMBERS;
                }
                find(pair, first, second);
            }
            var sign:Number = isBack ? -1 : 1;
            var contact:Contact = _contact;
            contact.time = _numbers[at];
            contact.point.setTo(_numbers[int(at + 1)], _numbers[int(at + 2)], _numbers[int(at + 3)]);
            contact.normal.setTo(sign * _numbers[int(at + 4)], sign * _numbers[int(at + 5)], sign * _numbers[int(at + 6)]);
            contact.depth = _numbers[int(at + 7)];
            return contact;
        }
    }
}
