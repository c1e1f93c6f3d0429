package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.handlers.ContactSource;

    use namespace engine;

    /** The contacts of those pairs of a frame whose handlers take them. */
    internal final class FrameContacts implements ContactSource
    {
        /** The collision system that has found the pairs. */
        public var system:BaseCollider = null;

        // By the numbers of the pairs; there may be more entries than the frame has pairs.
        private var _contacts:Vector.<Contact> = new Vector.<Contact>();
        private var _areKnown:Vector.<Boolean> = new Vector.<Boolean>();

        // The contact that handlers get.
        private var _given:Contact = new Contact();

        // The contact that handlers get which need not look at it.
        private var _whenAsked:ContactWhenAsked = new ContactWhenAsked();

        /** No contacts yet. */
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
            _contacts[pair] = system.contactOf(first, second, _contacts[pair]);
            _areKnown[pair] = true;
        }

        /** @inheritDoc */
        public function contactOf(pair:int, first:Agent, second:Agent, isBack:Boolean):Object
        {
            if (!_areKnown[pair])
            {
                // its breeds have changed since the frame began
                find(pair, first, second);
            }
            var known:Contact = _contacts[pair];
            var given:Contact = _given;
            given.time = known.time;
            given.depth = known.depth;
            given.point.copyFrom(known.point);
            given.normal.copyFrom(known.normal);
            if (isBack)
            {
                given.normal.negate();
            }
            return given;
        }

        /** @inheritDoc */
        public function contactWhenAsked(pair:int, first:Agent, second:Agent, isBack:Boolean):Object
        {
            return _whenAsked.of(this, pair, first, second, isBack);
        }
    }
}
