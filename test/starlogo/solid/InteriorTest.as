package starlogo.solid
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.engine;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.solid.interior.Interior;
    import support.Complaints;
    import support.Effort;
    import support.SolidAngles;

    use namespace engine;

    /**
     * What is inside of random surfaces that cross themselves. Solid angles say it of a surface with two sides; of a surface with one side, the number
     * of its triangles on a ray in a random direction.
     */
    public class InteriorTest
    {
        private static const OCTAHEDRON:Vector.<uint> = new <uint>[0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];

        // The projective plane: each pair of its six vertices is an edge of two triangles.
        private static const ONE_SIDED:Vector.<uint> = new <uint>[0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 1, 1, 2, 4, 2, 3, 5, 3, 4, 1, 4, 5, 2, 5, 1, 3];

        // Points nearer to the surface than this are left out.
        private static const NEAR:Number = 1e-4;

        private var _random:SeededRandom = new SeededRandom(7402);

        [Test]
        public function pointsInSurfacesThatCrossThemselves():void
        {
            compare("octahedron", OCTAHEDRON, false);
        }

        [Test]
        public function pointsInSurfacesWithOneSide():void
        {
            compare("one-sided", ONE_SIDED, false);
        }

        /** Each corner of each triangle has a vertex of its own. Some are a little beside the others, along one axis. */
        [Test]
        public function pointsBehindSeamsThatAreOpenAlongOneAxis():void
        {
            compare("octahedron", OCTAHEDRON, true);
            compare("one-sided", ONE_SIDED, true);
        }

        /** No map of how far the model reaches changes what counting says. The model is shortest along each axis once. */
        [Test]
        public function aMapOfDepthsAgreesWithCounting():void
        {
            var wrong:Complaints = new Complaints();
            var inside:int = 0;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var model:Model = BuiltInModel.sphere();
                for (var i:int = 0; i < model.vertices.length; i += 3)
                {
                    var bump:Number = 1 + 0.3 * Math.sin(9 * model.vertices[i]) * Math.sin(8 * model.vertices[i + 1]);
                    for (var k:int = 0; k < 3; k++)
                    {
                        model.vertices[i + k] *= k == axis ? 0.5 * bump : bump;
                    }
                }
                var library:HierarchiesLibrary = new HierarchiesLibrary();
                library.add("bumpy", model.vertices, model.triangles);
                var interior:Interior = library.treeOf("bumpy").preparedInterior();
                for (i = 0; i < 2000; i++)
                {
                    var point:Vector3D = new Vector3D(_random.between(-0.7, 0.7), _random.between(-0.7, 0.7), _random.between(-0.7, 0.7));
                    var shells:Vector.<int> = new Vector.<int>();
                    interior.findEnclosing(point, shells);
                    inside += shells.length > 0 ? 1 : 0;
                    wrong.addIf(interior.isInside(point) != shells.length > 0, "by the map", axis + ", " + point);
                }
            }
            wrong.assertNone();
            assertTrue("inside: " + inside, inside > 300 && inside < 5000);
        }

        private function compare(name:String, triangles:Vector.<uint>, hasSeams:Boolean):void
        {
            var wrong:Complaints = new Complaints();
            var inside:int = 0;
            var count:int = 0;
            for (var i:int = Effort.choose(60, 1000, 10); i > 0; i--)
            {
                var model:Model = randomModel(name, triangles, hasSeams);
                var library:HierarchiesLibrary = new HierarchiesLibrary();
                library.add(name, model.vertices, withSomeReversed(model.triangles));
                var tree:ModelTree = library.treeOf(name);
                assertTrue("closed", tree.preparedInterior().hasClosedShell);
                for (var k:int = 0; k < 25; k++)
                {
                    var point:Vector3D = k % 2 == 0 ? between(model) : besideAVertex(model);
                    var expected:Boolean = isInside(model, point);
                    if (isNearTheSurface(model, point, expected))
                    {
                        continue;
                    }
                    count++;
                    inside += expected ? 1 : 0;
                    wrong.addIf(tree.isInside(point, 0) != expected, "asked", "surface " + i + ", " + point + ", " + expected);
                    wrong.addIf(tree.preparedInterior().isInside(point) != expected, "counted", "surface " + i + ", " + point + ", " + expected);
                }
            }
            wrong.assertNone();
            assertTrue(inside + " inside of " + count, inside > count / 20 && inside < 19 * count / 20);
        }

        private function randomModel(name:String, triangles:Vector.<uint>, hasSeams:Boolean):Model
        {
            var corners:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < 18; i++)
            {
                corners.push(_random.between(-0.5, 0.5));
            }
            if (!hasSeams)
            {
                return new Model(name, corners, triangles, Model.AS_GIVEN);
            }
            var vertices:Vector.<Number> = new Vector.<Number>();
            var own:Vector.<uint> = new Vector.<uint>();
            for (i = 0; i < triangles.length; i++)
            {
                var at:int = 3 * triangles[i];
                var axis:int = _random.integer(0, 8);
                for (var k:int = 0; k < 3; k++)
                {
                    vertices.push(corners[at + k] + (k == axis ? 5e-8 : 0));
                }
                own.push(i);
            }
            return new Model(name, vertices, own, Model.AS_GIVEN);
        }

        private function withSomeReversed(triangles:Vector.<uint>):Vector.<uint>
        {
            var turned:Vector.<uint> = triangles.slice();
            for (var i:int = 0; i < turned.length; i += 3)
            {
                if (_random.next() < 0.3)
                {
                    turned[i] = triangles[i + 1];
                    turned[i + 1] = triangles[i];
                }
            }
            return turned;
        }

        private function between(model:Model):Vector3D
        {
            var a:int = cornerOf(model);
            var b:int = cornerOf(model);
            var t:Number = _random.between(0, 1);
            return new Vector3D(model.vertices[a] + t * (model.vertices[b] - model.vertices[a]), model.vertices[a + 1] + t * (model.vertices[b + 1] - model.vertices[a + 1]),
                    model.vertices[a + 2] + t * (model.vertices[b + 2] - model.vertices[a + 2])).add(new Vector3D(jitter(), jitter(), jitter()));
        }

        // A ray along an axis from there passes through a vertex.
        private function besideAVertex(model:Model):Vector3D
        {
            var a:int = cornerOf(model);
            var point:Vector3D = new Vector3D(model.vertices[a], model.vertices[a + 1], model.vertices[a + 2]);
            var axis:String = _random.pick(["x", "y", "z"]);
            point[axis] += _random.between(-0.5, 0.5);
            return point;
        }

        private function cornerOf(model:Model):int
        {
            return 3 * _random.integer(0, model.vertices.length / 3 - 1);
        }

        private function jitter():Number
        {
            return _random.between(-0.1, 0.1);
        }

        private function isNearTheSurface(model:Model, point:Vector3D, isInsideThere:Boolean):Boolean
        {
            for (var i:int = 0; i < 6; i++)
            {
                var by:Number = i < 3 ? NEAR : -NEAR;
                var other:Vector3D = new Vector3D(point.x + (i % 3 == 0 ? by : 0), point.y + (i % 3 == 1 ? by : 0), point.z + (i % 3 == 2 ? by : 0));
                if (isInside(model, other) != isInsideThere)
                {
                    return true;
                }
            }
            return false;
        }

        private function isInside(model:Model, point:Vector3D):Boolean
        {
            return model.name == "one-sided" ? crossings(model, point) % 2 == 1 : Math.abs(SolidAngles.windingAround(model, point.x, point.y, point.z)) > 0.5;
        }

        // The triangles on a ray from a point, after Moeller and Trumbore.
        private static function crossings(model:Model, from:Vector3D):int
        {
            var direction:Vector3D = new Vector3D(0.3217, 0.5713, 0.7549);
            var count:int = 0;
            for (var i:int = 0; i < model.triangles.length; i += 3)
            {
                var a:Vector3D = vertexOf(model, i);
                var toB:Vector3D = vertexOf(model, i + 1).subtract(a);
                var toC:Vector3D = vertexOf(model, i + 2).subtract(a);
                var across:Vector3D = direction.crossProduct(toC);
                var volume:Number = toB.dotProduct(across);
                var toFrom:Vector3D = from.subtract(a);
                var u:Number = toFrom.dotProduct(across) / volume;
                var v:Number = direction.dotProduct(toFrom.crossProduct(toB)) / volume;
                count += u >= 0 && v >= 0 && u + v <= 1 && toC.dotProduct(toFrom.crossProduct(toB)) / volume > 0 ? 1 : 0;
            }
            return count;
        }

        private static function vertexOf(model:Model, corner:int):Vector3D
        {
            var at:int = 3 * model.triangles[corner];
            return new Vector3D(model.vertices[at], model.vertices[at + 1], model.vertices[at + 2]);
        }
    }
}
