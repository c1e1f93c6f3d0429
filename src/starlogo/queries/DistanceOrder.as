package starlogo.queries
{
    /**
     * Puts members into the order of their distances, those that are equally far into the order of the list (merge sort, from runs that are sorted
     * by insertion).
     *
     * @private
     */
    public final class DistanceOrder
    {
        private static const RUN:int = 8;

        private var _otherMembers:Vector.<int> = new Vector.<int>();
        private var _otherSquares:Vector.<Number> = new Vector.<Number>();

        // The columns that are merged, and those that take the result.
        private var _fromMembers:Vector.<int>;
        private var _fromSquares:Vector.<Number>;
        private var _toMembers:Vector.<int>;
        private var _toSquares:Vector.<Number>;

        /** Nothing ordered yet. */
        public function DistanceOrder()
        {
        }

        /**
         * Orders some members.
         *
         * @param members numbers of the list, all different
         * @param squares their squared distances
         * @param count how many
         */
        public function sort(members:Vector.<int>, squares:Vector.<Number>, count:int):void
        {
            for (var low:int = 0; low < count; low += RUN)
            {
                insert(members, squares, low, low + RUN < count ? low + RUN : count);
            }
            if (count <= RUN)
            {
                return;
            }
            if (_otherMembers.length < members.length)
            {
                _otherMembers.length = _otherSquares.length = members.length;
            }
            _fromMembers = members;
            _fromSquares = squares;
            _toMembers = _otherMembers;
            _toSquares = _otherSquares;
            for (var width:int = RUN; width < count; width *= 2)
            {
                for (low = 0; low < count; low += 2 * width)
                {
                    var middle:int = low + width < count ? low + width : count;
                    merge(low, middle, middle + width < count ? middle + width : count);
                }
                var takenMembers:Vector.<int> = _fromMembers;
                var takenSquares:Vector.<Number> = _fromSquares;
                _fromMembers = _toMembers;
                _fromSquares = _toSquares;
                _toMembers = takenMembers;
                _toSquares = takenSquares;
            }
            if (_fromMembers !== members)
            {
                for (var i:int = 0; i < count; i++)
                {
                    members[i] = _fromMembers[i];
                    squares[i] = _fromSquares[i];
                }
            }
        }

        private static function insert(members:Vector.<int>, squares:Vector.<Number>, low:int, high:int):void
        {
            for (var i:int = low + 1; i < high; i++)
            {
                var member:int = members[i];
                var square:Number = squares[i];
                var at:int = i - 1;
                while (at >= low && (squares[at] > square || (squares[at] == square && members[at] > member)))
                {
                    squares[int(at + 1)] = squares[at];
                    members[int(at + 1)] = members[at];
                    at--;
                }
                squares[int(at + 1)] = square;
                members[int(at + 1)] = member;
            }
        }

        private function merge(low:int, middle:int, high:int):void
        {
            var fromMembers:Vector.<int> = _fromMembers;
            var fromSquares:Vector.<Number> = _fromSquares;
            var toMembers:Vector.<int> = _toMembers;
            var toSquares:Vector.<Number> = _toSquares;
            var left:int = low;
            var right:int = middle;
            for (var i:int = low; i < high; i++)
            {
                var isLeft:Boolean = left < middle;
                if (isLeft && right < high)
                {
                    isLeft = fromSquares[left] < fromSquares[right]
                        || (fromSquares[left] == fromSquares[right] && fromMembers[left] < fromMembers[right]);
                }
                var from:int = right;
                if (isLeft)
                {
                    from = left;
                    left++;
                }
                else
                {
                    right++;
                }
                toMembers[i] = fromMembers[from];
                toSquares[i] = fromSquares[from];
            }
        }
    }
}
