package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.handlers.ContactSource;

    use namespace engine;

    /**
     * The contacts of a frame's pairs, for those whose handlers ask for them: a ContactSystem's own, of another collision system what is
     * left to say.
     */
    internal final class FrameContacts extends ContactSource
    {
        private static const NUMBERS:int = 8;

        /** The collision system that has found the pairs. */
        public var system:CollisionSystem = null;

        // Of each pair: time, point, normal, depth. Longer than the frame's, perhaps.
        private var _numbers:Vector.<Number> = new Vector.<Number>();
        private var _contact:Contact = new Contact();

        /** No contacts yet. */
        public function FrameContacts()
        {
        }

        /** @inheritDoc */
        override public function begin(pairCount:int):void
        {
            var length:int = NUMBERS * pairCount;
            if (_numbers.length < length)
            {
                _numbers.length = length;
            }
            for (var at:int = 0; at < length; at += NUMBERS)
            {
                _numbers[at] = NaN;
            }
        }

        /** @inheritDoc */
        override public function find(pair:int, first:Agent, second:Agent):void
        {
            var contact:Contact = _contact;
            var knowing:ContactSystem = system as ContactSystem;
            if (knowing != null)
            {
                knowing.contactOf(first, second, contact);
            }
            else
            {
                contact.placeBetween(first, second);
            }
            var at:int = NUMBERS * pair;
            _numbers[at] = contact.time;
            _numbers[at + 1] = contact.point.x;
            _numbers[at + 2] = contact.point.y;
            _numbers[at + 3] = contact.point.z;
            _numbers[at + 4] = contact.normal.x;
            _numbers[at + 5] = contact.normal.y;
            _numbers[at + 6] = contact.normal.z;
            _numbers[at + 7] = contact.depth;
        }

        /** @inheritDoc */
        override public function contactOf(pair:int, first:Agent, second:Agent, isBack:Boolean):Object
        {
            var at:int = NUMBERS * pair;
            if (isNaN(_numbers[at]))
            {
                // its breeds have changed since the frame began
                find(pair, first, second);
            }
            var sign:Number = isBack ? -1 : 1;
            var contact:Contact = _contact;
            contact.time = _numbers[at];
            contact.point.setTo(_numbers[at + 1], _numbers[at + 2], _numbers[at + 3]);
            contact.normal.setTo(sign * _numbers[at + 4], sign * _numbers[at + 5], sign * _numbers[at + 6]);
            contact.depth = _numbers[at + 7];
            return contact;
        }
    }
}
