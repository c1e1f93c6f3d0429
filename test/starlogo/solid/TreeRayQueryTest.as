package starlogo.solid
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.intersection.ray.RaySpan;
    import starlogo.intersection.ray.SpanFinder;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Effort;
    import support.Fixtures;
    import support.PlainDistance;
    import support.SolidModels;

    use namespace engine;

    /** Rays against models: through edges and corners, and by their hierarchies at every depth. CastTest compares them with loops over all triangles. */
    public class TreeRayQueryTest
    {
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/kelp.obj", "/assets/fortress.obj", "/assets/seagull.dae"];

        private static const DEPTHS:Array = [1, 2, 3, 5, 8, 40];

        private var _rays:TreeRayQuery = new TreeRayQuery();
        private var _entry:RayCrossing = new RayCrossing();
        private var _random:SeededRandom = new SeededRandom(2211);
        private var _structures:RandomStructures = new RandomStructures(_random);

        [Test]
        public function noRaySlipsThroughAnEdgeOrAVertex():void
        {
            var closed:Array = models().filter(function(model:Model, ...rest):Boolean
                {
                    return hierarchyOf(model).preparedInterior().hasClosedShell;
                });
            assertTrue("closed ones: " + closed.length, closed.length > 5);
            var count:int = Effort.choose(20000, 1000000) / closed.length + 1;
            for each (var model:Model in closed)
            {
                castThroughEdges(model, count);
            }
        }

        // From outside, past nothing but the surface; and from inside, where a ray that slipped through would meet nothing.
        private function castThroughEdges(model:Model, count:int):void
        {
            var hierarchy:ModelTree = hierarchyOf(model);
            var tree:BoxTree = hierarchy.treeFor(BoxTree.EXACT);
            var corners:Vector.<Number> = new Vector.<Number>(9);
            var hit:RayCrossing = new RayCrossing();
            var ray:Ray = new Ray();
            var origin:Vector3D = new Vector3D();
            var inside:Vector3D = pointInside(hierarchy);
            for (var i:int = 0; i < count; i++)
            {
                var isFromInside:Boolean = i % 2 == 0;
                if (isFromInside)
                {
                    origin.copyFrom(inside);
                }
                else
                {
                    // some along an axis, towards vertices that have simple numbers
                    origin.setTo(_random.between(-2, 2), _random.between(-2, 2), _random.pick([-1, 2]) * _random.between(1, 2));
                }
                tree.readTriangle(_random.integer(0, tree.primitiveCount - 1), corners);
                var share:Number = i % 3 == 0 ? 0 : _random.next();
                var from:int = 3 * _random.integer(0, 2);
                var to:int = (from + 3) % 9;
                var x:Number = corners[from] + share * (corners[to] - corners[from]);
                var y:Number = corners[from + 1] + share * (corners[to + 1] - corners[from + 1]);
                var z:Number = corners[from + 2] + share * (corners[to + 2] - corners[from + 2]);
                if (i % 5 == 1)
                {
                    origin.setTo(x, y, _random.pick([-3, 5]));
                }
                else if (i % 5 == 3)
                {
                    origin.setTo(_random.pick([-4, 4]), y, z);
                }
                isFromInside &&= i % 5 != 1 && i % 5 != 3;
                var direction:Vector3D = new Vector3D(x, y, z).subtract(origin);
                ray.aim(origin, direction);
                hit.distance = NaN;
                _rays.findOnSurface(hierarchy, BoxTree.EXACT, ray, hit);
                if (!(hit.distance <= direction.length + 1e-12))
                {
                    assertTrue(model.name + ", " + i + (isFromInside ? " from inside, " : " from outside, ") + origin + " to " + new Vector3D(x, y, z) + ": " + hit.distance, false);
                }
            }
        }

        [Test]
        public function visitsEveryNodeThatCounts():void
        {
            var hits:int = 0;
            for each (var model:Model in [SolidModels.openCube(), read("/assets/kelp.obj"), new Model("cloud", BuiltInModel.sphere().vertices)])
            {
                var hierarchy:ModelTree = hierarchyOf(model);
                for (var i:int = 0; i < Effort.choose(100, 1000); i++)
                {
                    var ray:Ray = randomRay();
                    var depth:int = DEPTHS[i % DEPTHS.length];
                    var expected:Number = nearestEnd(hierarchy.root, depth, ray, 0);
                    var found:Number = distanceAt(hierarchy, depth, ray);
                    hits += found < Infinity ? 1 : 0;
                    if (found > 0 && found < Infinity)
                    {
                        checkNodeNormal(model.name + ", depth " + depth, ray, _entry);
                    }
                    assertTrue(model.name + ", depth " + depth + ": " + expected + ", not " + found, expected == found || Math.abs(expected - found) < 1e-12);
                }
            }
            assertTrue("hits: " + hits, hits > 120);
        }

        // Out of a structure's surface, which no ray meets at a right angle by chance.
        private static function checkNodeNormal(message:String, ray:Ray, entry:RayCrossing):void
        {
            var normal:Vector3D = new Vector3D(entry.normal.x, entry.normal.y, entry.normal.z);
            var along:Number = normal.dotProduct(directionOf(ray));
            assertTrue(message + ": " + normal, Math.abs(normal.length - 1) < 1e-12 && along < 0 && along > -1 + 1e-12);
            assertEquals(message + ": " + normal, 1, Math.abs(normal.x) + Math.abs(normal.y) + Math.abs(normal.z));
        }

        [Test]
        public function oddTriangles():void
        {
            var ray:Ray = new Ray();
            // one alone, and none that has an area
            var one:ModelTree = hierarchyOf(new Model("one", new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0], new <uint>[0, 1, 2]));
            ray.aim(new Vector3D(one.boxTree.vertices[0], one.boxTree.vertices[1], -2), new Vector3D(0, 0, 1));
            assertEquals("through its corner", 2, distanceAt(one, BoxTree.EXACT, ray));
            var line:ModelTree = hierarchyOf(new Model("line", new <Number>[0, 0, 0, 1, 0, 0, 2, 0, 0], new <uint>[0, 1, 2]));
            ray.aim(new Vector3D(0.1, 0, -2), new Vector3D(0, 0, 1));
            distanceAt(line, BoxTree.EXACT, ray);
            // many in one place, which no division tells apart
            var vertices:Vector.<Number> = new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 1];
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < 500; i++)
            {
                triangles.push(0, 1, 2);
            }
            var pile:ModelTree = hierarchyOf(new Model("pile", vertices, triangles));
            ray.aim(new Vector3D(-0.25, -0.25, -2), new Vector3D(0, 0, 1));
            assertTrue(distanceAt(pile, BoxTree.EXACT, ray) < 3);
            ray.aim(new Vector3D(-0.25, -0.25, -2), new Vector3D(0, 0, -1));
            assertEquals(Infinity, distanceAt(pile, BoxTree.EXACT, ray));
        }

        /** A sheet has no triangles beside it that are not seen edge on. */
        [Test]
        public function aRayInThePlaneOfASheetMeetsIt():void
        {
            var vertices:Vector.<Number> = new <Number>[-0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5, 0];
            var sheet:ModelTree = hierarchyOf(new Model("sheet", vertices, new <uint>[0, 1, 2, 0, 2, 3], Model.AS_GIVEN));
            var ray:Ray = new Ray();
            for each (var z:Number in [0, 1e-15, -1e-15])
            {
                for each (var y:Number in [0.1, -0.3, 0, 0.5])
                {
                    ray.aim(new Vector3D(-3, y, z), new Vector3D(1, 0, 0));
                    var distance:Number = distanceAt(sheet, BoxTree.EXACT, ray);
                    assertTrue(z + ", " + y + ": " + distance, Math.abs(distance - 2.5) < 1e-12);
                }
                ray.aim(new Vector3D(-3, 0.5 + 1e-12, z), new Vector3D(1, 0, 0));
                assertEquals("beside it", Infinity, distanceAt(sheet, BoxTree.EXACT, ray));
                ray.aim(new Vector3D(3, 0.1, z), new Vector3D(1, 0, 0));
                assertEquals("away from it", Infinity, distanceAt(sheet, BoxTree.EXACT, ray));
            }
            ray.aim(new Vector3D(-3, 0.1, 1e-12), new Vector3D(1, 0, 0));
            assertEquals("above it", Infinity, distanceAt(sheet, BoxTree.EXACT, ray));
            // where a face that looks at the ray begins at the same place, its normal counts
            var bent:Vector.<Number> = vertices.concat(new <Number>[-0.5, -0.5, 1, -0.5, 0.5, 1]);
            var corner:ModelTree = hierarchyOf(new Model("corner", bent, new <uint>[0, 1, 2, 0, 2, 3, 0, 3, 5, 0, 5, 4], Model.AS_GIVEN));
            ray.aim(new Vector3D(-3, 0.1, 0), new Vector3D(1, 0, 0));
            assertTrue(Math.abs(distanceAt(corner, BoxTree.EXACT, ray) - 2.5) < 1e-12);
            assertEquals("its normal", -1, _entry.normal.x);
        }

        [Test]
        public function aTriangleSeenEdgeOnIsMetWhereItIs():void
        {
            var met:int = 0;
            for (var i:int = 0; i < Effort.choose(2000, 100000); i++)
            {
                var corners:Vector.<Vector3D> = new <Vector3D>[_structures.position(1), _structures.position(1), _structures.position(1)];
                if (i % 4 == 0)
                {
                    // without area
                    corners[2] = between(corners[0], corners[1], _random.next());
                }
                var vertices:Vector.<Number> = new Vector.<Number>();
                for each (var corner:Vector3D in corners)
                {
                    vertices.push(corner.x, corner.y, corner.z);
                }
                // from a point of the triangle, or of an edge, back in its plane
                var target:Vector3D = between(corners[0], between(corners[1], corners[2], _random.next()), i % 4 == 0 ? 0.5 : _random.next());
                var aside:Vector3D = i % 4 == 0 ? _structures.position(1) : between(corners[1], corners[2], _random.between(-2, 2));
                var direction:Vector3D = target.subtract(aside);
                direction.normalize();
                var ray:Ray = new Ray();
                ray.aim(new Vector3D(target.x - 4 * direction.x, target.y - 4 * direction.y, target.z - 4 * direction.z), direction);
                if (!_rays.find(hierarchyOf(new Model("one", vertices, new <uint>[0, 1, 2], Model.AS_GIVEN)), BoxTree.EXACT, ray, _entry))
                {
                    continue;
                }
                met++;
                var x:Number = ray.origin.x + _entry.distance * ray.direction.x;
                var y:Number = ray.origin.y + _entry.distance * ray.direction.y;
                var z:Number = ray.origin.z + _entry.distance * ray.direction.z;
                var gap:Number = PlainDistance.ofTriangles(new <Number>[x, y, z, x, y, z, x, y, z], 0, vertices, 0);
                assertTrue(i + ": " + gap + " beside " + corners, gap < 1e-9);
            }
            assertTrue("met: " + met, met > Effort.choose(200, 10000));
        }

        // The ray comes along the solid's thin sides, so the place where it crosses their planes is a rounding error.
        [Test]
        public function aRayAlongNarrowSidesMeetsTheirCorner():void
        {
            for (var i:int = 0; i < Effort.choose(3000, 100000); i++)
            {
                var axes:Vector.<Vector3D> = _structures.frame();
                var extents:Array = [1, _random.logBetween(1e-8, 1), _random.logBetween(1e-8, 1)];
                var corners:Vector.<Vector3D> = new Vector.<Vector3D>();
                var vertices:Vector.<Number> = new Vector.<Number>();
                for (var k:int = 0; k < 6; k++)
                {
                    var place:Number = (k % 2 == 0 ? 1 : -1) * extents[k >> 1];
                    corners[k] = axes[k >> 1].clone();
                    corners[k].scaleBy(place);
                    vertices.push(corners[k].x, corners[k].y, corners[k].z);
                }
                var octahedron:Model = new Model("octahedron", vertices, new <uint>[0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5], Model.AS_GIVEN);
                var corner:Vector3D = corners[_random.integer(0, 5)];
                var along:Vector3D = corner.subtract(corners[_random.integer(0, 5)]);
                along.scaleBy(_random.between(1, 4));
                var aside:Vector3D = _structures.position(_random.logBetween(1e-12, 0.1));
                var origin:Vector3D = corner.add(along).add(aside);
                var direction:Vector3D = corner.subtract(origin);
                var ray:Ray = new Ray();
                ray.aim(origin, direction);
                var distance:Number = distanceAt(hierarchyOf(octahedron), BoxTree.EXACT, ray);
                assertTrue(i + ": " + distance + ", not " + direction.length + ", from " + origin + " to " + corner + " of " + corners, distance <= direction.length + 1e-6);
            }
        }

        private static function between(a:Vector3D, b:Vector3D, share:Number):Vector3D
        {
            return new Vector3D(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z));
        }

        private static function models():Array
        {
            return SolidModels.all().concat(FIXTURES.map(function(address:String, ...rest):Model
                    {
                        return read(address);
                    }));
        }

        private static function read(address:String):Model
        {
            return /obj$/.test(address) ? new ObjModel(address, Fixtures.text(address)) : new ColladaModel(address, Fixtures.text(address));
        }

        private static function hierarchyOf(model:Model):ModelTree
        {
            var tree:ModelTree = new ModelTree(new BoxTree(model.vertices, model.triangles));
            tree.beginBuilding(5, 10, false, false);
            tree.finishBuilding();
            return tree;
        }

        // All end nodes, one after the other, with what is inside of their ancestors.
        private static function nearestEnd(node:HierarchyNode, depth:int, ray:Ray, from:Number):Number
        {
            var part:Ray = new Ray();
            var entry:RayCrossing = new RayCrossing();
            part.copyFrom(ray);
            part.from = from;
            var span:RaySpan = new RaySpan();
            if (!SpanFinder.find(part, node.bounds, null, span) || !entry.setToEntry(part, span))
            {
                return Infinity;
            }
            if (node.isLeaf || depth == 1)
            {
                return entry.distance;
            }
            return Math.min(nearestEnd(node.left, depth - 1, ray, entry.distance), nearestEnd(node.right, depth - 1, ray, entry.distance));
        }

        private function distanceAt(hierarchy:ModelTree, depth:int, ray:Ray):Number
        {
            return _rays.find(hierarchy, depth, ray, _entry) ? _entry.distance : Infinity;
        }

        private function pointInside(hierarchy:ModelTree):Vector3D
        {
            var box:Vector.<Number> = hierarchy.boxTree.boxes;
            var point:Vector3D = new Vector3D();
            do
            {
                point.setTo(box[0] + box[3] * _random.between(-1, 1), box[1] + box[4] * _random.between(-1, 1), box[2] + box[5] * _random.between(-1, 1));
            }
            while (!hierarchy.preparedInterior().isInside(point));
            return point;
        }

        private function randomRay():Ray
        {
            var ray:Ray = new Ray();
            var origin:Vector3D = _structures.position(_random.pick([0.5, 2]));
            var target:Vector3D = _structures.position(0.6);
            target.z += 0.5;
            ray.aim(origin, target.subtract(origin));
            return ray;
        }

        private static function directionOf(ray:Ray):Vector3D
        {
            return new Vector3D(ray.direction.x, ray.direction.y, ray.direction.z);
        }
    }
}
