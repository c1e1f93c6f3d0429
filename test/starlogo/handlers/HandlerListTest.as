package starlogo.handlers
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    /** The handlers of a pair of breeds that come and go. */
    public class HandlerListTest
    {
        private static const PHASES:Array = [CollisionHandler.START, CollisionHandler.EVERY_FRAME, CollisionHandler.END];
        private static const ANY_PHASE:int = CollisionHandler.START | CollisionHandler.EVERY_FRAME | CollisionHandler.END;
        private static const ALL:int = 1000;

        private var _handlers:HandlerList = new HandlerList();
        private var _expected:Array = [];
        private var _order:int = 0;

        /** They are removed as from a list, whichever of them it is, and the others stay in order. */
        [Test]
        public function areRemovedAsFromAList():void
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
            var removed:int = 0;
            var missed:int = 0;
            for (var game:int = 0; game < 3; game++)
            {
                for (var i:int = 0; i < 300; i++)
                {
                    if (random.chance(i < 150 ? 0.6 : 0.35))
                    {
                        add(random.pick(PHASES), random.pick(functions));
                        continue;
                    }
                    var wasThere:Boolean = removeOne(random.pick(functions), random.chance() ? ANY_PHASE : random.pick(PHASES));
                    removed += wasThere ? 1 : 0;
                    missed += wasThere ? 0 : 1;
                    assertOrders(random.integer(0, _order));
                }
            }
            assertTrue(removed + " " + missed, removed > 300 && missed > 10);
            var left:Array = _expected;
            assertTrue(left.length > 0);
            _handlers.clear();
            _expected = [];
            assertOrders(ALL);
            assertTrue(left.every(function(one:CollisionHandler, index:int, all:Array):Boolean
                    {
                        return one.isRemoved;
                    }));
        }

        /** However many are removed from the front or from the end, those in between stay. */
        [Test]
        public function areRemovedFromBothEnds():void
        {
            for (var i:int = 0; i < 40; i++)
            {
                add(CollisionHandler.START, i == 20 ? areRemovedFromBothEnds : areRemovedAsFromAList);
            }
            for (i = 0; i < 39; i++)
            {
                assertTrue(removeOne(areRemovedAsFromAList, ANY_PHASE));
                assertOrders(ALL);
            }
            assertEquals(1, _expected.length);
            assertTrue(!removeOne(areRemovedAsFromAList, ANY_PHASE));
            assertTrue(removeOne(areRemovedFromBothEnds, CollisionHandler.START));
        }

        private function add(phase:int, handler:Function):void
        {
            var added:CollisionHandler = new CollisionHandler("bears", "trees", handler, phase, _order++);
            _handlers.add(added);
            _expected.push(added);
        }

        // Returns whether there was one.
        private function removeOne(handler:Function, phase:int):Boolean
        {
            var matching:Array = _expected.filter(function(one:CollisionHandler, index:int, all:Array):Boolean
                {
                    return one.callback == handler && (one.phase & phase) != 0;
                });
            assertEquals(matching.length > 0, _handlers.remove(handler, phase));
            if (matching.length > 0)
            {
                assertTrue(matching[0].isRemoved);
                _expected.splice(_expected.indexOf(matching[0]), 1);
            }
            return matching.length > 0;
        }

        private function assertOrders(end:int):void
        {
            var found:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
            _handlers.appendTo(found, end);
            var wanted:Array = _expected.filter(function(one:CollisionHandler, index:int, all:Array):Boolean
                {
                    return one.addedAt < end;
                });
            assertEquals(orders(wanted).join(), orders(found).join());
        }

        private static function orders(list:Object):Array
        {
            var all:Array = [];
            for each (var one:CollisionHandler in list)
            {
                assertTrue(!one.isRemoved);
                all.push(one.addedAt);
            }
            return all;
        }
    }
}
