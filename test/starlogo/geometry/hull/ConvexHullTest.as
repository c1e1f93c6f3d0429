package starlogo.geometry.hull
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;
    import support.assertThrows;
    import support.create;
    import support.PointSets;

    public class ConvexHullTest
    {
        // How far a vertex may be outside of its hull, as a fraction of the extent.
        private static const FARTHEST_OUTSIDE:Number = 2e-7;

        [Test]
        public function enclosesHardSetsAndIsClosed():void
        {
            for (var seed:int = 1; seed <= 5; seed++)
            {
                var random:SeededRandom = new SeededRandom(seed);
                var sets:Array = PointSets.hard(random);
                for (var i:int = 0; i < sets.length; i += 2)
                {
                    var name:String = sets[i] + ", seed " + seed;
                    var hull:ConvexHull = new ConvexHull(sets[i + 1]);
                    checkEnclosure(name, hull);
                    checkMesh(name, hull);
                    checkSupports(name, hull, random);
                }
            }
        }

        [Test]
        public function flatSidesHaveCornersOnly():void
        {
            var random:SeededRandom = new SeededRandom(3);
            var cube:Vector.<Number> = PointSets.box(0.5, 0.5, 0.5, 12);
            assertEquals(8, new ConvexHull(cube).indices.length);
            for (var i:int = 0; i < 20; i++)
            {
                assertEquals(8, new ConvexHull(PointSets.shuffled(cube, random)).indices.length);
            }
            var corners:int = 0;
            for (i = 0; i < 20; i++)
            {
                corners += new ConvexHull(PointSets.turned(cube, random)).indices.length;
            }
            assertTrue("turned: " + corners / 20, corners < 20 * 12);
            assertEquals(48, new ConvexHull(PointSets.cylinder(0.5, 1, 24, 9)).indices.length);
            // a floor, whose grid is turned
            var floor:Vector.<Number> = new Vector.<Number>();
            for (i = 0; i < 21 * 14; i++)
            {
                floor.push(i % 21 / 10, int(i / 21) / 10, 0);
            }
            assertEquals("0,20,273,293", new ConvexHull(floor).indices.join());
        }

        // Vertex 3 is 8.6 steps of the grid outside of the others, beyond the tip of a narrow triangle.
        [Test]
        public function whatIsBeyondTheTipOfANarrowTriangleIsACorner():void
        {
            var side:Number = 33554432;
            var hull:ConvexHull = new ConvexHull(new <Number>[0, 0, 0, side, side, side, 21877191, 9471874, 22887190, 21877225, 9471903, 22887210,
                        21877240, 9471935, 22887222, 24349789, 13872224, 24589438, 1802418, 20444868, 22340784]);
            checkSupport("tip", hull, 0.708, -0.676, 0.205);
        }

        [Test]
        public function knowsItsDimension():void
        {
            var random:SeededRandom = new SeededRandom(5);
            assertEquals(0, new ConvexHull(new <Number>[1, 2, 3, 1, 2, 3]).dimension);
            assertEquals(1, new ConvexHull(PointSets.turned(PointSets.cloud(random, 9, 1, 0, 0), random)).dimension);
            assertEquals(2, new ConvexHull(PointSets.turned(PointSets.cloud(random, 9, 1, 1, 0), random)).dimension);
            assertEquals(3, new ConvexHull(PointSets.cloud(random, 9, 1, 1, 1e-6)).dimension);
        }

        [Test]
        public function cornersAreThoseOfTheFigure():void
        {
            var square:ConvexHull = new ConvexHull(new <Number>[0, 0, 0, 2, 0, 0, 1, 1, 0, 2, 2, 0, 1, 0, 0, 0, 2, 0]);
            assertEquals("0,1,3,5", square.indices.join());
            assertEquals("0,0,0,2,0,0,2,2,0,0,2,0", square.points.join());
            var segment:ConvexHull = new ConvexHull(new <Number>[1, 0, 0, 3, 0, 0, 2, 0, 0]);
            assertEquals("0,1", segment.indices.join());
        }

        [Test]
        public function measuresItsVolume():void
        {
            assertNear(1, new ConvexHull(PointSets.box(0.5, 0.5, 0.5, 3)).volume, 1e-12);
            assertNear(1 / 6, new ConvexHull(new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]).volume, 1e-12);
            assertEquals(0, new ConvexHull(PointSets.box(1, 1, 0)).volume);
        }

        // Twice as many vertices take at most two and a half times as many steps, which all have about the same work.
        [Test]
        public function costsLittleMoreForEachOfMoreVertices():void
        {
            for each (var make:Function in [closedCurve, helix, skewArcs, twoRings, coneAndRing])
            {
                var few:int = stepsOf(make(4000));
                var many:int = stepsOf(make(8000));
                assertTrue(few + " and " + many, few > 30 && many < 2.5 * few + 20);
            }
        }

        private static function stepsOf(vertices:Vector.<Number>):int
        {
            var hull:ConvexHull = new ConvexHull(vertices, false);
            var steps:int = 1;
            while (hull.step())
            {
                steps++;
            }
            return steps;
        }

        private static function closedCurve(count:int):Vector.<Number>
        {
            return curve(count, function(t:Number):Array
                {
                    return [Math.cos(2 * Math.PI * t), Math.sin(2 * Math.PI * t), 0.3 * Math.cos(4 * Math.PI * t)];
                });
        }

        private static function helix(count:int):Vector.<Number>
        {
            return curve(count, function(t:Number):Array
                {
                    return [Math.cos(8 * Math.PI * t), Math.sin(8 * Math.PI * t), t];
                });
        }

        private static function skewArcs(count:int):Vector.<Number>
        {
            return curve(count, function(t:Number):Array
                {
                    var angle:Number = Math.PI * (2 * t % 1 - 0.5) / 2;
                    return t < 0.5 ? [Math.sin(angle), 0, Math.cos(angle)] : [0, Math.sin(angle), -Math.cos(angle)];
                });
        }

        private static function twoRings(count:int):Vector.<Number>
        {
            return PointSets.cylinder(1, 1, count / 2, 2);
        }

        private static function coneAndRing(count:int):Vector.<Number>
        {
            return PointSets.cylinder(1, 0.5, count / 2, 2).concat(new <Number>[0, 0, 2, 0, 0.1, 1.9]);
        }

        private static function curve(count:int, place:Function):Vector.<Number>
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < count; i++)
            {
                var at:Array = place(i / count);
                points.push(at[0], at[1], at[2]);
            }
            return points;
        }

        [Test]
        public function refusesWhatAreNoVertices():void
        {
            assertThrows(ArgumentError, "null", create, ConvexHull, null);
            assertThrows(ArgumentError, "0", create, ConvexHull, new Vector.<Number>());
            assertThrows(ArgumentError, "4", create, ConvexHull, new <Number>[1, 2, 3, 4]);
            assertThrows(ArgumentError, "vertex 1", create, ConvexHull, new <Number>[1, 2, 3, 4, NaN, 6]);
            assertThrows(ArgumentError, "Infinity", create, ConvexHull, new <Number>[1, 2, Infinity]);
            assertThrows(ArgumentError, "1e+200", create, ConvexHull, new <Number>[1, 2, 1e200]);
        }

        private static function assertNear(expected:Number, actual:Number, tolerance:Number):void
        {
            assertTrue(actual + " instead of " + expected, Math.abs(actual - expected) <= tolerance);
        }

        // Every vertex behind every plane of the hull, by brute force.
        private static function checkEnclosure(name:String, hull:ConvexHull):void
        {
            var p:Vector.<Number> = hull.points;
            var t:Vector.<int> = hull.triangles;
            var v:Vector.<Number> = hull.vertices;
            var allowed:Number = FARTHEST_OUTSIDE * hull.extent;
            for (var i:int = 0; i < t.length; i += 3)
            {
                var a:int = 3 * t[i];
                var b:int = 3 * t[i + 1];
                var c:int = 3 * t[i + 2];
                var x:Number = (p[b + 1] - p[a + 1]) * (p[c + 2] - p[a + 2]) - (p[b + 2] - p[a + 2]) * (p[c + 1] - p[a + 1]);
                var y:Number = (p[b + 2] - p[a + 2]) * (p[c] - p[a]) - (p[b] - p[a]) * (p[c + 2] - p[a + 2]);
                var z:Number = (p[b] - p[a]) * (p[c + 1] - p[a + 1]) - (p[b + 1] - p[a + 1]) * (p[c] - p[a]);
                var area:Number = Math.sqrt(x * x + y * y + z * z);
                var longest:Number = 0;
                for (var e:int = 0; e < 3; e++)
                {
                    var from:int = 3 * t[i + e];
                    var to:int = 3 * t[i + (e + 1) % 3];
                    longest = Math.max(longest, Math.sqrt(Math.pow(p[to] - p[from], 2) + Math.pow(p[to + 1] - p[from + 1], 2)
                                + Math.pow(p[to + 2] - p[from + 2], 2)));
                }
                // the plane of a narrow triangle says little about what is far from it
                if (area < 1e-3 * hull.extent * longest)
                {
                    continue;
                }
                for (var k:int = 0; k < v.length; k += 3)
                {
                    var distance:Number = ((v[k] - p[a]) * x + (v[k + 1] - p[a + 1]) * y + (v[k + 2] - p[a + 2]) * z) / area;
                    if (distance > 50 * allowed)
                    {
                        fail(name + ": vertex " + k / 3 + " is outside by " + distance);
                    }
                }
            }
        }

        private static function checkMesh(name:String, hull:ConvexHull):void
        {
            var corners:int = hull.indices.length;
            var i:int;
            assertEquals(name, 3 * corners, hull.points.length);
            for (i = 0; i < corners; i++)
            {
                assertTrue(name + ": ascending", i == 0 || hull.indices[i] > hull.indices[i - 1]);
                assertEquals(name, hull.vertices[3 * hull.indices[i] + 1], hull.points[3 * i + 1]);
            }
            assertEquals(name + ": triangles", hull.dimension == 3 ? 2 * corners - 4 : 0, hull.triangles.length / 3);
            assertEquals(name + ": outline", hull.dimension == 2 ? corners : 0, hull.outline.length);
            // each edge runs the other way in the neighbouring triangle, so this throws if the surface has a gap
            edgesAcross(hull.triangles, corners);
            var area:Number = 0;
            for (i = 0; i < hull.outline.length; i++)
            {
                var at:int = 3 * hull.outline[i];
                var next:int = 3 * hull.outline[(i + 1) % corners];
                area += along(hull, 0, at) * along(hull, 1, next) - along(hull, 1, at) * along(hull, 0, next);
            }
            assertTrue(name + ": an area of " + area, hull.dimension != 2 || area > 0);
        }

        // How far a corner is from the first one along one of the hull's axes.
        private static function along(hull:ConvexHull, axis:int, corner:int):Number
        {
            var sum:Number = 0;
            for (var i:int = 0; i < 3; i++)
            {
                sum += (hull.points[corner + i] - hull.points[i]) * hull.axes[3 * axis + i];
            }
            return sum;
        }

        // The farthest vertex in a direction is a corner.
        private static function checkSupports(name:String, hull:ConvexHull, random:SeededRandom):void
        {
            var p:Vector.<Number> = hull.points;
            for (var trial:int = 0; trial < 30; trial++)
            {
                checkSupport(name, hull, random.normal(), random.normal(), random.normal());
            }
        }

        private static function checkSupport(name:String, hull:ConvexHull, x:Number, y:Number, z:Number):void
        {
            var missing:Number = farthestAlong(hull.vertices, x, y, z) - farthestAlong(hull.points, x, y, z);
            var allowed:Number = FARTHEST_OUTSIDE * hull.extent * Math.sqrt(x * x + y * y + z * z);
            assertTrue(name + ": short by " + missing, missing <= allowed);
        }

        private static function farthestAlong(points:Vector.<Number>, x:Number, y:Number, z:Number):Number
        {
            var most:Number = -Infinity;
            for (var i:int = 0; i < points.length; i += 3)
            {
                most = Math.max(most, points[i] * x + points[i + 1] * y + points[i + 2] * z);
            }
            return most;
        }
    }
}
