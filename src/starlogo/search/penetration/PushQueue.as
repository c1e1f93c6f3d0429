package starlogo.search.penetration
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * Finds the shortest push that leads out of several contacts. A contact requires a push of at least its depth along its normal.
     *
     * <p>PushOut takes the shortest push of the list and tries it. If the body still touches something there, pushes are added that also lead
     * out of this contact. When a push frees the body, no push in the list is shorter (branch and bound).</p>
     */
    internal final class PushQueue
    {
        // The most pushes that are kept.
        private static const MOST:int = 256;

        // The numbers of a push: its vector, its length, and for each contact that decides it the normal and the depth along it. Three contacts
        // at most decide.
        private static const LENGTH:int = 3;
        private static const FIRST:int = 4;
        private static const STRIDE:int = 16;

        /** The current push. */
        public var push:Vector3D = new Vector3D();

        /** Its length. */
        public var length:Number = 0;

        /** How many contacts decide about the current push. */
        public var deciding:int = 0;

        // The pushes. The length of one that was taken is Infinity.
        private var _pushes:Vector.<Number> = new Vector.<Number>();

        // By push: how many contacts decide about it.
        private var _deciding:Vector.<int> = new Vector.<int>();

        private var _count:int = 0;

        // The number of the current push, -1 at first.
        private var _current:int = -1;

        // The new contact and those that decide about the current push, as half-spaces.
        private var _halfSpaces:HalfSpaceSolver = new HalfSpaceSolver();

        // The shortest displacement out of the half-spaces.
        private var _shortest:ShortestExit = new ShortestExit();

        /** Begins again, with a push of length 0. */
        public function begin():void
        {
            _count = deciding = 0;
            _current = -1;
            length = 0;
            push.setTo(0, 0, 0);
        }

        /** Whether the current push is the one that was added first. */
        public function get isFirst():Boolean
        {
            return _current == 0;
        }

        /** Goes on to the shortest push that is left. Returns false if there is none. */
        public function next():Boolean
        {
            length = Infinity;
            for (var i:int = 0; i < _count; i++)
            {
                if (_pushes[int(STRIDE * i + LENGTH)] < length)
                {
                    length = _pushes[int(STRIDE * i + LENGTH)];
                    _current = i;
                }
            }
            var at:int = STRIDE * _current;
            if (length == Infinity)
            {
                return false;
            }
            push.setTo(_pushes[at], _pushes[int(at + 1)], _pushes[int(at + 2)]);
            _pushes[int(at + LENGTH)] = Infinity;
            deciding = _deciding[_current];
            return true;
        }

        /**
         * Adds the push that also leads out of a contact, which was found after the current push.
         *
         * @param slack is added to the contact's depth; twice as much for each contact that decides about the current push
         */
        public function add(contact:ContactPoint, slack:Number):void
        {
            _halfSpaces.begin();
            for (var i:int = 0; i < deciding; i++)
            {
                var at:int = STRIDE * _current + FIRST + 4 * i;
                _halfSpaces.add(_pushes[at], _pushes[int(at + 1)], _pushes[int(at + 2)], _pushes[int(at + 3)]);
                slack *= 2;
            }
            var along:Number = contact.normalX * push.x + contact.normalY * push.y + contact.normalZ * push.z;
            _halfSpaces.add(contact.normalX, contact.normalY, contact.normalZ, contact.depth + slack + along);
            // if the new contact does not decide, the current push is out of it, and leads nowhere
            if (_count < MOST && _halfSpaces.solve(3, 0, _shortest) && _shortest.last == deciding && isNew(slack))
            {
                keep();
            }
        }

        // Whether the shortest push differs from all others, except the current one, by more than the slack.
        private function isNew(slack:Number):Boolean
        {
            for (var i:int = 0; i < _count; i++)
            {
                var at:int = STRIDE * i;
                var off:Number = Math.abs(_pushes[at] - _shortest.displacement.x) + Math.abs(_pushes[int(at + 1)] - _shortest.displacement.y)
                    + Math.abs(_pushes[int(at + 2)] - _shortest.displacement.z);
                if (off <= slack && i != _current)
                {
                    return false;
                }
            }
            return true;
        }

        private function keep():void
        {
            if (_count == _deciding.length)
            {
                // most bodies need few pushes, so MOST would be much memory for each collider
                _deciding.length = 2 * _count + 4;
                _pushes.length = STRIDE * _deciding.length;
            }
            var at:int = STRIDE * _count;
            _pushes[at] = _shortest.displacement.x;
            _pushes[int(at + 1)] = _shortest.displacement.y;
            _pushes[int(at + 2)] = _shortest.displacement.z;
            _pushes[int(at + LENGTH)] = _shortest.length;
            _deciding[_count] = _shortest.deciding;
            _halfSpaces.write(_shortest.last, _pushes, at + FIRST);
            _halfSpaces.write(_shortest.second, _pushes, at + FIRST + 4);
            _halfSpaces.write(_shortest.third, _pushes, at + FIRST + 8);
            _count++;
        }
    }
}
