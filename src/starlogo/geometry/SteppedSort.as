package starlogo.geometry
{
    import starlogo.steps.Slices;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * The order of many numbers, in steps: the player's own sort is the fastest, but sorts all that it is given in one. So they are put
     * into buckets of about as many first, each for a part of their range, and a step sorts one of those. Numbers that are crowded in a
     * small part of the range make a longer step.
     */
    internal final class SteppedSort implements Steps
    {
        private static const NUMBERS_A_STEP:int = 5000;

        // so many are one bucket
        private static const FEW:int = 10000;

        private var _keys:Array;
        private var _order:Array;
        private var _least:Number = Infinity;
        private var _largest:Number = -Infinity;
        private var _scale:Number;

        // The numbers' indices, by bucket; a bucket that is sorted is let go of.
        private var _buckets:Vector.<Array>;
        private var _work:StepSequence = new StepSequence();

        /**
         * @param keys finite numbers; not to be changed until the last step is done
         */
        public function SteppedSort(keys:Array)
        {
            _keys = keys;
            if (keys.length <= FEW)
            {
                _work.call(sortAll);
                return;
            }
            _work.add(new Slices(keys.length, NUMBERS_A_STEP, measure)).begin(newBuckets).begin(sortBuckets);
        }

        /** The indices of the numbers, from the least to the greatest, when no step is left; equal ones in any order. */
        public function get order():Array
        {
            return _order;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            return _work.step();
        }

        private function sortAll():void
        {
            _order = _keys.sort(Array.NUMERIC | Array.RETURNINDEXEDARRAY);
        }

        private function measure(first:int, end:int):void
        {
            var least:Number = _least;
            var largest:Number = _largest;
            for (var i:int = first; i < end; i++)
            {
                var key:Number = _keys[i];
                if (key < least)
                {
                    least = key;
                }
                if (key > largest)
                {
                    largest = key;
                }
            }
            _least = least;
            _largest = largest;
        }

        private function newBuckets():Steps
        {
            var count:int = _largest > _least ? _keys.length / NUMBERS_A_STEP : 1;
            _buckets = new Vector.<Array>(count);
            for (var i:int = 0; i < count; i++)
            {
                _buckets[i] = [];
            }
            // the greatest goes into the last one in spite of rounding
            _scale = count > 1 ? count * (1 - 1e-9) / (_largest - _least) : 0;
            return new Slices(_keys.length, NUMBERS_A_STEP, distribute);
        }

        private function distribute(first:int, end:int):void
        {
            var least:Number = _least;
            var scale:Number = _scale;
            for (var i:int = first; i < end; i++)
            {
                var bucket:int = (_keys[i] - least) * scale;
                _buckets[bucket].push(i);
            }
        }

        private function sortBuckets():Steps
        {
            _order = [];
            return new Slices(_buckets.length, 1, sortBucket);
        }

        private function sortBucket(first:int, end:int):void
        {
            var indices:Array = _buckets[first];
            var keys:Array = [];
            var i:int;
            for (i = 0; i < indices.length; i++)
            {
                keys.push(_keys[indices[i]]);
            }
            var sorted:Array = keys.sort(Array.NUMERIC | Array.RETURNINDEXEDARRAY);
            for (i = 0; i < sorted.length; i++)
            {
                _order.push(indices[sorted[i]]);
            }
            _buckets[first] = null;
        }
    }
}
