package starlogo.solid
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Fixtures;
    import support.SolidAngles;
    import support.SolidModels;
    import support.assertWellFormed;

    use namespace engine;

    /** The hierarchies of the game's models: well-formed, and right about what is inside. */
    public class ModelTreeTest
    {
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/kelp.obj", "/assets/fortress.obj", "/assets/spaceship.obj",
                "/assets/tree.obj", "/assets/seagull.dae", "/assets/person.dae", "/assets/fireman.dae", "/assets/dragon.dae"];

        [Test]
        public function modelsOfTheGameAreWellFormed():void
        {
            FIXTURES.forEach(checkModel);
        }

        [Test]
        public function knowsWhatIsInside():void
        {
            compareWithSolidAngles("/assets/bear.obj", 151);
            compareWithSolidAngles("/assets/fortress.obj", 152);
            compareWithSolidAngles("/assets/seagull.dae", 153);
        }

        /** A model may be posed in the middle of the work that makes its tree. The tree is made when the work is done, not before. */
        [Test]
        public function aTreeInTheMakingIsNotMade():void
        {
            var random:SeededRandom = new SeededRandom(5104);
            for each (var model:Model in SolidModels.all())
            {
                var tree:ModelTree = new ModelTree(new BoxTree(model.vertices, model.triangles));
                tree.beginBuilding(5, 10, random.chance(), false);
                var posedAt:int = random.integer(0, 6);
                for (var step:int = 0; tree.building.step(); step++)
                {
                    assertFalse(model.name + " in step " + step, tree.boxTree.isMade);
                    if (step == posedAt)
                    {
                        tree.refit();
                    }
                }
                assertTrue(model.name, tree.boxTree.isMade);
                var root:HierarchyNode = tree.root;
                tree.refit();
                assertEquals("a node is a view, also of what is posed", root, tree.root);
            }
        }

        // A point from which a ray along an axis is clear is outside. This is known without the surface.
        [Test]
        public function aPointWithAClearRayIsOutside():void
        {
            var random:SeededRandom = new SeededRandom(5103);
            var spared:int = 0;
            var insides:int = 0;
            for each (var model:Model in SolidModels.all())
            {
                var known:ModelTree = hierarchyOf(model.vertices, model.triangles);
                known.preparedInterior();
                for (var i:int = 0; i < 20; i++)
                {
                    var point:Vector3D = new Vector3D(random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(0, 1));
                    var asked:ModelTree = hierarchyOf(model.vertices, model.triangles);
                    var isInside:Boolean = known.isInside(point, 0);
                    assertEquals(model.name + " at " + point, isInside, asked.isInside(point, 0));
                    insides += isInside ? 1 : 0;
                    spared += asked.isExactPrepared ? 0 : 1;
                }
            }
            assertTrue(insides + " inside, " + spared + " spared", insides > 20 && spared > 10);
        }

        [Test]
        public function piecesThatCrossAreSolidWhereBothAreAndHoweverTheyAreTurned():void
        {
            var model:Model = SolidModels.crossed();
            var triangles:Vector.<uint> = model.triangles.slice();
            var first:uint = triangles[0];
            triangles[0] = triangles[1];
            triangles[1] = first;
            var hierarchy:ModelTree = hierarchyOf(model.vertices, triangles);
            var random:SeededRandom = new SeededRandom(154);
            var inside:int = 0;
            for (var i:int = 0; i < 300; i++)
            {
                var x:Number = random.between(-0.6, 0.6);
                var y:Number = random.between(-0.6, 0.6);
                var z:Number = random.between(-0.2, 1.2);
                var expected:Boolean = SolidAngles.windingAround(model, x, y, z) > 0.5;
                inside += expected ? 1 : 0;
                assertEquals(expected, hierarchy.preparedInterior().isInside(new Vector3D(x, y, z)));
            }
            assertTrue("inside: " + inside, inside > 50 && inside < 250);
        }

        [Test]
        public function eachComponentHasATriangle():void
        {
            for each (var expected:Array in [[SolidModels.crossed(), 3], [SolidModels.doll(), 3], [SolidModels.apart(), 3], [BuiltInModel.sphere(), 1]])
            {
                var hierarchy:ModelTree = hierarchyOf(expected[0].vertices, expected[0].triangles);
                assertEquals(expected[0].name, expected[1], hierarchy.preparedInterior().surface.componentTriangles.length);
            }
        }

        [Test]
        public function insideBehindSeamsThatAreOpenByARounding():void
        {
            var random:SeededRandom = new SeededRandom(155);
            var model:Model = BuiltInModel.sphere();
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < model.triangles.length; i++)
            {
                for (var axis:int = 0; axis < 3; axis++)
                {
                    // drawn in a little: along each edge there is a gap
                    var corner:Number = model.vertices[3 * model.triangles[i] + axis];
                    var middle:Number = model.vertices[3 * model.triangles[i - i % 3] + axis] / 3 + model.vertices[3 * model.triangles[i - i % 3 + 1] + axis] / 3
                        + model.vertices[3 * model.triangles[i - i % 3 + 2] + axis] / 3;
                    vertices.push(corner + 4e-7 * (middle - corner));
                }
                triangles.push(i);
            }
            checkAlongRays(hierarchyOf(vertices, triangles), model, random);
        }

        [Test]
        public function raysThroughEdgesAndCornersAreCounted():void
        {
            var random:SeededRandom = new SeededRandom(156);
            for each (var address:String in ["/assets/bear.obj", "/assets/fortress.obj"])
            {
                var model:Model = read(address);
                checkAlongRays(hierarchyOf(model.vertices, model.triangles), model, random);
            }
            model = BuiltInModel.sphere();
            checkAlongRays(hierarchyOf(model.vertices, model.triangles), model, random);
        }

        // Points from which a ray along an axis passes through an edge or a corner.
        private static function checkAlongRays(hierarchy:ModelTree, model:Model, random:SeededRandom):void
        {
            var inside:int = 0;
            assertTrue("closed", hierarchy.preparedInterior().hasClosedShell);
            for (var i:int = 0; i < 400; i++)
            {
                var corner:int = random.integer(0, model.triangles.length - 1);
                var a:int = 3 * model.triangles[corner];
                var b:int = 3 * model.triangles[corner % 3 == 2 ? corner - 2 : corner + 1];
                var t:Number = random.pick([0, random.between(0, 1)]);
                var back:Number = random.pick([-1, 1]) * random.between(0.02, 0.6);
                var axis:int = random.integer(0, 2);
                var x:Number = model.vertices[a] + t * (model.vertices[b] - model.vertices[a]) - (axis == 0 ? back : 0);
                var y:Number = model.vertices[a + 1] + t * (model.vertices[b + 1] - model.vertices[a + 1]) - (axis == 1 ? back : 0);
                var z:Number = model.vertices[a + 2] + t * (model.vertices[b + 2] - model.vertices[a + 2]) - (axis == 2 ? back : 0);
                if (isOnSurface(model, x, y, z))
                {
                    continue;
                }
                var expected:Boolean = Math.abs(SolidAngles.windingAround(model, x, y, z)) > 0.5;
                inside += expected ? 1 : 0;
                assertEquals(model.name + ", point " + i, expected, hierarchy.preparedInterior().isInside(new Vector3D(x, y, z)));
            }
            assertTrue("inside: " + inside, inside > 10 && inside < 390);
        }

        // Whether the windings around points on both sides differ.
        private static function isOnSurface(model:Model, x:Number, y:Number, z:Number):Boolean
        {
            var windings:Array = [];
            for (var i:int = -1; i <= 1; i += 2)
            {
                windings.push(SolidAngles.windingAround(model, x + i * 1e-6, y, z), SolidAngles.windingAround(model, x, y + i * 1e-6, z),
                        SolidAngles.windingAround(model, x, y, z + i * 1e-6));
            }
            windings.sort(Array.NUMERIC);
            return windings[5] - windings[0] > 0.01;
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
            var hierarchy:ModelTree = hierarchyOf(model.vertices, model.triangles);
            assertTrue("closed", hierarchy.preparedInterior().hasClosedShell);
            var random:SeededRandom = new SeededRandom(seed);
            var inside:int = 0;
            for (var i:int = 0; i < 150; i++)
            {
                var near:int = 3 * random.integer(0, model.vertices.length / 3 - 1);
                var spread:Number = random.pick([0.2, 0.01]);
                var x:Number = model.vertices[near] + spread * random.normal();
                var y:Number = model.vertices[near + 1] + spread * random.normal();
                var z:Number = model.vertices[near + 2] + spread * random.normal();
                var expected:Boolean = Math.abs(SolidAngles.windingAround(model, x, y, z)) > 0.5;
                inside += expected ? 1 : 0;
                assertEquals("point " + i, expected, hierarchy.preparedInterior().isInside(new Vector3D(x, y, z)));
            }
            assertTrue("inside: " + inside, inside > 20 && inside < 130);
        }

        private static function hierarchyOf(vertices:Vector.<Number>, triangles:Vector.<uint>):ModelTree
        {
            var library:HierarchiesLibrary = new HierarchiesLibrary();
            library.add("model", vertices, triangles);
            assertWellFormed(library, "model", vertices, triangles);
            return library.treeOf("model");
        }

        private static function read(address:String):Model
        {
            return /obj$/.test(address) ? new ObjModel(address, Fixtures.text(address)) : new ColladaModel(address, Fixtures.text(address));
        }
    }
}
