package starlogo.search
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Breeds;
    import starlogo.engine;
    import support.assertThrows;

    use namespace engine;

    /** Pairs of breeds, compared with a list of them. */
    public class BreedInterestsTest
    {
        private var _random:SeededRandom = new SeededRandom(4810);
        private var _names:Array = [Breeds.TERRAIN, Breeds.EDGE];

        // Names all breeds, so all have their numbers.
        private var _numbers:BreedInterests = new BreedInterests();

        [Before]
        public function makeNames():void
        {
            for (var i:int = 0; i < 40; i++)
            {
                _names.push("interest " + i);
            }
            for each (var name:String in _names)
            {
                _numbers.add(name, _names[2]);
            }
        }

        [Test]
        public function thoseWithoutPairsIncludeNone():void
        {
            check(new BreedInterests(), []);
        }

        [Test]
        public function arePairsThatWereAdded():void
        {
            var including:int = 0;
            for (var game:int = 0; game < 12; game++)
            {
                var interests:BreedInterests = new BreedInterests();
                var added:Array = [];
                for (var count:int = 1; count < 70; count++)
                {
                    var pair:Array = [anyName(game), anyName(game)];
                    added.push(pair);
                    interests.add(pair[0], pair[1]);
                    including += count % 9 == 0 || count < 6 ? check(interests, added) : 0;
                }
            }
            assertTrue(including + " pairs", including > 5000);
        }

        [Test]
        public function mayBeThousands():void
        {
            var interests:BreedInterests = new BreedInterests();
            var names:Array = [];
            for (var i:int = 0; i < 3000; i++)
            {
                names.push("many " + i);
                interests.add(names[i], names[i - i % 64]);
                interests.add(names[i], names[0]);
            }
            for (i = 0; i < 20000; i++)
            {
                var a:int = _random.chance(0.2) ? 0 : _random.integer(0, 2999);
                var b:int = _random.chance(0.5) ? a - a % 64 : _random.integer(0, 2999);
                var expected:Boolean = a == 0 || b == 0 || a - a % 64 == b || b - b % 64 == a;
                assertEquals(a + ", " + b, expected, interests.includes(interests.indexOf(names[a]), interests.indexOf(names[b])));
            }
        }

        [Test]
        public function aNameThatIsNoneIsRefused():void
        {
            var interests:BreedInterests = new BreedInterests();
            for each (var name:String in [null, ""])
            {
                assertThrows(ArgumentError, /\bbreed must be (the name of a breed or ANY_BREED, not|a string, not null)/, interests.add, name, "b");
                assertThrows(ArgumentError, /\botherBreed must be (the name of a breed or ANY_BREED, not|a string, not null)/, interests.add, "b", name);
            }
            assertEquals(0, interests.pairCount);
        }

        // In some games only a few breeds are named.
        private function anyName(game:int):String
        {
            if (_random.chance(game % 3 == 0 ? 0.1 : 0))
            {
                return BreedInterests.ANY_BREED;
            }
            return _random.chance(0.1) ? _names[_random.integer(0, 1)] : _names[_random.integer(2, game % 2 == 0 ? 5 : 39)];
        }

        private function check(interests:BreedInterests, added:Array):int
        {
            var including:int = 0;
            var areAll:Boolean = true;
            for each (var a:String in _names)
            {
                for each (var b:String in _names)
                {
                    var expected:Boolean = isAdded(a, b, added);
                    assertEquals(a + ", " + b + " of " + added.join(" "), expected, interests.includes(interests.indexOf(a), interests.indexOf(b)));
                    assertEquals(a + ", " + b + " by numbers", expected, interests.includes(_numbers.indexOf(a), _numbers.indexOf(b)));
                    including += expected ? 1 : 0;
                    areAll = areAll && (expected || isFixture(a) || isFixture(b) || interests.indexOf(a) < 0 || interests.indexOf(b) < 0);
                }
            }
            assertEquals(added.join(" "), areAll, interests.includesAllOfAgents());
            return including;
        }

        private static function isAdded(a:String, b:String, added:Array):Boolean
        {
            for each (var pair:Array in added)
            {
                if (matches(pair[0], a) && matches(pair[1], b) || matches(pair[0], b) && matches(pair[1], a))
                {
                    return true;
                }
            }
            return false;
        }

        private static function matches(name:String, breed:String):Boolean
        {
            return name == breed || name == BreedInterests.ANY_BREED && !isFixture(breed);
        }

        private static function isFixture(breed:String):Boolean
        {
            return breed == Breeds.TERRAIN || breed == Breeds.EDGE;
        }
    }
}
