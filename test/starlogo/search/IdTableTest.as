package starlogo.search
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    public class IdTableTest
    {
        private static const MOST:int = 300;

        private var _random:SeededRandom = new SeededRandom(515);
        private var _table:IdTable = new IdTable();

        // The values, by id; -1 where there is none.
        private var _expected:Object = {};

        [Test]
        public function anEmptyTableHasNothing():void
        {
            assertEquals(-1, _table.valueOf(1));
            _table.remove(1);
            _table.clear();
        }

        [Test]
        public function aValueMayBeReplaced():void
        {
            _table.set (7, 0);
            _table.set (7, -2);
            assertEquals(-2, _table.valueOf(7));
            assertTrue(_table.has(7));
        }

        [Test]
        public function idsOfALongRun():void
        {
            playWith(1, 1000000000);
        }

        [Test]
        public function thousandsAreTakenOutAndPutBack():void
        {
            for (var i:int = 1; i <= 5000; i++)
            {
                _table.set (3 * i, i);
            }
            for (i = 1; i <= 5000; i += 2)
            {
                _table.remove(3 * i);
            }
            for (i = 1; i <= 5000; i++)
            {
                assertEquals(i % 2 == 0 ? i : -1, _table.valueOf(3 * i));
                assertEquals(-1, _table.valueOf(3 * i + 1));
            }
        }

        // Does anything to the table, and looks everything up.
        private function playWith(distance:int, first:int):void
        {
            var removed:int = 0;
            for (var step:int = 0; step < 4000; step++)
            {
                var id:int = first + distance * _random.integer(0, MOST);
                var choice:int = _random.integer(0, step % 1000 < 500 ? 2 : 5);
                if (step % 1000 == 999)
                {
                    _table.clear();
                    _expected = {};
                }
                else if (choice < 2)
                {
                    _expected[id] = _random.integer(0, 1000000);
                    _table.set (id, _expected[id]);
                }
                else
                {
                    removed += id in _expected ? 1 : 0;
                    delete _expected[id];
                    _table.remove(id);
                }
                if (step % 20 == 0)
                {
                    assertTable(distance, first);
                }
            }
            assertTrue(removed + " taken out", removed > 300);
        }

        private function assertTable(distance:int, first:int):void
        {
            for (var i:int = 0; i <= MOST; i++)
            {
                var id:int = first + distance * i;
                assertEquals("id " + id, id in _expected ? _expected[id] : -1, _table.valueOf(id));
            }
        }
    }
}
