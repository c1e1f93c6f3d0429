package starlogo.broadphase
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import starlogo.data.IntList;
    import starlogo.data.IntSet;

    /** What is near single rows. ChangedRowsTest and test/fuzz/kept.test.mjs compare whole frames with those of a search of all rows. */
    public class CellListsTest
    {
        private static const PAIRS:int = 300;

        /** The widest members that a level takes: one ends a little before a border of cells, and the other begins there, hardly apart. */
        [Test]
        public function thoseOfTheWidthOfACellThatTouchByRoundingAreNear():void
        {
            var random:SeededRandom = new SeededRandom(743);
            for (var i:int = 0; i < PAIRS; i++)
            {
                var level:BinLevel = new BinLevel(Math.pow(2, random.integer(-8, 8)));
                var border:Number = random.integer(-1000, 1000) / level.cellsPerPatch;
                var gap:Number = level.slack * random.between(0.2, 0.9);
                assertNear(border - gap / 2 - level.width, border + gap / 2, level.width, random.chance());
            }
        }

        // Whether each of two squares is near the other one, if the first is at an x or y, and the second at another.
        private static function assertNear(first:Number, second:Number, width:Number, isAlongX:Boolean):void
        {
            var extents:Extents = new Extents();
            var members:IntList = new IntList();
            extents.grow(2);
            (isAlongX ? extents.x : extents.y)[0] = first;
            (isAlongX ? extents.x : extents.y)[1] = second;
            for (var row:int = 0; row < 2; row++)
            {
                extents.halfX[row] = extents.halfY[row] = extents.radiusXY[row] = width / 2;
                extents.assignLevel(row);
                members.add(row);
            }
            var bins:Bins = new Bins();
            var sink:NearRows = new NearRows();
            bins.findPairs(extents, members, sink);
            var lists:CellLists = new CellLists(bins.levels);
            lists.begin(extents, members, 2);
            var none:IntSet = new IntSet();
            none.clear(2);
            lists.findNear(0, none, sink);
            lists.findNear(1, none, sink);
            assertEquals(first + " and " + second + ": the bins, and the lists of each", "0 1, 0 1, 1 0", sink.found.join(", "));
        }
    }
}

import starlogo.broadphase.BinLevel;
import starlogo.broadphase.PairSink;

/** Notes each row with one that is near. */
class NearRows extends PairSink
{
    public var found:Array = [];

    override public function onCandidates(row:int, others:Vector.<int>, count:int, level:BinLevel):void
    {
        for (var i:int = 0; i < count; i++)
        {
            found.push(row + " " + others[i]);
        }
    }
}
