package starlogo.bounding
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.convex.ConvexShape;
    import starlogo.engine;
    import starlogo.fitting.HullFitter;
    import starlogo.fitting.MinimalCapsuleFitter;
    import starlogo.geometry.Placement;
    import starlogo.geometry.placePoints;
    import starlogo.geometry.hull.ConvexHull;
    import starlogo.intersection.intersects;
    import support.PointSets;
    import support.assertThrows;
    import support.create;

    use namespace engine;

    public class HullTest
    {
        [Test]
        public function aCubeHasItsCornersFacesAndEdges():void
        {
            var hull:Hull = new Hull(PointSets.box(1, 2, 3, 4));
            assertEquals(8, hull.corners.length / 3);
            assertEquals(12, hull.faces.length / 3);
            assertEquals(48, hull.volume);
            assertEquals(12, hull.topology.edges.length / 4);
            assertEquals(BoundingStructure.HULL, hull.kind);
            for each (var number:Number in hull.corners)
            {
                assertTrue(number + "", [1, 2, 3].indexOf(Math.abs(number)) >= 0);
            }
        }

        [Test]
        public function facesAndEdgesFitTogether():void
        {
            var random:SeededRandom = new SeededRandom(7101);
            var counts:Object = {};
            for (var i:int = 0; i < 200; i++)
            {
                var flatness:int = i % 4;
                var points:Vector.<Number> = PointSets.turned(PointSets.cloud(random, 3 + random.integer(0, 30), 1, flatness > 1 ? 0 : 1, flatness > 0 ? 0 : 1), random);
                var hull:Hull = new Hull(points);
                counts[hull.topology.dimension] = true;
                checkTopology(hull, i + "");
                checkTopology(Hull(hull.clone().rotate(mirror())), i + ", mirrored");
            }
            assertTrue(counts[3] && counts[2] && counts[1]);
        }

        // The extent is kept until the corners change.
        [Test]
        public function itsShapeHasTheExtentOfItsPresentCorners():void
        {
            var random:SeededRandom = new SeededRandom(7102);
            var hull:Hull = new Hull(PointSets.box(1, 2, 3, 4));
            var other:Hull = new Hull(PointSets.box(3, 3, 3, 4));
            var turn:Matrix3D = new Matrix3D();
            turn.appendRotation(40, Vector3D.Z_AXIS);
            var placement:Placement = new Placement();
            placement.size = 3;
            for each (var change:Function in [function():void
                    {
                        hull.scale(2);}, function():void
                    {
                        hull.rotate(turn);}, function():void
                    {
                        hull.translate(Vector3D.X_AXIS);},
                        function():void
                        {
                            hull.scaleCorners(1.5);}, function():void
                    {
                        hull.place(placement, other);hull = other;},
                        function():void
                        {
                            hull.setFromNumbers(new Hull(PointSets.cloud(random, 20, 1, 1, 1)).toNumbers());}
                ])
            {
                assertEquals(extentOf(Hull(hull.clone())), extentOf(hull));
                assertEquals(extentOf(hull), extentOf(hull));
                change();
                assertEquals(extentOf(Hull(hull.clone())), extentOf(hull));
            }
        }

        private static function extentOf(hull:Hull):Number
        {
            var shape:ConvexShape = new ConvexShape();
            hull.setShape(shape);
            return shape.boundingRadius;
        }

        private static function checkTopology(hull:Hull, name:String):void
        {
            var points:Vector.<Number> = hull.relativeCorners;
            var faces:Vector.<int> = hull.topology.faces;
            var edges:Vector.<int> = hull.topology.edges;
            var solid:Boolean = hull.topology.dimension == 3;
            // each edge of a face is in one other face, the other way round
            var seen:Object = {};
            for (var i:int = 0; i < faces.length; i++)
            {
                seen[faces[i] + " " + faces[i % 3 == 2 ? i - 2 : i + 1]] = true;
            }
            for (var key:String in seen)
            {
                assertTrue(name + ": " + key, key.split(" ").reverse().join(" ") in seen);
            }
            for (i = 0; i < edges.length && faces.length > 0; i += 4)
            {
                assertTrue(name, edges[i] + " " + edges[i + 1] in seen);
                if (solid)
                {
                    // both faces at an edge are outer ones: all corners are below them
                    assertTrue(name + ": left", isOuter(points, edges[i], edges[i + 1], edges[i + 2]));
                    assertTrue(name + ": right", isOuter(points, edges[i + 1], edges[i], edges[i + 3]));
                }
            }
            for (i = 0; i < faces.length && solid; i += 3)
            {
                assertTrue(name + ": face", isOuter(points, faces[i], faces[i + 1], faces[i + 2]));
            }
        }

        private static function isOuter(points:Vector.<Number>, a:int, b:int, c:int):Boolean
        {
            var at:Vector3D = at3(points, a);
            var normal:Vector3D = at3(points, b).subtract(at).crossProduct(at3(points, c).subtract(at));
            for (var i:int = 0; i < points.length; i += 3)
            {
                if (normal.dotProduct(at3(points, i).subtract(at)) > 1e-6 * normal.length)
                {
                    return false;
                }
            }
            return normal.length > 0;
        }

        private static function at3(points:Vector.<Number>, i:int):Vector3D
        {
            return new Vector3D(points[i], points[i + 1], points[i + 2]);
        }

        private static function mirror():Matrix3D
        {
            return new Matrix3D(new <Number>[-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
        }

        [Test]
        public function flatHullsAndSegmentsAndPoints():void
        {
            var square:Hull = new Hull(PointSets.box(1, 2, 0));
            assertEquals(4, square.corners.length / 3);
            assertEquals(4, square.faces.length / 3);
            assertEquals(0, square.volume);
            assertTrue(square.contains(new Vector3D(0.9, -1.9, 0)));
            assertFalse(square.contains(new Vector3D(0.9, -1.9, 0.01)));
            assertFalse(square.contains(new Vector3D(1.01, 0, 0)));

            var segment:Hull = new Hull(new <Number>[0, 0, 0, 1, 1, 1, 4, 4, 4]);
            assertEquals(2, segment.corners.length / 3);
            assertEquals(0, segment.faces.length);
            assertTrue(segment.contains(new Vector3D(3, 3, 3)));
            assertFalse(segment.contains(new Vector3D(3, 3, 3.01)));
            assertFalse(segment.contains(new Vector3D(4.01, 4.01, 4.01)));

            var point:Hull = new Hull(new <Number>[1, 2, 3, 1, 2, 3]);
            assertEquals(1, point.corners.length / 3);
            assertTrue(point.contains(new Vector3D(1, 2, 3)));
            assertFalse(point.contains(new Vector3D(1, 2, 3.0001)));
        }

        [Test]
        public function aHullFollowsItsCentre():void
        {
            var hull:Hull = new Hull(PointSets.box(1, 2, 3, 4));
            hull.center.x += 10;
            hull = Hull(hull.clone());
            var there:Box = new Box(new Vector3D(10, 0, 0), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 2, 3);
            var here:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 2, 3);
            assertTrue(intersects(hull, there));
            assertTrue(intersects(hull, new Sphere(new Vector3D(11.5, 0, 0), 0.5)));
            assertTrue(intersects(hull, Hull(hull.clone())));
            assertFalse(intersects(hull, here));
            hull.center = new Vector3D();
            assertFalse(intersects(hull, there));
            assertTrue(intersects(hull, here));
            // the middle of its extents is beside its centre
            var placement:Placement = new Placement();
            placement.size = 2;
            placement.setRotation(90, 0, 0);
            placement.x = 50;
            var wedge:Hull = new Hull(new <Number>[0, 0, 0, 4, 0, 0, 0, 1, 0, 0, 0, 1]);
            wedge.center.y += 100;
            var placed:Hull = Hull(wedge.place(placement));
            // its tip was at (4, 100, 0)
            assertTrue(intersects(placed, new Sphere(new Vector3D(50 - 200, 8.05, 0), 0.1)));
            assertFalse(intersects(placed, new Sphere(new Vector3D(50 - 200, 8.15, 0), 0.1)));
        }

        [Test]
        public function containsWhatItsPointsSpanAndNoMore():void
        {
            var random:SeededRandom = new SeededRandom(7102);
            var inside:int = 0;
            for (var i:int = 0; i < 60; i++)
            {
                var points:Vector.<Number> = PointSets.cloud(random, 4 + random.integer(0, 12));
                var hull:Hull = new Hull(points);
                for (var k:int = 0; k < 20; k++)
                {
                    // a mixture of the points is inside
                    var mixed:Vector3D = new Vector3D();
                    var sum:Number = 0;
                    for (var p:int = 0; p < points.length; p += 3)
                    {
                        var weight:Number = Math.pow(random.between(0, 1), 4);
                        sum += weight;
                        mixed.incrementBy(new Vector3D(weight * points[p], weight * points[p + 1], weight * points[p + 2]));
                    }
                    mixed.scaleBy(1 / sum);
                    assertTrue(i + "", hull.contains(mixed));
                    // a point that is farther along some direction than all of them is outside
                    var direction:Vector3D = new Vector3D(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
                    direction.normalize();
                    var most:Number = -Infinity;
                    for (p = 0; p < points.length; p += 3)
                    {
                        most = Math.max(most, direction.dotProduct(at3(points, p)));
                    }
                    var beyond:Number = most - direction.dotProduct(mixed);
                    assertFalse(i + "", hull.contains(new Vector3D(mixed.x + (beyond + 1e-4) * direction.x, mixed.y + (beyond + 1e-4) * direction.y,
                                    mixed.z + (beyond + 1e-4) * direction.z)));
                    inside++;
                }
            }
            assertEquals(1200, inside);
        }

        [Test]
        public function containsNothingBeyondASharpTipOrEdge():void
        {
            for each (var width:Number in [1e-3, 1e-5, 1e-6])
            {
                var tip:Hull = new Hull(new <Number>[0, 0, 0, 1, 0, 0, 1, width, 0]);
                var needle:Hull = new Hull(new <Number>[0, 0, 0, 1, 0, 0, 1, width, 0, 1, 0, width]);
                var blade:Hull = new Hull(new <Number>[0, 0, 0, 1, 1, 0, 1, -1, 0, 2, 0, 0, 1, 0, width]);
                for each (var hull:Hull in [tip, needle, blade])
                {
                    assertTrue(hull + " of width " + width, hull.contains(new Vector3D(-5e-7, 0, 0)));
                    assertFalse(hull + " of width " + width, hull.contains(new Vector3D(-1e-5, 0, 0)));
                }
                assertFalse("beside an edge, width " + width, blade.contains(new Vector3D(0.5 - 1e-5, 0.5 + 1e-5, 0)));
            }
        }

        [Test]
        public function doesNotContainAPointThatIsNone():void
        {
            for each (var points:Vector.<Number> in [PointSets.box(1, 1, 1), PointSets.box(1, 1, 0), PointSets.box(1, 0, 0), PointSets.box(0, 0, 0)])
            {
                assertFalse(new Hull(points).contains(new Vector3D(NaN, 0, 0)));
                assertFalse(new Hull(points).contains(new Vector3D(0, 0, Infinity)));
            }
        }

        [Test]
        public function theVolumeOfANeedleIsNotNegative():void
        {
            var random:SeededRandom = new SeededRandom(7105);
            var solid:int = 0;
            for (var i:int = 0; i < 300; i++)
            {
                var points:Vector.<Number> = PointSets.turned(PointSets.cloud(random, 4 + i % 7, 1, 1), random);
                for (var k:int = 0; k < points.length; k += 3)
                {
                    // near a line through the origin
                    points[k + 1] = 0.7 * points[k] + 1e-11 * points[k + 1];
                    points[k + 2] = -0.3 * points[k] + 1e-11 * points[k + 2];
                }
                var hull:Hull = new Hull(points);
                assertTrue(hull.volume >= 0 && hull.volume < 1e-15);
                assertTrue(new ConvexHull(points).volume >= 0);
                solid += hull.topology.dimension == 3 ? 1 : 0;
            }
            assertTrue(solid > 100);
        }

        [Test]
        public function movesLikeItsPoints():void
        {
            var random:SeededRandom = new SeededRandom(7103);
            for (var i:int = 0; i < 40; i++)
            {
                var points:Vector.<Number> = PointSets.cloud(random, 4 + random.integer(0, 12));
                var placement:Placement = new Placement();
                placement.setRotation(random.between(0, 360), random.between(0, 360), random.between(0, 360));
                placement.size = Math.pow(10, random.between(-6, 6));
                placement.x = random.between(-50, 50);
                placement.y = random.between(-50, 50);
                placement.z = random.between(-50, 50);
                var hull:Hull = new Hull(points);
                var placed:Hull = Hull(hull.place(placement));
                var moved:Vector.<Number> = placePoints(placement, hull.corners, 0, hull.corners.length, new Vector.<Number>());
                for (var k:int = 0; k < moved.length; k++)
                {
                    assertNear(moved[k], placed.corners[k], 1e-12 * (placement.size + 50));
                }
                assertNear(1, placed.volume / hull.volume / Math.pow(placement.size, 3), 1e-12);
                checkExtents(hull, placed, placement);
                // into a hull of another number of corners
                var other:Hull = new Hull(PointSets.cloud(random, 40));
                assertTrue(hull.place(placement, other) == other);
                assertEquals(placed.corners.join(), other.corners.join());
                assertEquals(placed.faces.join(), other.faces.join());
            }
        }

        private static function checkExtents(hull:Hull, placed:Hull, placement:Placement):void
        {
            var extents:Vector.<Number> = new Vector.<Number>(6);
            var rotated:Vector.<Number> = new Vector.<Number>(6);
            placed.extentsInto(extents);
            hull.findPlacedBox(placement, rotated);
            var at:Array = [placement.x, placement.y, placement.z];
            for (var axis:int = 0; axis < 3; axis++)
            {
                var low:Number = Infinity;
                var high:Number = -Infinity;
                for (var i:int = axis; i < placed.corners.length; i += 3)
                {
                    low = Math.min(low, placed.corners[i]);
                    high = Math.max(high, placed.corners[i]);
                }
                var slack:Number = 1e-12 * (placement.size + 50);
                assertTrue(extents[2 * axis] < low && extents[2 * axis] > low - slack);
                assertTrue(extents[2 * axis + 1] > high && extents[2 * axis + 1] < high + slack);
                assertNear(low, at[axis] + rotated[axis] - rotated[axis + 3], slack);
                assertNear(high, at[axis] + rotated[axis] + rotated[axis + 3], slack);
            }
        }

        private static function assertNear(expected:Number, actual:Number, tolerance:Number):void
        {
            assertTrue(actual + " instead of " + expected, Math.abs(actual - expected) <= tolerance);
        }

        [Test]
        public function aCopySharesNothingThatChanges():void
        {
            var hull:Hull = new Hull(PointSets.box(1, 1, 1));
            var copy:Hull = Hull(hull.clone());
            copy.scale(2).translate(new Vector3D(1, 2, 3));
            assertEquals(8, hull.volume);
            assertEquals(64, copy.volume);
            assertEquals(0, hull.center.length);
            assertEquals("1,2,3", [copy.center.x, copy.center.y, copy.center.z].join());
        }

        [Test]
        public function itsNumbersMakeTheSameHull():void
        {
            var random:SeededRandom = new SeededRandom(7104);
            for (var i:int = 0; i < 60; i++)
            {
                var hull:Hull = new Hull(PointSets.turned(PointSets.cloud(random, 3 + i, 1, i % 5 == 0 ? 0 : 1), random));
                hull.widen(1e-14);
                var read:Hull = new Hull(PointSets.box(1, 1, 1));
                read.setFromNumbers(hull.toNumbers());
                assertEquals(hull.toNumbers().join(), read.toNumbers().join());
                assertEquals(hull.faces.join(), read.faces.join());
                assertEquals(hull.topology.edges.join(), read.topology.edges.join());
            }
        }

        // The mean of points in one place is rounded: that is no size.
        [Test]
        public function pointsInOnePlaceAreOnePointHoweverNear():void
        {
            var random:SeededRandom = new SeededRandom(7109);
            for (var i:int = 0; i < 60; i++)
            {
                var scale:Number = Math.pow(10, -50 - i % 20);
                var point:Vector.<Number> = new <Number>[scale * random.between(-1, 1), scale * random.between(-1, 1), scale * random.between(-1, 1)];
                var points:Vector.<Number> = point.concat();
                for (var k:int = 0; k < 1 + i % 7; k++)
                {
                    points = points.concat(point);
                }
                assertEquals(3, Hull(new Hull(points).clone()).corners.length);
                assertEquals(0, new MinimalCapsuleFitter().fit(points).volume);
            }
        }

        /** A corner may be farther from the centre than any is from the origin, and a fitted hull is larger than its model. */
        [Test]
        public function lopsidedHullsMayBeAsLargeAsAnyModel():void
        {
            var random:SeededRandom = new SeededRandom(61);
            var points:Vector.<Number> = new <Number>[-1e60, 0, 0];
            for (var i:int = 0; i < 300; i++)
            {
                var turn:Number = random.between(0, 2 * Math.PI);
                points.push(1e60, 1e60 * Math.cos(turn), 1e60 * Math.sin(turn));
            }
            var large:Vector.<BoundingStructure> = new <BoundingStructure>[new Hull(points), new HullFitter(8).fit(points), new HullFitter(30).fit(points)];
            for each (var hull:BoundingStructure in large)
            {
                for (i = 0; i < points.length; i += 3)
                {
                    assertTrue(hull + ", vertex " + i / 3, hull.contains(new Vector3D(points[i], points[i + 1], points[i + 2])));
                }
                assertFalse(hull + ", beside", hull.contains(new Vector3D(-1e60, 1e60, 0)));
                assertTrue(String(hull), intersects(hull, hull.clone().translate(new Vector3D(1e60, 0, 0))));
                assertFalse(String(hull), intersects(hull, hull.clone().translate(new Vector3D(9e60, 0, 0))));
                hull.scale(1e9).clone();
            }
        }

        [Test]
        public function hullsOfAllSizesAndDimensionsContainTheSame():void
        {
            for each (var size:Number in [1e-69, 1e-60, 1e-30, 1, 1e30, 1e60, 1e69])
            {
                assertContainsOnly(size, PointSets.box(1, 1, 1));
                assertContainsOnly(size, new <Number>[-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]);
                assertContainsOnly(size, new <Number>[-1, 0, -1, 0, 0, 1, 1, 0, -1]);
                assertContainsOnly(size, new <Number>[-1, -1, -1, 1, 1, 1]);
                assertContainsOnly(size, new <Number>[0, 0, 0]);
            }
        }

        // The hull contains its corners and its centre, and nothing at 3 times the size.
        private static function assertContainsOnly(size:Number, points:Vector.<Number>):void
        {
            for (var i:int = 0; i < points.length; i++)
            {
                points[i] *= size;
            }
            var hull:Hull = new Hull(points);
            assertTrue(hull + ", its centre", hull.contains(hull.center));
            for (i = 0; i < points.length; i += 3)
            {
                assertTrue(hull + ", corner " + i / 3, hull.contains(new Vector3D(points[i], points[i + 1], points[i + 2])));
            }
            for each (var far:Number in [-3 * size, 3 * size])
            {
                assertFalse(hull + ", x " + far, hull.contains(new Vector3D(far, 0, 0)));
                assertFalse(hull + ", y " + far, hull.contains(new Vector3D(0, far, 0)));
                assertFalse(hull + ", z " + far, hull.contains(new Vector3D(0, 0, far)));
            }
        }

        [Test]
        public function refusesWhatMakesNoHull():void
        {
            assertThrows(ArgumentError, "null", create, Hull, null);
            assertThrows(ArgumentError, "", create, Hull, new Vector.<Number>());
            assertThrows(ArgumentError, "", create, Hull, new <Number>[1, 2]);
            assertThrows(ArgumentError, "", create, Hull, new <Number>[1, 2, NaN]);
            assertThrows(RangeError, "", create, Hull, new <Number>[1, 2, 1e71]);
            assertThrows(RangeError, "", create, Hull, new <Number>[1e200, 0, 0, -1e200, 0, 0]);
            for each (var tiny:Number in [1e-80, 1e-200, 1e-310])
            {
                assertThrows(RangeError, "size", create, Hull, new <Number>[0, 0, 0, tiny, 0, 0]);
            }
            var hull:Hull = new Hull(PointSets.box(1, 1, 1));
            var tinyHull:Hull = new Hull(PointSets.box(1e-60, 1e-60, 1e-60));
            for each (var factor:Number in [1e71, 1e-71, 1e-200, 1e-300])
            {
                assertThrows(RangeError, "", hull.scale, factor);
                assertThrows(RangeError, "", tinyHull.scale, factor > 1 ? 1e141 : factor);
            }
            assertThrows(ArgumentError, "same kind", hull.place, new Placement(), new Sphere(new Vector3D(), 1));
            assertEquals(8, hull.volume);
        }
    }
}
