package starlogo.ground
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxTree;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.terrain.Terrain;
    import support.Complaints;
    import support.Effort;
    import support.RandomGround;
    import support.assertClose;
    import support.fillHeights;

    use namespace engine;

    /** A sweep of a model and the ground keeps to the times that count. The point of an overlap is in both. */
    public class GroundModelQueryTest
    {
        private static const KINDS:Array = ["rough", "steps", "hills"];

        // The triangles of a box whose corners have a bit for each axis.
        private static const BAR:Vector.<uint> = new <uint>[0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5];

        private var _random:SeededRandom = new SeededRandom(2139);
        private var _structures:RandomStructures = new RandomStructures(_random);
        private var _wrong:Complaints = new Complaints();
        private var _query:GroundModelQuery = new GroundModelQuery();
        private var _out:ContactPoint = new ContactPoint();

        // The ground, and a structure that overlaps it.
        private var _terrain:Terrain;
        private var _structure:BoundingStructure;
        private var _placement:Placement = new Placement();
        private var _maxDistance:Number = 0;

        // Until shortly before the touch there is none; until shortly after it, and from shortly before it on, there is the same.
        [Test]
        public function aSweepKeepsToTheTimesThatCount():void
        {
            var met:int = 0;
            for (var i:int = 0; met < Effort.choose(200, 4000, 60); i++)
            {
                makeOverlap(i);
                var down:RelativeMotion = new RelativeMotion();
                down.endAfter(_random.between(-1, 1) * _maxDistance, _random.between(-1, 1) * _maxDistance, -10 * _maxDistance);
                setQuery();
                if (_query.areTouchingAt(down, 0))
                {
                    continue;
                }
                _query.findImpactOfSurfaces(down, _out);
                var time:Number = down.time;
                if (!(time > 0.02 && time < 0.98))
                {
                    continue;
                }
                met++;
                down.latestTime = time - 0.01;
                _query.findImpactOfSurfaces(down, _out);
                _wrong.addIf(down.time != RelativeMotion.NEVER, "a touch after the latest time", i + ": " + down.time);
                down.latestTime = time + 0.01;
                _query.findImpactOfSurfaces(down, _out);
                _wrong.addIf(!(Math.abs(down.time - time) < 1e-9), "until a latest time", i + ": " + down.time + " instead of " + time);
                down.earliestTime = time - 0.01;
                _query.findImpactOfSurfaces(down, _out);
                _wrong.addIf(!(Math.abs(down.time - time) < 1e-9), "from an earliest time on", i + ": " + down.time + " instead of " + time);
            }
            _wrong.assertNone();
        }

        [Test]
        public function thePointOfAnOverlapIsInBoth():void
        {
            var points:ClosestPoints = new ClosestPoints();
            var onSurface:int = 0;
            for (var i:int = 0; i < Effort.choose(400, 8000, 100); i++)
            {
                makeOverlap(i);
                setQuery();
                _query.findClosest(true, points);
                var slack:Number = 1e-9 * (_maxDistance + Math.abs(_placement.z));
                var height:Number = heightAround(points.a.x, points.a.y, slack);
                var placed:BoundingStructure = _structure.place(_placement);
                placed.widen(slack);
                onSurface += height - points.a.z < slack ? 1 : 0;
                _wrong.addIf(points.distance != 0 || points.a.z != points.b.z, "distance", i + ": " + points.distance);
                _wrong.addIf(!(points.a.z <= height + slack), "above the ground", i + ", " + _structure + ": " + points.a.z + " above " + height);
                _wrong.addIf(!placed.contains(points.a), "outside", i + ", " + _structure);
            }
            _wrong.assertNone();
            assertTrue(onSurface > 0);
        }

        // Large structures are tested against fewer squares than small ones.
        [Test]
        public function structuresOfAllSizesTouchAcrossTheWholeGap():void
        {
            for each (var far:Number in [0, 1e5, 1e6])
            {
                _terrain = new Terrain(101, 101, 1, far - 50, far - 50);
                for each (var half:Number in [0.25, 1, 1.45, 1.75, 5, 50, 5000])
                {
                    var ball:Sphere = new Sphere(new Vector3D(), half);
                    var box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, half, half, half);
                    var place:Number = 2 * Tolerances.PLACES * (2 * far + half);
                    checkGap(ball, far, half, place + (Tolerances.TOUCHING - 1) * half);
                    checkGap(box, far, half, place);
                }
            }
        }

        private function checkGap(structure:BoundingStructure, far:Number, half:Number, gap:Number):void
        {
            _structure = structure;
            _placement.x = _placement.y = far;
            _placement.z = half + 0.99 * gap;
            setQuery();
            assertTrue(structure + " at " + far, _query.areTouchingAt(RelativeMotion.NONE, 0));
        }

        // The margin of a steep triangle is that of its height, and may be larger than that of a cell.
        [Test]
        public function aSteepSlopeIsTouchedAcrossItsWholeMargin():void
        {
            var height:Number = 1e6;
            for each (var cells:int in [4, 100])
            {
                for each (var radius:Number in cells == 4 ? [1e-3, 0.5] : [1e-3, 0.5, 10])
                {
                    _terrain = new Terrain(cells, cells, 1, 1 - cells / 2, 0);
                    fillHeights(_terrain, function(column:int, row:int):Number
                        {
                            return column < cells / 2 ? 0 : height;
                        });
                    _structure = new Sphere(new Vector3D(), radius);
                    _placement.y = cells / 2 - 0.4;
                    _placement.z = radius + 1e-3;
                    for each (var margins:Number in [0.1, 0.5, 0.9, 1.1])
                    {
                        // the slope rises from x = 0 on
                        _placement.x = _placement.z / height - radius - margins * Tolerances.SURFACES * height;
                        setQuery();
                        assertEquals(cells + " " + radius + " " + margins, margins < 1, _query.areTouchingAt(RelativeMotion.NONE, 0));
                    }
                }
            }
        }

        // Two bars stick in the side of a column. The one that is deepest counts, whether it comes first or last.
        [Test]
        public function theDeepestPieceCountsInAnyOrder():void
        {
            _terrain = new Terrain(81, 41, 1, -40, -20);
            _terrain.isBlocky = true;
            for (var column:int = 40; column < 81; column++)
            {
                for (var row:int = 0; row < 41; row++)
                {
                    _terrain.setHeight(column, row, 40);
                }
            }
            for each (var lengths:Array in [[6, 7.5], [7.5, 6]])
            {
                var library:HierarchiesLibrary = new HierarchiesLibrary();
                library.add("bars", bar(-4, lengths[0]).concat(bar(4, lengths[1])), BAR.concat(
                            BAR.map(function(corner:uint, i:int, all:Vector.<uint>):uint
                                {
                                    return corner + 8;
                                })));
                _placement.x = _placement.y = 0;
                _placement.z = 10;
                for each (var isExact:Boolean in [false, true])
                {
                    _query.setTo(_terrain.grid, library.treeOf("bars"), library.root("bars").bounds, _placement, isExact ? BoxTree.EXACT : 5);
                    _query.findContact(RelativeMotion.NONE, _out);
                    assertClose(8, _out.depth, 1e-9, lengths + " " + isExact);
                }
            }
        }

        // The corners of a bar along x, up to so far behind the side of the columns, which is at -0.5.
        private static function bar(y:Number, length:Number):Vector.<Number>
        {
            var corners:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < 8; i++)
            {
                corners.push((i & 1) == 0 ? -1 : length, y + ((i & 2) == 0 ? -1 : 1), (i & 4) == 0 ? -0.5 : 0.5);
            }
            return corners;
        }

        // The greatest height of the ground near a place: there, because it may be on a ridge, and around it, because it may be the side of a column
        // or the ground's border.
        private function heightAround(x:Number, y:Number, slack:Number):Number
        {
            var greatest:Number = -Infinity;
            for each (var away:Array in [[0, 0], [-1, -1], [1, -1], [-1, 1], [1, 1]])
            {
                var height:Number = _terrain.heightAt(x + away[0] * slack, y + away[1] * slack);
                greatest = height > greatest ? height : greatest;
            }
            return greatest;
        }

        private function makeOverlap(i:int):void
        {
            do
            {
                _terrain = RandomGround.make(KINDS[i % KINDS.length], _random);
                _maxDistance = _terrain.cellWidth * _random.logBetween(0.3, 2);
                _structure = _structures.ofKind(i % 4, _maxDistance, 0);
                _placement.x = _terrain.x + _random.between(0.2, 0.8) * _terrain.columns * _terrain.cellWidth;
                _placement.y = _terrain.y + _random.between(0.2, 0.8) * _terrain.rows * _terrain.cellWidth;
                _placement.z = _terrain.heightAt(_placement.x, _placement.y) + _random.between(-1.5, 0.5) * _maxDistance;
                setQuery();
            }
            while (!_query.areTouchingAt(RelativeMotion.NONE, 0));
        }

        private function setQuery():void
        {
            _query.setTo(_terrain.grid, null, _structure, _placement, 1);
        }
    }
}
