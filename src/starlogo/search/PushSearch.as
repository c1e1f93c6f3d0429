package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * Finds the shortest push that leads out of several contacts. A contact requires a push of at least its depth along its normal.
     *
     * <p>In each step it tries the shortest push in its list. If the body still touches something there, pushes are added that also lead out
     * of this contact. When a push frees the body, no push in the list is shorter (branch and bound).</p>
     */
    internal final class PushSearch
    {
        // The most pushes that are kept.
        private static const MOST:int = 256;

        // The numbers of a push: its vector, its length, and for each contact that decides it the normal and the depth along it. Three contacts
        // at most decide.
        private static const LENGTH:int = 3;
        private static const FIRST:int = 4;
        private static const STRIDE:int = 16;

        // Two planes are parallel if the squared sine of their angle is less than this. Three have no common point if the
        // squared volume of their normals is.
        private static const PARALLEL:Number = 1e-6;

        // How much shorter than required a push may be along a normal, as a fraction of its length, because of rounding.
        private static const ROUNDING:Number = 1e-12;

        /** The current push. */
        public var push:Vector3D = new Vector3D();

        /** Its length. */
        public var length:Number = 0;

        /** How many contacts decide about the current push. */
        public var deciding:int = 0;

        // The pushes. The length of one that was taken is Infinity. The current one is -1 at first.
        private var _pushes:Vector.<Number> = new Vector.<Number>();
        private var _deciding:Vector.<int> = new Vector.<int>();
        private var _count:int = 0;
        private var _current:int = -1;

        // The new contact and those that decide about the current push: the normals, and how far a push has to go along them.
        private var _xs:Vector.<Number> = new Vector.<Number>(4, true);
        private var _ys:Vector.<Number> = new Vector.<Number>(4, true);
        private var _zs:Vector.<Number> = new Vector.<Number>(4, true);
        private var _depths:Vector.<Number> = new Vector.<Number>(4, true);

        // The push that is tried; the shortest one so far, its length, and which of the contacts decide about it.
        private var _tried:Vector3D = new Vector3D();
        private var _shortest:Vector3D = new Vector3D();
        private var _best:Number = 0;
        private var _second:int = 0;
        private var _third:int = 0;

        /** Begins again, with a push of length 0. */
        public function begin():void
        {
            _count = deciding = 0;
            _current = -1;
            length = 0;
            push.setTo(0, 0, 0);
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
            _xs[0] = contact.normalX;
            _ys[0] = contact.normalY;
            _zs[0] = contact.normalZ;
            for (var i:int = 1; i <= deciding; i++)
            {
                var at:int = STRIDE * _current + 4 * i;
                _xs[i] = _pushes[at];
                _ys[i] = _pushes[int(at + 1)];
                _zs[i] = _pushes[int(at + 2)];
                _depths[i] = _pushes[int(at + 3)];
                slack *= 2;
            }
            _depths[0] = contact.depth + slack + contact.normalX * push.x + contact.normalY * push.y + contact.normalZ * push.z;
            findShortest();
            if (_best < Infinity && _count < MOST && isNew(slack))
            {
                keep();
            }
        }

        // Finds the shortest push. The current one does not lead out of the new contact, so the push lies in its plane.
        private function findShortest():void
        {
            _best = Infinity;
            _tried.setTo(_depths[0] * _xs[0], _depths[0] * _ys[0], _depths[0] * _zs[0]);
            keepShorter(0, 0);
            for (var i:int = 1; i <= deciding; i++)
            {
                meetTwo(0, i);
                for (var j:int = 1; j < i; j++)
                {
                    meetThree(0, j, i);
                }
            }
        }

        // Whether the shortest push differs from all others, except the current one, by more than the slack.
        private function isNew(slack:Number):Boolean
        {
            for (var i:int = 0; i < _count; i++)
            {
                var at:int = STRIDE * i;
                var off:Number = Math.abs(_pushes[at] - _shortest.x) + Math.abs(_pushes[int(at + 1)] - _shortest.y) + Math.abs(_pushes[int(at + 2)] - _shortest.z);
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
            _pushes[at] = _shortest.x;
            _pushes[int(at + 1)] = _shortest.y;
            _pushes[int(at + 2)] = _shortest.z;
            _pushes[int(at + LENGTH)] = _best;
            _deciding[_count] = _third > 0 ? 3 : _second > 0 ? 2 : 1;
            keepContact(at + FIRST, 0);
            keepContact(at + FIRST + 4, _second);
            keepContact(at + FIRST + 8, _third);
            _count++;
        }

        private function keepContact(at:int, contact:int):void
        {
            _pushes[at] = _xs[contact];
            _pushes[int(at + 1)] = _ys[contact];
            _pushes[int(at + 2)] = _zs[contact];
            _pushes[int(at + 3)] = _depths[contact];
        }

        // Tries the point of two planes that is nearest to the origin.
        private function meetTwo(i:int, j:int):void
        {
            var cosine:Number = _xs[i] * _xs[j] + _ys[i] * _ys[j] + _zs[i] * _zs[j];
            var squaredSine:Number = 1 - cosine * cosine;
            if (squaredSine > PARALLEL)
            {
                var first:Number = (_depths[i] - cosine * _depths[j]) / squaredSine;
                var second:Number = (_depths[j] - cosine * _depths[i]) / squaredSine;
                _tried.setTo(first * _xs[i] + second * _xs[j], first * _ys[i] + second * _ys[j], first * _zs[i] + second * _zs[j]);
                keepShorter(j, 0);
            }
        }

        // Tries the point of three planes.
        private function meetThree(i:int, j:int, k:int):void
        {
            var volume:Number = _xs[i] * (_ys[j] * _zs[k] - _zs[j] * _ys[k]) + _ys[i] * (_zs[j] * _xs[k] - _xs[j] * _zs[k])
                + _zs[i] * (_xs[j] * _ys[k] - _ys[j] * _xs[k]);
            if (volume * volume > PARALLEL)
            {
                _tried.setTo(0, 0, 0);
                addCross(_depths[i] / volume, j, k);
                addCross(_depths[j] / volume, k, i);
                addCross(_depths[k] / volume, i, j);
                keepShorter(j, k);
            }
        }

        // Adds a multiple of the cross product of two normals.
        private function addCross(factor:Number, i:int, j:int):void
        {
            _tried.x += factor * (_ys[i] * _zs[j] - _zs[i] * _ys[j]);
            _tried.y += factor * (_zs[i] * _xs[j] - _xs[i] * _zs[j]);
            _tried.z += factor * (_xs[i] * _ys[j] - _ys[i] * _xs[j]);
        }

        // Keeps the push that is tried if it is shorter and leads out of all contacts.
        private function keepShorter(second:int, third:int):void
        {
            var tried:Number = Math.sqrt(_tried.x * _tried.x + _tried.y * _tried.y + _tried.z * _tried.z);
            var isOut:Boolean = tried < _best;
            for (var i:int = 0; i <= deciding && isOut; i++)
            {
                isOut = _tried.x * _xs[i] + _tried.y * _ys[i] + _tried.z * _zs[i] >= _depths[i] - ROUNDING * tried;
            }
            if (isOut)
            {
                _shortest.copyFrom(_tried);
                _best = tried;
                _second = second;
                _third = third;
            }
        }
    }
}
