package starlogo.data
{
    import org.flexunit.asserts.assertEquals;

    public class LastAtMostTest
    {
        [Test]
        public function findsTheLastOfEqualNumbers():void
        {
            var numbers:Vector.<Number> = new <Number>[0, 1, 1, 4, 9];
            for each (var each:Array in [[-1, 0], [0, 0], [0.5, 0], [1, 2], [3, 2], [4, 3], [8.5, 3], [9, 4], [10, 4]])
            {
                assertEquals(each[0], each[1], lastAtMost(numbers, each[0]));
            }
            assertEquals(0, lastAtMost(new <Number>[5], 7));
        }
    }
}
