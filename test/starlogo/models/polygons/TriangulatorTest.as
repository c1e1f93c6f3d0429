package starlogo.models.polygons
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.models.files.FileBudget;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;
    import support.Effort;
    import support.Surfaces;
    import support.TurnedPlane;

    public class TriangulatorTest
    {
        private static const SQUARE:Array = [[0, 0], [4, 0], [4, 4], [0, 4]];

        [Test]
        public function coversRandomStars():void
        {
            var random:SeededRandom = new SeededRandom(21);
            for (var i:int = 0; i < Effort.choose(80, 300); i++)
            {
                var star:Array = [];
                var inner:Array = [];
                var corners:int = random.integer(5, 40);
                for (var corner:int = 0; corner < corners; corner++)
                {
                    var angle:Number = 2 * Math.PI * corner / corners;
                    var radius:Number = random.between(1, 3);
                    star.push([radius * Math.cos(angle), radius * Math.sin(angle)]);
                    radius = random.between(0.1, 0.9) * Math.cos(Math.PI / corners);
                    inner.push([radius * Math.cos(angle), radius * Math.sin(angle)]);
                }
                check("star " + i, area(star), [star]);
                check("star with a hole " + i, area(star) - area(inner), [star, inner]);
            }
        }

        [Test]
        public function leavesRandomHolesOpen():void
        {
            var random:SeededRandom = new SeededRandom(77);
            for (var i:int = 0; i < 100; i++)
            {
                var loops:Array = [SQUARE.concat()];
                var expected:Number = 16;
                for (var cell:int = 0; cell < 16; cell++)
                {
                    if (random.chance(0.6))
                    {
                        var star:Array = starIn(cell % 4 + 0.5, int(cell / 4) + 0.5, random);
                        expected -= area(star);
                        loops.push(random.chance() ? star : star.reverse());
                    }
                }
                check("holes " + i, expected, loops);
            }
        }

        private static function starIn(x:Number, y:Number, random:SeededRandom):Array
        {
            var star:Array = [];
            var corners:int = random.integer(3, 9);
            for (var i:int = 0; i < corners; i++)
            {
                var radius:Number = random.between(0.1, 0.49);
                var angle:Number = 2 * Math.PI * i / corners;
                star.push([x + radius * Math.cos(angle), y + radius * Math.sin(angle)]);
            }
            return star;
        }

        /** An arrow is cut along the diagonal inside it, whatever its size. */
        [Test]
        public function cutsQuadsOfAnySize():void
        {
            for each (var size:Number in [1, 1e-70, 1e-82, 1e-100, 1e-150, 1e77, 1e80, 1e150])
            {
                var vertices:Vector.<Number> = new <Number>[0, 0, 0, size, size, 0, 0.3 * size, 0, 0, size, -size, 0];
                var triangles:Vector.<uint> = new Vector.<uint>();
                new Triangulator(new FileBudget("a", 0), vertices, triangles).addPolygon(new <uint>[1, 0, 3, 2]);
                assertEquals("size " + size, "1,0,2,0,3,2", triangles.join());
            }
        }

        /** In a plane that leans, corners in a line are beside it by rounding. Every cut must have them on the same side. */
        [Test]
        public function coversStepsInLeaningPlanes():void
        {
            const STEPS:Array = [[0, 3], [1, 3], [1, 1], [2, 1], [2, 2], [3, 2], [3, 1], [4, 1], [4, 0], [3, 0], [2, 0], [1, 0], [0, 0]];
            var random:SeededRandom = new SeededRandom(5);
            for (var i:int = 0; i < 400; i++)
            {
                var u:Vector3D = new Vector3D(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
                var v:Vector3D = new Vector3D(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
                var vertices:Vector.<Number> = new Vector.<Number>();
                var corners:Vector.<uint> = new Vector.<uint>();
                for each (var corner:Array in STEPS)
                {
                    corners.push(vertices.length / 3);
                    vertices.push(corner[0] * u.x + corner[1] * v.x + 0.3, corner[0] * u.y + corner[1] * v.y, corner[0] * u.z + corner[1] * v.z - 0.7);
                }
                var triangles:Vector.<uint> = new Vector.<uint>();
                cut(vertices, triangles, new <Vector.<uint>>[corners]);
                var part:Number = Surfaces.area(vertices, triangles) / u.crossProduct(v).length;
                assertTrue("plane " + i + ": area " + part + ", not 7", Math.abs(part - 7) < 1e-9);
            }
        }

        /** Corners of several holes are in lines with each other. Bridges go to the same corner, and along sides of holes. */
        [Test]
        public function leavesHolesInLinesOpen():void
        {
            const HOLES:Array = [[[0, 0], [2, 0], [2, 2], [0, 2]], [[0, 0], [2, 0], [0, 2]], [[0, 0], [2, 2], [0, 2]], [[1, 0], [2, 1], [1, 2], [0, 1]],
                    [[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 0], [1, 0], [2, 0], [2, 2], [0, 2]]];
            var random:SeededRandom = new SeededRandom(6);
            for (var i:int = 0; i < 200; i++)
            {
                var loops:Array = [[[0, 0], [12, 0], [24, 0], [24, 12], [24, 24], [12, 24], [0, 24], [0, 12]]];
                var expected:Number = 576;
                for (var cell:int = 0; cell < 49; cell++)
                {
                    if (random.chance(0.2))
                    {
                        var hole:Array = [];
                        for each (var corner:Array in random.pick(HOLES))
                        {
                            hole.push([1 + 3 * (cell % 7) + corner[0], 1 + 3 * int(cell / 7) + corner[1]]);
                        }
                        expected -= area(hole);
                        loops.push(random.chance() ? hole : hole.reverse());
                    }
                }
                check("holes in lines " + i, expected, loops);
            }
        }

        /** Holes begin where others pass, or touch them in two corners, and close in a part of the inside. The sides are sides of squares. */
        [Test]
        public function leavesHolesThatTouchInCornersOpen():void
        {
            const SQUARE_HOLE:Array = [[3, 4], [4, 4], [4, 3], [3, 3]];
            const STAIRS:Array = [[2, 4], [1, 4], [1, 2], [2, 2], [2, 1], [4, 1], [4, 2], [3, 2], [3, 3], [2, 3]];
            const BENT:Array = [[3, 2], [2, 2], [2, 3], [1, 3], [1, 1], [3, 1]];
            const BENT_BACK:Array = [[2, 3], [3, 3], [3, 2], [4, 2], [4, 4], [2, 4]];
            for each (var pair:Array in [[SQUARE_HOLE, STAIRS], [BENT, BENT_BACK]])
            {
                var expected:Number = 30 - Math.abs(area(pair[0])) - Math.abs(area(pair[1]));
                for (var i:int = 0; i < pair[0].length * pair[1].length; i++)
                {
                    var loops:Array = [[[0, 0], [6, 0], [6, 5], [0, 5]], turned(pair[0], i % pair[0].length), turned(pair[1], i / pair[0].length)];
                    check("holes that touch " + i, expected, loops);
                    check("in the other order " + i, expected, [loops[0], loops[2], loops[1]]);
                }
            }
        }

        [Test]
        public function leavesAHoleThatTouchesTheOutlineOpen():void
        {
            const OUTLINE:Array = [[4, 1], [3, 1], [3, 0], [2, 0], [2, 1], [1, 1], [1, 2], [2, 2], [2, 3], [1, 3], [1, 4], [4, 4], [4, 3], [5, 3], [5, 2], [4, 2]];
            const HOLE:Array = [[2, 1], [3, 1], [3, 2], [2, 2]];
            for (var i:int = 0; i < OUTLINE.length * HOLE.length; i++)
            {
                check("touching " + i, 9, [turned(OUTLINE, i % OUTLINE.length), turned(HOLE, i / OUTLINE.length)]);
            }
        }

        /** Doors that stand on the floor, and tips and other holes on a side of the outline or of a hole; on each of the four sides. */
        [Test]
        public function leavesHolesOnOneSideOpen():void
        {
            const HOLES:Array = [
                    [[[1, 0], [3, 0], [3, 2], [1, 2]], [[5, 0], [7, 0], [7, 3], [5, 3]]],
                    [[[2, 0], [1, 3], [3, 2]], [[6, 0], [5, 3], [7, 3]], [[4, 0], [4, 2], [5, 2]]],
                    [[[2, 5], [6, 5], [6, 6], [2, 6]], [[2, 5], [2, 3], [3, 3]], [[5, 5], [4, 3], [5, 2]], [[5, 5], [6, 3], [6, 5]]],
                    [[[8, 3], [6, 2], [6, 3]], [[8, 3], [6, 3], [6, 4]], [[8, 6], [7, 4], [6, 4]]]];
            for each (var holes:Array in HOLES)
            {
                for (var i:int = 0; i < 24; i++)
                {
                    var loops:Array = [[[0, 0], [8, 0], [8, 8], [0, 8]]];
                    var expected:Number = 64;
                    for each (var hole:Array in i % 2 == 0 ? holes : holes.concat().reverse())
                    {
                        expected -= Math.abs(area(hole));
                        var placed:Array = turned(hole, i % hole.length);
                        for (var side:int = 0; side < i % 4; side++)
                        {
                            placed = placed.map(function(corner:Array, index:int, all:Array):Array
                                {
                                    return [8 - corner[1], corner[0]];
                                });
                        }
                        loops.push(placed);
                    }
                    check("holes " + loops.join("; "), expected, loops);
                }
            }
        }

        /** Their coordinates are exact, so the sides of the hole are exactly on the slanted ones. */
        [Test]
        public function leavesHolesOnSlantedSidesOpen():void
        {
            const WALL:Array = [[4, 0], [0, 0], [0, 6], [4, 6]];
            for each (var hole:Array in [[[0, 2], [0, 1], [2, 1], [2, 2]], [[4, 2], [4, 4], [3, 3]], [[1, 1], [0, 3], [1, 4]]])
            {
                var loops:Array = [];
                for each (var loop:Array in [WALL, hole])
                {
                    loops.push(loop.map(function(corner:Array, index:int, all:Array):Array
                            {
                                return [corner[0] + corner[1] / 2, corner[1]];
                            }));
                }
                assertEquals("hole " + hole.join("; "), 24 - Math.abs(area(hole)), run(loops, new TurnedPlane()));
            }
        }

        /** A square of 9 with two triangular holes that touch in a corner, and a hole like a diamond, in a plane that leans, as a file writes it. */
        [Test]
        public function leavesRoundedHolesThatTouchOpen():void
        {
            var vertices:Vector.<Number> = new <Number>[0.3, -0.7, -0.7, 8.151412, 3.596835, -1.644743, 12.52673, -3.827065, 0.9518594, 4.675314, -8.123899, 1.896603,
                    2.917137, 0.7322783, -1.014914, 6.992712, -0.3100766, -0.4642946, 5.534275, 2.164557, -1.329829,
                    5.834013, -4.216988, 0.716154, 4.375576, -1.742355, -0.1493802, 6.992712, -0.3100766, -0.4642946,
                    6.320159, -5.041866, 1.004665, 7.678684, -5.389318, 1.188205, 8.064918, -4.087014, 0.7947224, 6.706392, -3.739562, 0.6111825];
            var triangles:Vector.<uint> = new Vector.<uint>();
            cut(vertices, triangles, new <Vector.<uint>>[new <uint>[0, 1, 2, 3], new <uint>[4, 5, 6], new <uint>[7, 8, 9], new <uint>[10, 11, 12, 13]]);
            assertTrue("area " + Surfaces.area(vertices, triangles), Math.abs(Surfaces.area(vertices, triangles) - 70) < 1e-4);
        }

        [Test]
        public function cutsPolygonsOfAnySize():void
        {
            for each (var size:Number in [4e-320, 1e-309, 1e-300, 1, 1e300, 4e307])
            {
                var vertices:Vector.<Number> = new <Number>[0, 0, 0, 4 * size, 0, 0, 4 * size, 3 * size, 0, 2 * size, size, 0, 0, 3 * size, 0];
                var triangles:Vector.<uint> = new Vector.<uint>();
                cut(vertices, triangles, new <Vector.<uint>>[new <uint>[0, 1, 2, 3, 4]]);
                assertEquals("size " + size, 9, triangles.length);
            }
        }

        // A loop that begins at another corner.
        private static function turned(loop:Array, first:int):Array
        {
            return loop.slice(first).concat(loop.slice(0, first));
        }

        [Test]
        public function cutsLargePolygonsInPieces():void
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var corners:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < 600; i++)
            {
                var radius:Number = 1 + 0.5 * (i & 1);
                vertices.push(radius * Math.cos(2 * Math.PI * i / 600), radius * Math.sin(2 * Math.PI * i / 600), 0);
                corners.push(i);
            }
            var triangles:Vector.<uint> = new Vector.<uint>();
            var triangulator:Triangulator = new Triangulator(new FileBudget("polygons", 250000), vertices, triangles);
            var work:Steps = new StepSequence().beginEach(1, function(index:int):Steps
                {
                    return triangulator.addPolygon(corners);
                });
            var pieces:int = 1;
            while (work.step())
            {
                pieces++;
            }
            assertTrue("pieces: " + pieces, pieces > 5);
            assertEquals(3 * 598, triangles.length);
        }

        /** A grid of holes, in a file that has just the bytes for them. */
        [Test]
        public function leavesManyHolesOpen():void
        {
            var loops:Vector.<Vector.<uint>> = new Vector.<Vector.<uint>>();
            var vertices:Vector.<Number> = new Vector.<Number>();
            addLoop([[0, 0], [13, 0], [13, 13], [0, 13]], loops, vertices);
            for (var i:int = 0; i < 169; i++)
            {
                var x:Number = int(i / 13) + 0.5;
                var y:Number = i % 13 + 0.5;
                addLoop([[x + 0.29, y + 0.09], [x - 0.09, y + 0.29], [x - 0.29, y - 0.09], [x + 0.09, y - 0.29]], loops, vertices);
            }
            var triangles:Vector.<uint> = new Vector.<uint>();
            cut(vertices, triangles, loops, 15500);
            var found:Number = Surfaces.area(vertices, triangles);
            assertTrue("area " + found, Math.abs(found - 169 * (1 - 2 * (0.29 * 0.29 + 0.09 * 0.09))) < 1e-9);
        }

        /** All edges of the outline are in the box of the hole. */
        [Test]
        public function searchesForTouchesInPieces():void
        {
            const TEETH:int = 2000;
            var outline:Array = [[0, 0], [10, 0], [10, 10]];
            var hole:Array = [];
            for (var i:int = 0; i < TEETH; i++)
            {
                outline.push([10 - 10 * (i + 0.5) / TEETH, 1], [10 - 10 * (i + 1) / TEETH, 10]);
                hole.push([0.5 + 9 * i / TEETH, 0.2 + 0.1 * (i & 1)]);
            }
            hole.push([9.9985, 0.9], [9.9975, 2], [9.9965, 0.9]);
            var loops:Vector.<Vector.<uint>> = new Vector.<Vector.<uint>>();
            var vertices:Vector.<Number> = new Vector.<Number>();
            addLoop(outline, loops, vertices);
            addLoop(hole, loops, vertices);
            var budget:FileBudget = new FileBudget("polygons", 100000);
            var triangulator:Triangulator = new Triangulator(budget, vertices, new Vector.<uint>());
            var left:Number = budget.cornerTestsLeft;
            var work:Steps = triangulator.addPolygon(loops[0], loops.slice(1));
            do
            {
                assertTrue("tests in a step: " + (left - budget.cornerTestsLeft), left - budget.cornerTestsLeft < 50000);
                left = budget.cornerTestsLeft;
            }
            while (work.step() && left > 0);
        }

        private static function addLoop(corners:Array, loops:Vector.<Vector.<uint>>, vertices:Vector.<Number>):void
        {
            var loop:Vector.<uint> = new Vector.<uint>();
            for each (var corner:Array in corners)
            {
                loop.push(vertices.length / 3);
                vertices.push(corner[0], corner[1], 0);
            }
            loops.push(loop);
        }

        [Test]
        public function endsOnAnyOutline():void
        {
            const SCALES:Array = [1, 1, 1, 1e-320, 1e-300, 1e150, 1e307];
            var random:SeededRandom = new SeededRandom(8);
            var empty:int = 0;
            for (var i:int = 0; i < 1500; i++)
            {
                var placement:TurnedPlane = new TurnedPlane();
                placement.precision = random.chance() ? 1e-7 : 0;
                placement.turnOn();
                var scale:Number = random.pick(SCALES);
                var loops:Vector.<Vector.<uint>> = new Vector.<Vector.<uint>>();
                var flat:Vector.<Number> = new Vector.<Number>();
                for (var loop:int = random.integer(1, 3); loop > 0; loop--)
                {
                    loops.push(addTangle(flat, random));
                }
                var vertices:Vector.<Number> = placement.place(flat);
                for (var j:int = 0; j < vertices.length; j++)
                {
                    vertices[j] *= scale;
                }
                var triangles:Vector.<uint> = new Vector.<uint>();
                cut(vertices, triangles, loops);
                assertEquals(0, triangles.length % 3);
                assertTrue("outline " + i, triangles.length / 3 <= vertices.length / 3 + 2 * loops.length);
                empty += triangles.length == 0 ? 1 : 0;
            }
            assertTrue("some have no area: " + empty, empty > 50 && empty < 750);
        }

        /**
         * A corner that lies on the line between two others, upright or level, is a corner of triangles on both of its sides. Otherwise the surface would
         * have a gap there without width, and not be closed. A corner on a straight side has a triangle, too, because another face may meet it there.
         */
        [Test]
        public function noTriangleHasACornerOnItsEdge():void
        {
            const SHAPES:Array = [[[0, 0], [2, -2], [4, -2], [2, 0], [4, 2], [2, 2]], [[0, 0], [2, 0], [4, 0], [4, 1], [4, 2], [2, 2], [2, 4], [0, 4]]];
            for each (var shape:Array in SHAPES)
            {
                for (var turn:int = 0; turn < 4; turn++)
                {
                    for (var start:int = 0; start < shape.length; start++)
                    {
                        checkEdges("turn " + turn + ", start " + start, shape);
                        shape.push(shape.shift());
                    }
                    for each (var corner:Array in shape)
                    {
                        corner.push(-corner.shift());
                    }
                }
            }
        }

        private static function checkEdges(what:String, shape:Array):void
        {
            var flat:Vector.<Number> = new Vector.<Number>();
            var loops:Vector.<Vector.<uint>> = new Vector.<Vector.<uint>>();
            addLoop(shape, loops, flat);
            var sides:Array = [];
            for (var i:int = 0; i < shape.length; i++)
            {
                sides.push(i + ">" + (i + 1) % shape.length);
            }
            var triangles:Vector.<uint> = new Vector.<uint>();
            cut(flat, triangles, loops);
            assertEquals(what, sides.sort().join(" "), edgesOnce(triangles));
        }

        // The edges that triangles pass in one direction only, sorted.
        private static function edgesOnce(triangles:Vector.<uint>):String
        {
            var passed:Object = {};
            for (var i:int = 0; i < triangles.length; i++)
            {
                var from:uint = triangles[i];
                var to:uint = triangles[i % 3 == 2 ? i - 2 : i + 1];
                passed[from + ">" + to] = to + ">" + from;
            }
            var edges:Array = [];
            for (var edge:String in passed)
            {
                if (passed[passed[edge]] === undefined)
                {
                    edges.push(edge);
                }
            }
            return edges.sort().join(" ");
        }

        private static function cut(vertices:Vector.<Number>, triangles:Vector.<uint>, loops:Vector.<Vector.<uint>>, bytes:int = 250000):void
        {
            var triangulator:Triangulator = new Triangulator(new FileBudget("polygons", bytes), vertices, triangles);
            var holes:Vector.<Vector.<uint>> = loops.slice(1);
            finish(new StepSequence().beginEach(1, function(index:int):Steps
                    {
                        return triangulator.addPolygon(loops[0], holes);
                    }));
        }

        /** Corners on few places: they meet, lie in line, and go back the way they came. */
        private static function addTangle(flat:Vector.<Number>, random:SeededRandom):Vector.<uint>
        {
            var corners:Vector.<uint> = new Vector.<uint>();
            var places:int = random.integer(0, 3);
            for (var i:int = random.integer(5, 14); i > 0; i--)
            {
                corners.push(flat.length / 3);
                flat.push(random.integer(0, places), random.integer(0, places), 0);
            }
            return corners;
        }

        private static function hole(x:Number, y:Number):Array
        {
            return [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]];
        }

        /** Cuts the polygon as it lies, from every corner and in several places in space, with exact and rounded corners. */
        private static function check(what:String, expected:Number, loops:Array, fromEveryCorner:Boolean = true):void
        {
            var placement:TurnedPlane = new TurnedPlane();
            var turns:int = fromEveryCorner ? Math.min(loops[0].length, 8) : 1;
            for (var i:int = 0; i < turns; i++)
            {
                for each (var precision:Number in [0, 1e-7])
                {
                    placement.precision = precision;
                    var found:Number = run(loops, placement);
                    assertTrue(what + ", turn " + i + ": area " + found + ", not " + expected,
                            Math.abs(found - expected) < 1e-5 + 1000 * precision);
                }
                placement.turnOn();
                loops[0].push(loops[0].shift());
            }
        }

        /** The sum of the triangles' areas, all of which have to turn like the outline. */
        private static function run(loops:Array, placement:TurnedPlane):Number
        {
            var flat:Vector.<Number> = new Vector.<Number>();
            var indices:Vector.<Vector.<uint>> = new Vector.<Vector.<uint>>();
            for each (var loop:Array in loops)
            {
                addLoop(loop, indices, flat);
            }
            var vertices:Vector.<Number> = placement.place(flat);
            var triangles:Vector.<uint> = new Vector.<uint>();
            cut(vertices, triangles, indices);
            assertEquals(0, triangles.length % 3);
            var side:Number = area(loops[0]) < 0 ? -1 : 1;
            for (var i:int = 0; i < triangles.length; i += 3)
            {
                var a:Array = at(flat, triangles[i]);
                var b:Array = at(flat, triangles[i + 1]);
                var c:Array = at(flat, triangles[i + 2]);
                assertTrue("turns like the outline",
                        ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) * side > -1e-9);
            }
            return Surfaces.area(vertices, triangles);
        }

        private static function at(flat:Vector.<Number>, vertex:int):Array
        {
            return [flat[3 * vertex], flat[3 * vertex + 1]];
        }

        private static function area(loop:Array):Number
        {
            var sum:Number = 0;
            for (var i:int = 0; i < loop.length; i++)
            {
                var next:Array = loop[(i + 1) % loop.length];
                sum += loop[i][0] * next[1] - loop[i][1] * next[0];
            }
            return sum / 2;
        }
    }
}
