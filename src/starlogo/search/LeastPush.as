package starlogo.search
{
    import starlogo.intersection.contact.ContactPoint;

    /**
     * Finds the shortest push that leads out of several contacts at once. Each contact asks for a push of at least some length along its
     * normal. The shortest push is along one normal, along the line where the planes of two contacts meet, or to the corner of three.
     */
    internal final class LeastPush
    {
        // Later contacts are refused.
        private static const MOST:int = 12;

        // Two planes are parallel if the squared sine of their angle is less than this. Three meet in no point if their volume is.
        private static const PARALLEL:Number = 1e-6;

        // How much less than asked a push may be along a normal, as a fraction of the lengths, because of rounding.
        private static const ROUNDING:Number = 1e-12;

        /** The push. */
        public var x:Number = 0;

        /** @copy #x */
        public var y:Number = 0;

        /** @copy #x */
        public var z:Number = 0;

        /** Its length; Infinity if no push was found. */
        public var length:Number = 0;

        // By contact: the normal, and how far the push has to go along it.
        private var _xs:Vector.<Number> = new Vector.<Number>(MOST, true);
        private var _ys:Vector.<Number> = new Vector.<Number>(MOST, true);
        private var _zs:Vector.<Number> = new Vector.<Number>(MOST, true);
        private var _depths:Vector.<Number> = new Vector.<Number>(MOST, true);
        private var _count:int = 0;

        // The push that is tried.
        private var _tryX:Number = 0;
        private var _tryY:Number = 0;
        private var _tryZ:Number = 0;

        /** Creates a push of length 0. */
        public function LeastPush()
        {
        }

        /** Begins without contacts. */
        public function begin():void
        {
            _count = 0;
            x = y = z = length = 0;
        }

        /**
         * Adds a contact that was found after the push so far, and finds the new push.
         *
         * @param slack is added to the contact's depth
         */
        public function add(contact:ContactPoint, slack:Number):void
        {
            if (_count == MOST)
            {
                length = Infinity;
                return;
            }
            var last:int = _count;
            _xs[last] = contact.normalX;
            _ys[last] = contact.normalY;
            _zs[last] = contact.normalZ;
            _depths[last] = contact.depth + slack + contact.normalX * x + contact.normalY * y + contact.normalZ * z;
            _count++;
            // the push so far does not satisfy the new contact, so the new push lies in its plane
            length = Infinity;
            _tryX = _depths[last] * contact.normalX;
            _tryY = _depths[last] * contact.normalY;
            _tryZ = _depths[last] * contact.normalZ;
            keepShorter();
            for (var i:int = 0; i < last; i++)
            {
                meetTwo(last, i);
                for (var j:int = 0; j < i; j++)
                {
                    meetThree(last, i, j);
                }
            }
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
                _tryX = first * _xs[i] + second * _xs[j];
                _tryY = first * _ys[i] + second * _ys[j];
                _tryZ = first * _zs[i] + second * _zs[j];
                keepShorter();
            }
        }

        // Tries the point of three planes.
        private function meetThree(i:int, j:int, k:int):void
        {
            var volume:Number = _xs[i] * (_ys[j] * _zs[k] - _zs[j] * _ys[k]) + _ys[i] * (_zs[j] * _xs[k] - _xs[j] * _zs[k])
                + _zs[i] * (_xs[j] * _ys[k] - _ys[j] * _xs[k]);
            if (volume * volume > PARALLEL)
            {
                _tryX = _tryY = _tryZ = 0;
                addCross(_depths[i] / volume, j, k);
                addCross(_depths[j] / volume, k, i);
                addCross(_depths[k] / volume, i, j);
                keepShorter();
            }
        }

        // Adds a multiple of the cross product of two normals.
        private function addCross(factor:Number, i:int, j:int):void
        {
            _tryX += factor * (_ys[i] * _zs[j] - _zs[i] * _ys[j]);
            _tryY += factor * (_zs[i] * _xs[j] - _xs[i] * _zs[j]);
            _tryZ += factor * (_xs[i] * _ys[j] - _ys[i] * _xs[j]);
        }

        // Keeps the push that is tried if it is shorter and leads out of all contacts.
        private function keepShorter():void
        {
            var tried:Number = Math.sqrt(_tryX * _tryX + _tryY * _tryY + _tryZ * _tryZ);
            var isOut:Boolean = tried < length;
            for (var i:int = 0; i < _count && isOut; i++)
            {
                isOut = _tryX * _xs[i] + _tryY * _ys[i] + _tryZ * _zs[i] >= _depths[i] - ROUNDING * tried;
            }
            if (isOut)
            {
                x = _tryX;
                y = _tryY;
                z = _tryZ;
                length = tried;
            }
        }
    }
}
