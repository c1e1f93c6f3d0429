package starlogo.fitting
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.Box;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.intersection.intersects;
    import starlogo.models.Model;
    import support.PointSets;
    import support.SteppedModels;
    import support.assertThrows;
    import support.create;

    use namespace engine;

    /** Hulls of few corners: that they hold every vertex, how many corners they have and how large they are. */
    public class HullFitterTest
    {
        public static const FIXTURES:Array = SteppedModels.FIXTURES;

        // the rounding error of a distance from a plane, as a fraction of the coordinates
        private static const ROUNDING:Number = 4e-16;

        [Test]
        public function holdsEveryVertexOfHardSets():void
        {
            var full:int = 0;
            for (var seed:int = 1; seed <= 4; seed++)
            {
                var sets:Array = PointSets.hard(new SeededRandom(seed));
                for (var i:int = 0; i < sets.length; i += 2)
                {
                    for each (var most:int in [8, 16, 40])
                    {
                        var session:FitSession = new FitSession(sets[i + 1]);
                        var hull:Hull = Hull(session.structureOf(new HullFitter(most)));
                        var name:String = sets[i] + ", seed " + seed + ", " + most + " corners";
                        assertHolds(name, hull, sets[i + 1]);
                        assertTrue(name + ": " + hull, hull.corners.length <= 3 * most);
                        assertEquals(name, session.hull.dimension, hull.topology.dimension);
                        full += session.hull.indices.length <= most ? 1 : 0;
                        assertTrue(name, hull.radius <= 1e-11 * session.hull.extent + 1e-13 * largest(sets[i + 1]));
                    }
                }
            }
            assertTrue(full + "", full > 100 && full < 300);
        }

        [Test]
        public function holdsEveryVertexOfRandomSetsOfAnyScale():void
        {
            var random:SeededRandom = new SeededRandom(7111);
            var counts:int = 0;
            for (var i:int = 0; i < 120; i++)
            {
                var points:Vector.<Number> = PointSets.cloud(random, 20 + random.integer(0, 80), 1, random.between(0, 1), Math.pow(10, random.between(-9, 0)));
                points = PointSets.placed(PointSets.turned(points, random), Math.pow(10, random.between(-6, 6)), random.between(-50, 50));
                var session:FitSession = new FitSession(points);
                var hull:Hull = Hull(session.structureOf(new HullFitter(8 + random.integer(0, 20))));
                assertHolds("set " + i, hull, points);
                assertTrue("set " + i + ": " + hull.volume / session.hull.volume, session.hull.dimension < 3 || hull.volume < 2.5 * session.hull.volume);
                counts += hull.relativeCorners.length;
            }
            assertTrue(counts + "", counts > 120 * 3 * 12);
        }

        // Asserts that every vertex is inside, up to the rounding of the assertion itself.
        private static function assertHolds(name:String, hull:Hull, vertices:Vector.<Number>):void
        {
            var planes:Vector.<Number> = hull.halfSpaces;
            for (var i:int = 0; i < planes.length; i += 4)
            {
                for (var k:int = 0; k < vertices.length; k += 3)
                {
                    var x:Number = vertices[k] - hull.center.x;
                    var y:Number = vertices[k + 1] - hull.center.y;
                    var z:Number = vertices[k + 2] - hull.center.z;
                    var beyond:Number = planes[i] * x + planes[i + 1] * y + planes[i + 2] * z - planes[i + 3] - hull.radius;
                    if (beyond > ROUNDING * (Math.abs(x) + Math.abs(y) + Math.abs(z)))
                    {
                        assertEquals(name + ", vertex " + k / 3 + " of " + hull, 0, beyond);
                    }
                }
            }
        }

        // A point that is hardly above two faces is far from their common edge if that is sharp.
        [Test]
        public function touchesEveryVertexOfThinFrusta():void
        {
            var random:SeededRandom = new SeededRandom(7117);
            for (var i:int = 0; i < 150; i++)
            {
                var thickness:Number = Math.pow(10, random.between(-7, -3));
                var points:Vector.<Number> = new Vector.<Number>();
                for (var count:int = random.integer(12, 120); count > 0; count--)
                {
                    var angle:Number = random.between(0, 2 * Math.PI);
                    points.push(Math.cos(angle), Math.sin(angle), count % 3 == 0 ? thickness : 0);
                }
                points = PointSets.turned(points, random);
                var hull:Hull = Hull(new FitSession(points).structureOf(new HullFitter()));
                for (var k:int = 0; k < points.length; k += 3)
                {
                    var vertex:Sphere = new Sphere(new Vector3D(points[k], points[k + 1], points[k + 2]), 0);
                    assertTrue("set " + i + " of thickness " + thickness + ", vertex " + k / 3, intersects(hull, vertex));
                }
            }
        }

        // Far from the origin, the vertices of a flat set are beside its plane by more than the slack of the box.
        [Test]
        public function theBoxIsAroundFlatHullsFarOut():void
        {
            var random:SeededRandom = new SeededRandom(7113);
            var wide:int = 0;
            for (var i:int = 0; i < 40; i++)
            {
                var points:Vector.<Number> = PointSets.cloud(random, 30, 1, 1, 0);
                points = PointSets.placed(PointSets.turned(points, random), 1, random.pick([1e3, 1e5, 1e6]), random.pick([0, 1e6]));
                var hull:Hull = Hull(new FitSession(points).structureOf(new HullFitter(12)));
                wide += hull.radius > 1e-12 ? 1 : 0;
            }
            assertTrue(wide + "", wide > 5);
        }

        [Test]
        public function isAFewPercentLargerThanTheFullHull():void
        {
            var sums:Array = [0, 0, 0];
            var models:Vector.<Model> = SteppedModels.twelve();
            for each (var model:Model in models)
            {
                var session:FitSession = new FitSession(model.vertices);
                for (var i:int = 0; i < 3; i++)
                {
                    var hull:Hull = Hull(session.structureOf(new HullFitter([8, 16, 32][i])));
                    sums[i] += hull.volume / session.hull.volume / models.length;
                    assertTrue(model.name, hull.volume >= session.hull.volume * (1 - 1e-6));
                    assertHolds(model.name, hull, model.vertices);
                }
            }
            trace("hulls of 8, 16 and 32 corners, in volumes of the full hull: " + sums.join(", "));
            assertTrue(sums.join(), sums[0] < 1.45 && sums[1] < 1.1 && sums[2] < 1.025);
        }

        [Test]
        public function isNeverLargerThanTheAxisAlignedBox():void
        {
            var random:SeededRandom = new SeededRandom(1032);
            var equal:int = 0;
            for (var i:int = 0; i < 300; i++)
            {
                var points:Vector.<Number> = new Vector.<Number>();
                for (var count:int = random.integer(9, 40); count > 0; count--)
                {
                    points.push(random.integer(0, 3), random.integer(0, 3), random.integer(0, 3));
                }
                var hull:Number = new HullFitter(8).fit(points).volume;
                var box:Number = new AxisAlignedBoxFitter().fit(points).volume;
                assertTrue("set " + i + ": " + hull + ", the box " + box, hull <= box * (1 + 1e-9));
                equal += hull >= box * (1 - 1e-9) ? 1 : 0;
            }
            assertTrue(equal + "", equal > 5 && equal < 150);
        }

        // A flat patch far from the origin is beside its plane by the rounding of its place, which is no thickness.
        [Test]
        public function isNeverLargerThanTheBoxFarFromTheOrigin():void
        {
            var random:SeededRandom = new SeededRandom(1033);
            for (var i:int = 0; i < 300; i++)
            {
                var thickness:Number = i % 3 == 0 ? Math.pow(10, random.between(-16, 0)) : 0;
                var points:Vector.<Number> = PointSets.cloud(random, random.integer(4, 40), 1, Math.pow(10, random.between(-3, 0)), thickness);
                points = i % 5 == 0 ? points : PointSets.turned(points, random);
                var far:Number = Math.pow(10, random.between(-2, 10));
                points = PointSets.placed(points, 1, far * random.between(-1, 1), far * random.between(-1, 1), far * random.between(-1, 1));
                points = PointSets.placed(points, Math.pow(10, random.between(-6, 3)));
                var session:FitSession = new FitSession(points);
                var hull:Hull = Hull(session.structureOf(new HullFitter(random.integer(8, 20))));
                var box:Box = Box(session.structureOf(new AxisAlignedBoxFitter()));
                var name:String = "set " + i + " of thickness " + thickness + ", " + far + " away: " + hull;
                assertTrue(name, hull.volume <= box.volume * (1 + 1e-9));
                assertHolds(name, hull, points);
                var lengths:Vector.<Number> = new Vector.<Number>();
                hull.extentsInto(lengths);
                var most:Number = Math.max(box.halfX, box.halfY, box.halfZ);
                for (var axis:int = 0; axis < 3 && thickness == 0; axis++)
                {
                    var half:Number = [box.halfX, box.halfY, box.halfZ][axis];
                    assertTrue(name, (lengths[2 * axis + 1] - lengths[2 * axis]) / 2 <= half + 0.3 * most);
                }
            }
        }

        [Test]
        public function aHullWithFewCornersStaysAsItIs():void
        {
            var random:SeededRandom = new SeededRandom(7112);
            assertEquals(1, new HullFitter().fit(PointSets.box(0.5, 0.5, 0.5, 6)).volume);
            for (var i:int = 0; i < 30; i++)
            {
                var points:Vector.<Number> = PointSets.turned(PointSets.box(0.5, 1, 2, 4), random);
                var volume:Number = new HullFitter().fit(points).volume;
                assertTrue(volume + "", Math.abs(volume - 8) < 1e-5);
            }
        }

        // The circle's polygon of few corners is the regular one, or nearly.
        [Test]
        public function flatVerticesGetAPolygon():void
        {
            var random:SeededRandom = new SeededRandom(7113);
            for (var i:int = 0; i < 20; i++)
            {
                var points:Vector.<Number> = PointSets.turned(PointSets.cylinder(1, 0, 48, 2), random);
                var hull:Hull = Hull(new HullFitter().fit(points));
                assertEquals(2, hull.topology.dimension);
                assertTrue(hull + "", hull.relativeCorners.length <= 48);
                assertHolds(i + "", hull, points);
                var reach:Number = 0;
                for (var k:int = 0; k < hull.relativeCorners.length; k += 3)
                {
                    reach = Math.max(reach, hull.relativeCorners[k] * hull.relativeCorners[k] + hull.relativeCorners[k + 1] * hull.relativeCorners[k + 1] + hull.relativeCorners[k + 2] * hull.relativeCorners[k + 2]);
                }
                assertTrue(reach + "", reach < 1.35);
            }
        }

        [Test]
        public function pointsAndLinesHaveHullsToo():void
        {
            var point:Hull = Hull(new HullFitter().fit(new <Number>[1, 2, 3, 1, 2, 3]));
            assertEquals("1,2,3", point.corners.join());
            assertEquals(0, point.volume);
            var segment:Hull = Hull(new HullFitter().fit(new <Number>[0, 0, 0, 0, 3, 0, 0, 1, 0]));
            assertEquals("0,0,0,0,3,0", segment.corners.join());
            assertEquals(0, segment.radius);
        }

        // A cone, a double cone and a fan have corners with an edge to all others.
        [Test]
        public function cornersWithManyEdges():void
        {
            for (var count:int = 20; count <= 600; count *= 5)
            {
                var rim:Vector.<Number> = PointSets.cylinder(1, 0, count, 2);
                for each (var tips:Vector.<Number> in [new <Number>[0, 0, 1], new <Number>[0, 0, 1, 0, 0, -1], new <Number>[0.9, 0, 3]])
                {
                    var points:Vector.<Number> = rim.concat(tips);
                    var session:FitSession = new FitSession(points);
                    var hull:Hull = Hull(session.structureOf(new HullFitter()));
                    assertHolds(count + "", hull, points);
                    assertTrue(hull.volume / session.hull.volume + "", hull.volume < 1.15 * session.hull.volume);
                    assertTrue(hull + "", hull.relativeCorners.length <= 48);
                }
            }
        }

        [Test]
        public function stepsFindTheSame():void
        {
            for each (var model:Model in SteppedModels.odd())
            {
                var fit:Fit = new HullFitter().fitting(new FitSession(model.vertices));
                var steps:int = 1;
                while (fit.step())
                {
                    steps++;
                }
                assertEquals(model.name, Hull(new HullFitter().fit(model.vertices)).toNumbers().join(), Hull(fit.structure).toNumbers().join());
                assertTrue(model.name + ": " + steps, model.name != "cloud" || steps > 10);
            }
        }

        [Test]
        public function refusesFewerCornersThanABoxHas():void
        {
            assertThrows(RangeError, "7", create, HullFitter, 7);
            assertEquals("hull 16", new HullFitter().signature);
            assertEquals(24, new HullFitter(24).maxCorners);
        }

        private static function largest(numbers:Vector.<Number>):Number
        {
            var most:Number = 0;
            for each (var number:Number in numbers)
            {
                most = Math.max(most, Math.abs(number));
            }
            return most;
        }
    }
}
