package starlogo.data
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    /** A hash table, compared with an object that has a property for each pair of keys. */
    public class IntPairMapTest
    {
        [Test]
        public function hasWhatAnObjectHas():void
        {
            var random:SeededRandom = new SeededRandom(811);
            var table:IntPairMap = new IntPairMap();
            var known:Object = {};
            var found:int = 0;
            for (var i:int = 0; i < 6000; i++)
            {
                if (i % 2000 == 1999)
                {
                    table.clear();
                    known = {};
                }
                // few keys, which are near one another, and large and negative ones
                var first:int = random.pick([random.integer(-3, 20), random.integer(0, 3), 2000000000, 1 << 16]);
                var second:int = random.pick([0, random.integer(-3, 20), 65536 * random.integer(0, 5)]);
                var key:String = first + " " + second;
                found += key in known ? 1 : 0;
                assertEquals(key, key in known ? known[key] : -1, table.find(first, second));
                if (random.chance(0.6))
                {
                    assertEquals(key, key in known ? known[key] : -1, table.set (first, second, i));
                    known[key] = i;
                }
                else
                {
                    table.remove(first, second);
                    delete known[key];
                }
            }
            for (key in known)
            {
                assertEquals(key, known[key], table.find(int(key.split(" ")[0]), int(key.split(" ")[1])));
            }
            assertTrue(found + " found", found > 1500);
        }
    }
}
