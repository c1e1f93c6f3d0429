package starlogo.search
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;

    /** Pairs of a game's own collision system. */
    public class ForeignPairsTest
    {
        private var _foreign:ForeignPairs = new ForeignPairs();
        private var _found:FoundPairs = null;
        private var _a:Agent = new Agent("sphere", "sheep");
        private var _b:Agent = new Agent("sphere", "sheep");
        private var _c:Agent = new Agent("sphere", "sheep");

        [Test]
        public function pairsKeepTheirOrder():void
        {
            _found = _foreign.read(new <Agent>[_c, _a, _b, _c], new <Agent>[_a, _b, _c]);
            assertPairs([_c, _a, _b, _c]);
            assertEquals(3, _found.agentCount);
            assertEquals("an agent's rank is its index", 2, _found.ranks[_found.rows[0]]);
        }

        [Test]
        public function pairsOfOthersAreLeftOut():void
        {
            // the system has a list of its own, and an entry of the game's list may be missing
            _found = _foreign.read(new <Agent>[_a, _b, _b, _c, _a, _c], new <Agent>[_a, null, _c]);
            assertPairs([_a, _c]);
        }

        [Test]
        public function anAgentWithoutAnotherIsNoPair():void
        {
            _found = _foreign.read(new <Agent>[_a, _b, _c], new <Agent>[_a, _b, _c]);
            assertPairs([_a, _b]);
        }

        [Test]
        public function eachListHasItsOwnRows():void
        {
            _found = _foreign.read(new <Agent>[_a, _b], new <Agent>[_a, _b]);
            var before:int = _found.revision;
            _found = _foreign.read(new <Agent>[_a, _b, _c, _b], new <Agent>[_b, _c]);
            assertPairs([_c, _b]);
            assertTrue("these are other pairs", _found.revision != before && _found.basis == -1);
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
