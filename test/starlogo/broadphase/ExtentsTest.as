package starlogo.broadphase
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    /** There are few levels of cells, whatever the extents. */
    public class ExtentsTest
    {
        private var _extents:Extents = new Extents();

        // The levels that were needed, and how many they are.
        private var _levels:Object = {};
        private var _count:int = 0;

        [Before]
        public function makeLevels():void
        {
            _extents.grow(1);
        }

        [Test]
        public function pointsNeedOneLevel():void
        {
            for each (var place:Number in [0, 1e-9, 1, -50, 150])
            {
                fit(0, place);
                assertEquals(1, _count);
            }
            // with a unit sphere there are two
            fit(0.5, 50);
            assertEquals(2, _count);
            fit(1e-200, -30);
            assertEquals(2, _count);
        }

        [Test]
        public function aDistanceNeedsItsOwnLevelAlone():void
        {
            for each (var place:Number in [1e6, 1e9, 1e15])
            {
                var before:int = _count;
                fit(0, place);
                assertEquals(before + 1, _count);
                assertTrue(String(place), place < BinLevel.MIN_WIDTH * Math.pow(2, _extents.levelIndices[0] - 1) * BinLevel.MAX_DISTANCE);
            }
        }

        [Test]
        public function sizesOverManyOrdersNeedALevelForEachDoublingAtMost():void
        {
            for (var size:Number = 1e-120; size < 1e15; size *= 1.3)
            {
                fit(size, 0);
            }
            assertTrue(_count + " levels", _count < 70);
        }

        [Test]
        public function noExtentsMakeItGoOnForEver():void
        {
            for each (var value:Number in [1e155, 1e200, Infinity])
            {
                fit(1, value);
                fit(value, 0);
            }
        }

        private function fit(half:Number, place:Number):void
        {
            _extents.halfX[0] = _extents.halfY[0] = half;
            _extents.x[0] = place;
            _extents.assignLevel(0);
            if (!_levels[_extents.levelIndices[0]])
            {
                _levels[_extents.levelIndices[0]] = true;
                _count++;
            }
        }
    }
}
