package starlogo.broadphase
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    /** There are few levels of cells, whatever the extents. */
    public class ExtentsTest
    {
        private var _extents:Extents = new Extents();

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
                assertEquals(1, count());
                assertTrue(String(place), _extents.levelsEndSquared > 0);
            }
            // with a unit sphere there are two
            fit(0.5, 50);
            assertEquals(2, count());
            fit(1e-200, -30);
            assertEquals(2, count());
        }

        [Test]
        public function aDistanceNeedsItsOwnLevelAlone():void
        {
            for each (var place:Number in [1e6, 1e9, 1e15])
            {
                var before:int = count();
                fit(0, place);
                assertEquals(before + 1, count());
                assertTrue(String(place), place * place < _extents.byIndex[_extents.level[0]].maxDistanceSquared);
            }
        }

        [Test]
        public function sizesOverManyOrdersNeedALevelForEachDoublingAtMost():void
        {
            for (var size:Number = 1e-120; size < 1e15; size *= 1.3)
            {
                fit(size, 0);
            }
            assertTrue(count() + " levels", count() < 70);
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
        }

        private function count():int
        {
            return _extents.byWidth.length;
        }
    }
}
