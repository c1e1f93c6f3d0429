package starlogo.handlers
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;

    /** The handlers of a pair of breeds that come and go. */
    public class PairHandlersTest
    {
        private static const KINDS:Array = [CollisionHandler.START, CollisionHandler.COLLISION, CollisionHandler.END];

        private var _entry:PairHandlers = new PairHandlers(3, 4);
        private var _list:Array = [];
        private var _removed:Array = [];
        private var _order:int = 0;

        /** They are found as in a list, whichever of them is removed. Handlers that the frame knows stay in the list. */
        [Test]
        public function areFoundAsInAList():void
        {
            var random:SeededRandom = new SeededRandom(1);
            var functions:Array = [function():int
                {
                    return 1;
                }, function():int
                {
                    return 2;
                }, function():int
                {
                    return 3;
                }
            ];
            var found:int = 0;
            // the frame knows none of them, some or all
            for each (var known:int in [0, 60, 1000])
            {
                _entry = new PairHandlers(3, 4);
                _list = [];
                _removed = [];
                _order = 0;
                for (var i:int = 0; i < 300; i++)
                {
                    if (random.chance(i < 150 ? 0.6 : 0.35))
                    {
                        add(random.pick(KINDS), random.pick(functions));
                        continue;
                    }
                    found += check(random.pick(functions), random.chance() ? PairHandlers.ANY_KIND : random.pick(KINDS), known, random.chance());
                }
                assertTrue(_removed.length > 60 && _removed.length < _order);
            }
            assertTrue(String(found), found > 300);
            _entry.removeAll(0);
            assertEquals(0, _entry.added.length);
            assertNull(_entry.find(functions[0], PairHandlers.ANY_KIND));
        }

        /** If handlers come and go between two frames, the list does not grow. */
        [Test]
        public function doNotPileUp():void
        {
            for (var i:int = 0; i < 100; i++)
            {
                add(CollisionHandler.START, doNotPileUp);
                _entry.remove(_entry.find(doNotPileUp, CollisionHandler.START), 0);
                assertTrue(_entry.added.length <= 1);
            }
        }

        private function add(kind:int, handler:Function):void
        {
            var added:CollisionHandler = new CollisionHandler(kind, "bears", "trees", handler, _order++);
            _entry.added.push(added);
            _list.push(added);
        }

        // Returns 1 if there was one.
        private function check(handler:Function, kind:int, known:int, isRemoved:Boolean):int
        {
            var matching:Array = _list.filter(function(one:CollisionHandler, index:int, all:Array):Boolean
                {
                    return one.callback == handler && (kind == PairHandlers.ANY_KIND || one.kind == kind);
                });
            var first:CollisionHandler = matching.length == 0 ? null : matching[0];
            assertTrue(_entry.find(handler, kind) === first);
            if (first == null || !isRemoved)
            {
                return first == null ? 0 : 1;
            }
            _entry.remove(first, known);
            _list.splice(_list.indexOf(first), 1);
            _removed.push(first);
            assertTrue("a kept one is there", _list.every(isThere));
            assertTrue("a known one is there", _removed.filter(function(one:CollisionHandler, index:int, all:Array):Boolean
                    {
                        return one.order < known;
                    }).every(isThere));
            return 1;
        }

        private function isThere(one:CollisionHandler, index:int, all:Array):Boolean
        {
            return _entry.added.indexOf(one) >= 0;
        }
    }
}
