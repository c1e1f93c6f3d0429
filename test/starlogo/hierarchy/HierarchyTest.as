package starlogo.hierarchy
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.engine;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Fixtures;
    import support.assertWellFormed;

    use namespace engine;

    /** The hierarchies of the game's models: well-formed, and right about what is inside. */
    public class HierarchyTest
    {
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/kelp.obj", "/assets/fortress.obj", "/assets/spaceship.obj",
                "/assets/tree.obj", "/assets/seagull.dae", "/assets/person.dae", "/assets/fireman.dae", "/assets/dragon.dae"];

        [Test]
        public function smallModelsOfTheGameAreWellFormed():void
        {
            FIXTURES.slice(0, 5).forEach(checkModel);
        }

        [Test]
        public function largerModelsOfTheGameAreWellFormed():void
        {
            FIXTURES.slice(5, 8).forEach(checkModel);
        }

        [Test]
        public function theDragonIsWellFormed():void
        {
            FIXTURES.slice(8).forEach(checkModel);
        }

        [Test]
        public function knowsWhatIsInsideTheBear():void
        {
            compareWithSolidAngles("/assets/bear.obj", 151);
        }

        [Test]
        public function knowsWhatIsInsideTheFortress():void
        {
            compareWithSolidAngles("/assets/fortress.obj", 152);
        }

        [Test]
        public function knowsWhatIsInsideTheSeagull():void
        {
            compareWithSolidAngles("/assets/seagull.dae", 153);
        }

        [Test]
        public function anUnorientedSurfaceHasAnInsideToo():void
        {
            var cube:Model = BuiltInModel.cube();
            var triangles:Vector.<uint> = cube.triangles.slice();
            for (var i:int = 0; i < triangles.length; i += 6)
            {
                var first:uint = triangles[i];
                triangles[i] = triangles[i + 1];
                triangles[i + 1] = first;
            }
            var hierarchy:Hierarchy = hierarchyOf(cube.vertices, triangles);
            assertTrue(hierarchy.solid.isInside(0.1, 0.2, 0.3));
            assertTrue(hierarchy.solid.isInside(0, 0, 0.5));
            assertTrue(!hierarchy.solid.isInside(0.51, 0, 0.5));
        }

        [Test]
        public function aHollowSolidHasAnOutsideInside():void
        {
            // a cube within a cube, its faces turned inwards
            var cube:Model = BuiltInModel.cube();
            var vertices:Vector.<Number> = cube.vertices.slice();
            var triangles:Vector.<uint> = cube.triangles.slice();
            vertices.fixed = triangles.fixed = false;
            for (var i:int = 0; i < cube.vertices.length; i++)
            {
                vertices.push(i % 3 == 2 ? 0.25 + cube.vertices[i] / 2 : cube.vertices[i] / 2);
            }
            for (i = 0; i < cube.triangles.length; i += 3)
            {
                triangles.push(cube.triangles[i] + 24, cube.triangles[i + 2] + 24, cube.triangles[i + 1] + 24);
            }
            var hierarchy:Hierarchy = hierarchyOf(vertices, triangles);
            assertTrue("in the wall", hierarchy.solid.isInside(0.4, 0, 0.5));
            assertTrue("in the hollow", !hierarchy.solid.isInside(0, 0, 0.5));
        }

        private static function checkModel(address:String, index:int, all:Array):void
        {
            var model:Model = read(address);
            var library:HierarchiesLibrary = new HierarchiesLibrary();
            library.splitByMean = index % 2 == 1;
            library.add(address, model.vertices, model.triangles);
            assertWellFormed(library, address, model.vertices, model.triangles);
            library.add(address, model.vertices);
            assertWellFormed(library, address, model.vertices);
        }

        // Points at random, and right beside the surface.
        private static function compareWithSolidAngles(address:String, seed:uint):void
        {
            var model:Model = read(address);
            var hierarchy:Hierarchy = hierarchyOf(model.vertices, model.triangles);
            assertTrue("closed", hierarchy.solid.isClosed);
            var random:SeededRandom = new SeededRandom(seed);
            var inside:int = 0;
            for (var i:int = 0; i < 150; i++)
            {
                var near:int = 3 * random.integer(0, model.vertices.length / 3 - 1);
                var spread:Number = random.pick([0.2, 0.01]);
                var x:Number = model.vertices[near] + spread * random.normal();
                var y:Number = model.vertices[near + 1] + spread * random.normal();
                var z:Number = model.vertices[near + 2] + spread * random.normal();
                var expected:Boolean = Math.abs(windingAround(model, x, y, z)) > 0.5;
                inside += expected ? 1 : 0;
                assertEquals("point " + i, expected, hierarchy.solid.isInside(x, y, z));
            }
            assertTrue("inside: " + inside, inside > 20 && inside < 130);
        }

        private static function windingAround(model:Model, x:Number, y:Number, z:Number):Number
        {
            var sum:Number = 0;
            for (var i:int = 0; i < model.triangles.length; i += 3)
            {
                sum += solidAngle(arm(model, i, x, y, z), arm(model, i + 1, x, y, z), arm(model, i + 2, x, y, z));
            }
            return sum / (4 * Math.PI);
        }

        private static function arm(model:Model, corner:int, x:Number, y:Number, z:Number):Array
        {
            var at:int = 3 * model.triangles[corner];
            return [model.vertices[at] - x, model.vertices[at + 1] - y, model.vertices[at + 2] - z];
        }

        // Van Oosterom and Strackee.
        private static function solidAngle(a:Array, b:Array, c:Array):Number
        {
            var volume:Number = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
            var lengthA:Number = Math.sqrt(dot(a, a));
            var lengthB:Number = Math.sqrt(dot(b, b));
            var lengthC:Number = Math.sqrt(dot(c, c));
            return 2 * Math.atan2(volume, lengthA * lengthB * lengthC + dot(a, b) * lengthC + dot(b, c) * lengthA + dot(c, a) * lengthB);
        }

        private static function dot(a:Array, b:Array):Number
        {
            return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        }

        private static function hierarchyOf(vertices:Vector.<Number>, triangles:Vector.<uint>):Hierarchy
        {
            var library:HierarchiesLibrary = new HierarchiesLibrary();
            library.add("model", vertices, triangles);
            assertWellFormed(library, "model", vertices, triangles);
            return library.hierarchy("model");
        }

        private static function read(address:String):Model
        {
            return /obj$/.test(address) ? new ObjModel(address, Fixtures.text(address)) : new ColladaModel(address, Fixtures.text(address));
        }
    }
}
