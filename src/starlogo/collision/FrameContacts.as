package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.handlers.ContactSource;

    /** Computes the contacts of a frame's pairs, for the pairs whose handlers take contacts. */
    internal final class FrameContacts implements ContactSource
    {
        /** The collision system that found the pairs. */
        public var system:BaseCollider = null;

        // Indexed by the pairs' numbers. There may be more entries than pairs.
        private var _contacts:Vector.<Contact> = new Vector.<Contact>();
        private var _areKnown:Vector.<Boolean> = new Vector.<Boolean>();

        // The contact passed to handlers.
        private var _given:Contact = new Contact();

        /** Creates it without contacts. */
        public function FrameContacts()
        {
        }

        /** @inheritDoc */
        public function beginFrame(pairCount:int):void
        {
            for (var i:int = 0; i < pairCount; i++)
            {
                _areKnown[i] = false;
            }
        }

        /** @inheritDoc */
        public function find(pair:int, first:Agent, second:Agent):void
        {
            while (_contacts.length <= pair)
            {
                _contacts.push(new Contact());
            }
            if (!_areKnown[pair])
            {
                system.contactOf(first, second, _contacts[pair]);
                _areKnown[pair] = true;
            }
        }

        /** @inheritDoc */
        public function contactFor(pair:int, first:Agent, second:Agent, isBack:Boolean):Object
        {
            find(pair, first, second);
            var known:Contact = _contacts[pair];
            _given.time = known.time;
            _given.depth = known.depth;
            _given.approachSpeed = known.approachSpeed;
            _given.point.copyFrom(known.point);
            _given.normal.copyFrom(known.normal);
            if (isBack)
            {
                _given.normal.negate();
            }
            return _given;
        }
    }
}
