package starlogo.models
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.steps.Steps;

    /** The loads of a ModelLoader in their order, and by name. It is its receiver itself. */
    public class LoadQueueTest implements ModelReceiver
    {
        // one is a member of every object
        private static const NAMES:Array = ["bear", "tree", "hasOwnProperty", "toString", "kelp"];

        private var _loader:ModelLoader = null;
        private var _expected:int = 0;

        /** A receiver that hears of the end of one load may cancel the others. */
        [Test]
        public function cancelsWhileItCancels():void
        {
            _loader = new ModelLoader(this);
            for (var i:int = 0; i < 6; i++)
            {
                _loader.loadText(NAMES[i % 2], "v 0 0 0");
            }
            assertEquals(6, _expected);
            _loader.cancel(NAMES[0]);
            assertEquals(0, _expected);
            assertEquals(0, _loader.pendingCount);
            assertFalse(_loader.isPending(NAMES[1]));
        }

        public function expect(name:String):void
        {
            _expected++;
        }

        public function expectNoMore(name:String):void
        {
            _expected--;
            _loader.cancel();
        }

        public function receive(model:Model):Steps
        {
            return null;
        }

        [Test]
        public function isEmptyAtFirst():void
        {
            var queue:LoadQueue = new LoadQueue();
            assertNull(queue.first);
            assertEquals(0, queue.count);
            assertFalse(queue.has("toString"));
            assertEquals(0, queue.newestFirst(null).length + queue.newestFirst("toString").length);
            assertFalse(queue.remove(loadOf("bear")));
        }

        /** Loads that come and go in any order are as in a list. */
        [Test]
        public function isAsAList():void
        {
            var random:SeededRandom = new SeededRandom(70);
            var queue:LoadQueue = new LoadQueue();
            var list:Vector.<ModelLoad> = new Vector.<ModelLoad>();
            var most:int = 0;
            for (var i:int = 0; i < 600; i++)
            {
                if (list.length == 0 || random.chance(i % 100 < 50 ? 0.7 : 0.3))
                {
                    list.push(loadOf(NAMES[random.integer(0, NAMES.length - 1)]));
                    queue.add(list[int(list.length - 1)]);
                }
                else
                {
                    var gone:ModelLoad = list.splice(random.integer(0, list.length - 1), 1)[0];
                    assertTrue(queue.remove(gone));
                    assertFalse("it is gone", queue.remove(gone));
                }
                most = Math.max(most, list.length);
                check(queue, list);
            }
            assertTrue(most > 15);
        }

        private static function check(queue:LoadQueue, list:Vector.<ModelLoad>):void
        {
            assertEquals(list.length, queue.count);
            var next:ModelLoad = queue.first;
            for each (var load:ModelLoad in list)
            {
                assertTrue(load === next);
                next = next.next;
            }
            assertNull(next);
            assertSame(list, queue.newestFirst(null));
            for each (var name:String in NAMES)
            {
                var named:Vector.<ModelLoad> = list.filter(function(one:ModelLoad, index:int, all:Vector.<ModelLoad>):Boolean
                    {
                        return one.name == name;
                    });
                assertEquals(named.length > 0, queue.has(name));
                assertSame(named, queue.newestFirst(name));
            }
        }

        private static function assertSame(oldestFirst:Vector.<ModelLoad>, newestFirst:Vector.<ModelLoad>):void
        {
            assertEquals(oldestFirst.length, newestFirst.length);
            for (var i:int = 0; i < oldestFirst.length; i++)
            {
                assertTrue(oldestFirst[i] === newestFirst[newestFirst.length - 1 - i]);
            }
        }

        private static function loadOf(name:String):ModelLoad
        {
            return new ModelLoad(name, "z", Model.FOOTPRINT, new GreatLand(), null);
        }
    }
}
