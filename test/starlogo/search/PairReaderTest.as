package starlogo.search
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertStrictlyEquals;
    import starlogo.agents.Agent;
    import support.assertThrows;

    /** Pairs of a game's own collision system. */
    public class PairReaderTest
    {
        private var _reader:PairReader = new PairReader();
        private var _found:FoundPairs = null;
        private var _a:Agent = new Agent("sphere", "sheep");
        private var _b:Agent = new Agent("sphere", "sheep");
        private var _c:Agent = new Agent("sphere", "sheep");

        [Test]
        public function pairsKeepTheirOrder():void
        {
            read([_a, _b, _c], [_c, _a, _b, _c]);
            assertPairs([_c, _a, _b, _c]);
            assertEquals(3, _found.listed.rows.count);
            assertEquals("an agent's index in the list", 2, _found.listed.listIndices[_found.rows[0]]);
        }

        [Test]
        public function whatIsNoPairOfTheListIsRefused():void
        {
            var list:Array = [_a, _b, _c];
            assertThrows(ArgumentError, /has found pairs of 3 agents/, read, list, [_a, _b, _c]);
            assertThrows(ArgumentError, /has found no agent: 2 of what it has found is null/, read, list, [_a, _b, null, _c]);
            assertThrows(ArgumentError, /which is not in the list/, read, [_a, _b], [_a, _b, _a, _c]);
            assertThrows(ArgumentError, /is null/, read, [_a, null], []);
            assertThrows(ArgumentError, /is listed twice/, read, [_a, _a], []);
            assertThrows(ArgumentError, /has found .*with itself: it is at 2 and 3 of what/, read, list, [_a, _b, _c, _c]);
            assertThrows(ArgumentError, /has found .* twice: the second time at 4 of/, read, list, [_a, _b, _a, _c, _b, _a]);
            assertThrows(ArgumentError, /has found .* twice: the second time at 2 of/, read, list, [_a, _b, _a, _b]);
            read(list, [_a, _c]);
            assertPairs([_a, _c]);
        }

        [Test]
        public function eachListHasItsOwnRows():void
        {
            read([_a, _b], [_a, _b]);
            _found.touchIndices[0] = 7;
            read([_b, _c], [_c, _b]);
            assertPairs([_c, _b]);
            assertEquals("these are other pairs", FoundPairs.NO_TOUCH, _found.touchIndices[0]);
        }

        private function read(list:Array, pairs:Array):void
        {
            _reader.begin(Vector.<Agent>(list));
            _found = _reader.read(Vector.<Agent>(pairs));
        }

        private function assertPairs(expected:Array):void
        {
            assertEquals(expected.length, 2 * _found.count);
            for (var i:int = 0; i < _found.count; i++)
            {
                assertStrictlyEquals(expected[2 * i], _found.firstOf(i));
                assertStrictlyEquals(expected[2 * i + 1], _found.secondOf(i));
            }
        }
    }
}
