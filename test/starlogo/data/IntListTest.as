package starlogo.data
{
    import org.flexunit.asserts.assertEquals;

    public class IntListTest
    {
        private var _list:IntList = new IntList();

        [Before]
        public function fill():void
        {
            for each (var number:int in [3, -1, 4, -1, 5])
            {
                _list.add(number);
            }
        }

        [Test]
        public function aCopyHasEveryNumber():void
        {
            var copy:IntList = new IntList();
            copy.copyFrom(_list);
            assertEquals("3,-1,4,-1,5", textOfList(copy));
        }

        [Test]
        public function whatIsRemovedIsNowhereAndTheOthersKeepTheirOrder():void
        {
            var copy:IntList = new IntList();
            copy.copyExcept(_list, 4);
            assertEquals("3,-1,-1,5", textOfList(copy));
            _list.remove(-1);
            assertEquals("3,4,5", textOfList(_list));
        }

        private static function textOfList(list:IntList):String
        {
            return list.values.slice(0, list.count).join();
        }
    }
}
