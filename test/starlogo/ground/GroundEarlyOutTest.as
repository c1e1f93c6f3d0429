package starlogo.ground
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Hull;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import support.Complaints;
    import support.Effort;
    import support.RandomGround;
    import support.fillHeights;
    import support.landOf;

    use namespace engine;

    /** The quick answers about structures and the ground are those of the full test. */
    public class GroundEarlyOutTest
    {
        private var _random:SeededRandom = new SeededRandom(1207);
        private var _structures:RandomStructures = new RandomStructures(_random);
        private var _extents:GroundBox = new GroundBox();
        private var _numbers:Vector.<Number> = new Vector.<Number>(6, true);
        private var _earlyOut:GroundEarlyOut = new GroundEarlyOut();
        private var _query:GroundModelQuery = new GroundModelQuery();
        private var _placement:Placement = new Placement();

        [Test]
        public function answersAreThoseOfTheFullTest():void
        {
            var wrong:Complaints = new Complaints();
            var counts:Vector.<int> = new <int>[0, 0, 0];
            var count:int = Effort.choose(1000, 30000, 300);
            for (var i:int = 0; i < count; i++)
            {
                var kind:String = RandomGround.KINDS[i % RandomGround.KINDS.length];
                var terrain:Terrain = RandomGround.make(kind, _random);
                for (var k:int = 0; k < 10; k++)
                {
                    var size:Number = terrain.cellWidth * _random.logBetween(0.1, 20);
                    var structure:BoundingStructure = k % 5 == 4 ? thinHull(size) : _structures.ofKind(k % 5, size, size);
                    _placement.x = terrain.x + _random.between(-0.1, 1.1) * terrain.columns * terrain.cellWidth;
                    _placement.y = terrain.y + _random.between(-0.1, 1.1) * terrain.rows * terrain.cellWidth;
                    var high:Number = terrain.heightAt(_placement.x, _placement.y);
                    _placement.z = (high == high ? high : 0) + _random.between(-1.5, 1.5) * size;
                    var found:int = answerTo(terrain, structure);
                    var expected:Boolean = _query.areTouchingAt(RelativeMotion.NONE, 0);
                    counts[found]++;
                    wrong.addIf(found == (expected ? GroundEarlyOut.APART : GroundEarlyOut.TOUCHING), structure.toString().split(" ")[1] + (expected ? " apart" : " touching"), kind + " " + i + ", " + structure);
                }
            }
            wrong.assertNone();
            assertTrue("answers: " + counts, Math.min(counts[0], Math.min(counts[1], counts[2])) > count / 4);
        }

        // On level ground, whatever its height. Rounding alone would part some of them from it.
        [Test]
        public function whatStandsOnLevelGroundTouchesIt():void
        {
            var apart:Complaints = new Complaints();
            for each (var kind:String in ["cube", "sphere"])
            {
                var shape:BoundingStructure = landOf(BuiltInModel.cube(), BuiltInModel.sphere()).boundingStructures.tightestFit(kind);
                for each (var far:Number in [0, 1000])
                {
                    for (var tenths:int = -9; tenths <= 9; tenths++)
                    {
                        var terrain:Terrain = new Terrain(8, 8, 1, far, far);
                        fillHeights(terrain, function(column:int, row:int):Number
                            {
                                return tenths * 0.1;
                            });
                        for (var size:int = 1; size < 12; size++)
                        {
                            _placement.x = far + 3.3;
                            _placement.y = far + 3.4;
                            _placement.z = tenths * 0.1;
                            _placement.size = size * 0.1;
                            apart.addIf(answerTo(terrain, shape) == GroundEarlyOut.APART, kind, [far, tenths, size].join());
                        }
                    }
                }
            }
            apart.assertNone();
        }

        // A spike under the middle of a tetrahedron's extents, which is outside of it.
        [Test]
        public function theMiddleOfAHullsExtentsMayBeOutsideOfIt():void
        {
            for each (var isBlocky:Boolean in [false, true])
            {
                var terrain:Terrain = new Terrain(21, 21, 0.05, 0, 0);
                terrain.isBlocky = isBlocky;
                fillHeights(terrain, function(column:int, row:int):Number
                    {
                        return column == 10 && row == 10 ? 0.7 : -10;
                    });
                var found:int = answerTo(terrain, new Hull(new <Number>[0, 0, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1]));
                assertEquals(isBlocky + ": " + found, false, _query.areTouchingAt(RelativeMotion.NONE, 0) || found == GroundEarlyOut.TOUCHING);
            }
        }

        // Sets the query to the structure too.
        private function answerTo(terrain:Terrain, structure:BoundingStructure):int
        {
            structure.findPlacedBox(_placement, _numbers);
            _extents.x = _numbers[0] + _placement.x;
            _extents.y = _numbers[1] + _placement.y;
            _extents.z = _numbers[2] + _placement.z;
            _extents.halfX = _numbers[3];
            _extents.halfY = _numbers[4];
            _extents.halfZ = _numbers[5];
            _query.setTo(terrain.grid, null, structure, _placement, 1, false);
            return _earlyOut.decide(terrain.grid, _extents, structure.kind);
        }

        private function thinHull(size:Number):Hull
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < 12; i++)
            {
                points.push(_random.between(-size, size));
            }
            return new Hull(points);
        }
    }
}
