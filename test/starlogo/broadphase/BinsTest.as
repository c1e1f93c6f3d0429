package starlogo.broadphase
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.data.IntList;
    import starlogo.data.IntSet;

    /**
     * The bins alone, with extents that come from no agent. ChangedRowSearchTest and test/fuzz/kept.test.mjs compare whole frames in which few agents have
     * changed with those of a search of all rows.
     */
    public class BinsTest
    {
        private var _bins:Bins = new Bins();
        private var _sink:PairList = new PairList();
        private var _extents:Extents = new Extents();
        private var _rows:Vector.<int> = new Vector.<int>();

        [Test]
        public function findsThePairsWhoseCirclesOverlapOnce():void
        {
            var random:SeededRandom = new SeededRandom(501);
            var overlapping:int = 0;
            for (var world:int = 0; world < 60; world++)
            {
                clear();
                var spread:Number = random.logBetween(1, 1000);
                for (var i:int = 0; i < 60; i++)
                {
                    add(random.between(-spread, spread), random.between(-spread, spread), random.logBetween(0.01, 30), random.logBetween(0.01, 30));
                }
                overlapping += assertLikeBruteForce("world " + world);
            }
            assertTrue(overlapping + " overlap", overlapping > 1000 && overlapping < 60 * 60 * 59 / 4);
        }

        [Test]
        public function cellsThatShareABucketMixNothingUp():void
        {
            // wider than the numbers reach, so that cells far from each other have the same ones
            var random:SeededRandom = new SeededRandom(504);
            var overlapping:int = 0;
            for (var world:int = 0; world < 20; world++)
            {
                clear();
                for (var i:int = 0; i < 150; i++)
                {
                    var x:Number = random.integer(-200, 200);
                    var y:Number = random.integer(-200, 200);
                    add(x, y, 0.5, 0.5);
                    add(x + random.pick([-1, 0, 1, 0.5]), y + random.pick([-1, 0, 1, 0.5]), 0.5, random.pick([0.5, 0.5, 0.1, 3]));
                }
                overlapping += assertLikeBruteForce("world " + world);
            }
            assertTrue(overlapping + " overlap", overlapping > 1000);
        }

        [Test]
        public function thoseThatTouchByRoundingArePairs():void
        {
            // sums of tenths: the right end of one and the left end of the other are one number, but for rounding, on a border of cells
            var random:SeededRandom = new SeededRandom(502);
            for (var i:int = 0; i < 3000; i++)
            {
                clear();
                var half:Number = random.integer(1, 40) / 10;
                var border:Number = random.integer(-1000, 1000) * 16;
                add(border - half, 0, half, half);
                // one up to the border, the other beginning a last bit beyond it
                add(border * (1 + 2e-16) + half, 0, half, half);
                search();
                assertEquals(half + " at " + border, 1, _sink.length);
            }
        }

        [Test]
        public function thoseOfTheWidthOfACellThatTouchByRoundingArePairs():void
        {
            // the widest that a level takes, a little before a border and one width further: without slack two cells apart
            var random:SeededRandom = new SeededRandom(742);
            for (var i:int = 0; i < 3000; i++)
            {
                clear();
                var width:Number = Math.pow(2, random.integer(-8, 8));
                var column:int = random.integer(-1000, 1000);
                var line:int = random.integer(-1000, 1000);
                var gap:Number = width * random.logBetween(1e-11, 1e-7);
                var isAlongX:Boolean = random.chance();
                add(column * width - (isAlongX ? gap : 0), line * width - (isAlongX ? 0 : gap), width / 2, width / 2);
                add((column + (isAlongX ? 1 : 0)) * width, (line + (isAlongX ? 0 : 1)) * width, width / 2, width / 2);
                search();
                assertEquals(gap + " apart at " + column + ", " + line + " of " + width, 1, _sink.length);
            }
        }

        /** The widest members that a level takes: one ends a little before a border of cells, and the other begins there, hardly apart. */
        [Test]
        public function thoseOfTheWidthOfACellThatTouchByRoundingAreNear():void
        {
            var random:SeededRandom = new SeededRandom(743);
            for (var i:int = 0; i < 300; i++)
            {
                clear();
                var level:BinLevel = new BinLevel(Math.pow(2, random.integer(-8, 8)));
                var border:Number = random.integer(-1000, 1000) / level.cellsPerPatch;
                var gap:Number = level.slack * random.between(0.2, 0.9);
                var isAlongX:Boolean = random.chance();
                for each (var middle:Number in [border - gap / 2 - level.width, border + gap / 2])
                {
                    add(isAlongX ? middle : 0, isAlongX ? 0 : middle, level.width / 2, level.width / 2);
                    _extents.radiusXY[_rows.length - 1] = level.width / 2;
                }
                search();
                searchNear(0, 1);
                searchNear(1, 0);
                assertEquals(gap + " apart at " + border + ": of all, and of each", "0-1 0-1 1-0 1-1 ", _sink.order);
            }
        }

        [Test]
        public function rowsThatAreLeftOutAreNotNear():void
        {
            for (var i:int = 0; i < 4; i++)
            {
                add(i / 10, 0, 1, 1);
            }
            search();
            _sink.clear();
            searchNear(1, 3);
            assertEquals("1-3 ", _sink.order);
        }

        /** A row that the bins have sorted elsewhere, or not at all, is near members of finer and of coarser levels. */
        [Test]
        public function aRowThatHasMovedIsNearMembersOfAllLevels():void
        {
            var random:SeededRandom = new SeededRandom(744);
            for (var i:int = 0; i < 300; i++)
            {
                add(random.between(-20, 20), random.between(-20, 20), random.logBetween(0.001, 3), random.logBetween(0.001, 3));
            }
            search(299);
            var found:int = 0;
            for each (var half:Number in [0.001, 0.1, 2, 8, 100])
            {
                _extents.x[299] = random.between(-5, 5);
                _extents.halfX[299] = _extents.halfY[299] = half;
                _extents.radiusXY[299] = half * Math.SQRT2;
                _extents.assignLevel(299);
                _sink.clear();
                searchNear(299, 0);
                for (var other:int = 0; other < 299; other++)
                {
                    assertPair(half + " and " + other, 299, other);
                    found += _sink.count(299, other);
                }
            }
            assertTrue(found + " found", found > 300);
        }

        [Test]
        public function whatIsFarOutGetsWiderCells():void
        {
            add(0, 0, 0.5, 0.5);
            _extents.assignLevel(0);
            var near:int = _extents.levelIndices[0];
            _extents.x[0] = 1e12;
            _extents.assignLevel(0);
            assertTrue(_extents.levelIndices[0] != near);
            // far out the columns of the finer level would not fit an int
            add(1e12, 0.75, 0.5, 0.5);
            assertEquals(1, assertLikeBruteForce("far out"));
            _extents.x[0] = _extents.x[1] = 0;
            _extents.assignLevel(0);
            assertEquals("and back", near, _extents.levelIndices[0]);
        }

        [Test]
        public function levelsAreOfTheSizeOfTheirMembers():void
        {
            add(3, 4, 0.5, 0.5);
            _extents.assignLevel(0);
            var ofUnits:int = _extents.levelIndices[0];
            _extents.halfY[0] = 0.51;
            _extents.assignLevel(0);
            assertTrue(_extents.levelIndices[0] != ofUnits);
            _extents.halfY[0] = 0.26;
            _extents.assignLevel(0);
            assertEquals("and back", ofUnits, _extents.levelIndices[0]);
            _extents.halfX[0] = _extents.halfY[0] = _extents.x[0] = _extents.y[0] = 0;
            _extents.assignLevel(0);
            assertTrue("a point", _extents.levelIndices[0] != ofUnits);
        }

        [Test]
        public function aSinkThatThrowsLeavesTheNextSearchAsItShouldBe():void
        {
            add(0, 0, 1, 1);
            add(0.5, 0, 1, 1);
            add(0.5, 0.5, 4, 1);
            var thrown:Boolean = false;
            try
            {
                search();
                _bins.findPairs(_extents, firstRows(3), new PairSink());
            }
            catch (error:Error)
            {
                thrown = true;
            }
            assertTrue(thrown);
            assertEquals(3, assertLikeBruteForce("afterwards"));
        }

        private function clear():void
        {
            _extents = new Extents();
            _rows.length = 0;
        }

        private function add(x:Number, y:Number, halfX:Number, halfY:Number):void
        {
            var row:int = _extents.x.length;
            _extents.grow(row + 1);
            _extents.x[row] = x;
            _extents.y[row] = y;
            _extents.halfX[row] = halfX;
            _extents.halfY[row] = halfY;
            _extents.radiusXY[row] = Math.sqrt(halfX * halfX + halfY * halfY);
            _rows.push(row);
        }

        private function search(count:int = -1):void
        {
            _sink.clear();
            for each (var row:int in _rows)
            {
                _extents.assignLevel(row);
            }
            _sink.members = _rows;
            _bins.findPairs(_extents, firstRows(count < 0 ? _rows.length : count), _sink);
        }

        private function firstRows(count:int):IntList
        {
            var members:IntList = new IntList();
            members.values = _rows;
            members.count = count;
            return members;
        }

        // What is near a row, without rows that are less than another one. A row is near itself.
        private function searchNear(row:int, end:int):void
        {
            var leftOut:IntSet = new IntSet();
            leftOut.clear(_rows.length);
            for each (var other:int in _rows)
            {
                if (other < end)
                {
                    leftOut.add(other);
                }
            }
            _bins.findNear(row, _extents, leftOut, _sink);
        }

        // How many overlap, as all pairs and as what is near each row. A pair a hair's breadth apart may be found or not.
        private function assertLikeBruteForce(name:String):int
        {
            search();
            var overlapping:int = assertPairs(name);
            _sink.clear();
            for each (var row:int in _rows)
            {
                searchNear(row, row + 1);
            }
            assertEquals(overlapping, assertPairs(name + ", near each"));
            return overlapping;
        }

        private function assertPairs(name:String):int
        {
            var overlapping:int = 0;
            for (var i:int = 0; i < _rows.length; i++)
            {
                for (var j:int = i + 1; j < _rows.length; j++)
                {
                    overlapping += int(assertPair(name + ", " + i + " and " + j, _rows[i], _rows[j]));
                }
            }
            return overlapping;
        }

        // Whether the two overlap.
        private function assertPair(name:String, a:int, b:int):Boolean
        {
            var x:Number = _extents.x[a] - _extents.x[b];
            var y:Number = _extents.y[a] - _extents.y[b];
            var gapX:Number = Math.abs(x) - _extents.halfX[a] - _extents.halfX[b];
            var gapY:Number = Math.abs(y) - _extents.halfY[a] - _extents.halfY[b];
            var gap:Number = Math.sqrt(x * x + y * y) - _extents.radiusXY[a] - _extents.radiusXY[b];
            var found:int = _sink.count(a, b);
            var areOverlapping:Boolean = gapX <= 0 && gapY <= 0;
            if (areOverlapping)
            {
                assertEquals(name, 1, found);
            }
            else if (gap > 1e-2)
            {
                assertEquals(name, 0, found);
            }
            assertTrue(name + " twice", found <= 1);
            return areOverlapping;
        }
    }
}

import starlogo.broadphase.BinLevel;
import starlogo.broadphase.PairSink;

/** Notes the pairs of rows. */
class PairList extends PairSink
{
    public var length:int = 0;

    /** The pairs as numbers of members, in the order in which they came. */
    public var order:String = "";

    /** The rows of the search. */
    public var members:Vector.<int>;

    private var _pairs:Object = {};

    override public function onCandidates(row:int, others:Vector.<int>, count:int, level:BinLevel):void
    {
        for (var i:int = 0; i < count; i++)
        {
            length++;
            var key:String = keyOf(row, others[i]);
            _pairs[key] = int(_pairs[key]) + 1;
            order += members.indexOf(row) + "-" + members.indexOf(others[i]) + " ";
        }
    }

    public function count(a:int, b:int):int
    {
        return _pairs[keyOf(a, b)];
    }

    public function clear():void
    {
        length = 0;
        order = "";
        _pairs = {};
    }

    private static function keyOf(a:int, b:int):String
    {
        return Math.min(a, b) + " " + Math.max(a, b);
    }
}
