package starlogo.models
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertNotNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.bounding.Capsule;
    import support.Surfaces;
    import support.assertThrows;

    public class BuiltInModelTest
    {
        [Test]
        public function sphere():void
        {
            var model:Model = BuiltInModel.sphere();
            check(model, "sphere", 223, 416, "-0.5,-0.5,0,0.5,0.5,1");
            for (var i:int = 0; i < model.vertices.length; i += 3)
            {
                var x:Number = model.vertices[i];
                var y:Number = model.vertices[i + 1];
                var z:Number = model.vertices[i + 2] - 0.5;
                assertTrue(Math.abs(x * x + y * y + z * z - 0.25) < 1e-12);
            }
            assertTrue(Surfaces.volume(model) > 0.48 && Surfaces.volume(model) < Math.PI / 6);
        }

        [Test]
        public function cube():void
        {
            var model:Model = BuiltInModel.cube();
            check(model, "cube", 24, 12, "-0.5,-0.5,0,0.5,0.5,1");
            assertEquals(1, Surfaces.volume(model));
            assertEquals(6, Surfaces.area(model.vertices, model.triangles));
        }

        [Test]
        public function cylinder():void
        {
            var model:Model = BuiltInModel.cylinder();
            check(model, "cylinder", 320, 508, "-0.5,-0.5,0,0.5,0.5,1.1314");
            var polygon:Number = 16 * 0.25 * Math.sin(Math.PI / 16);
            assertTrue(Math.abs(Surfaces.volume(model) - polygon * 1.1314) < 1e-12);
        }

        [Test]
        public function capsulesAreOfTheirRadiusAndHeight():void
        {
            check(BuiltInModel.capsule(0.25, 1.75), "capsule", 194, 384, "-0.25,-0.25,0,0.25,0.25,1.75");
            check(BuiltInModel.capsule(0.5, 1, "ball"), "ball", 178, 352, "-0.5,-0.5,0,0.5,0.5,1");
            var random:SeededRandom = new SeededRandom(7);
            for (var i:int = 0; i < 20; i++)
            {
                var radius:Number = Math.pow(10, 12 * random.next() - 6);
                var height:Number = i % 4 == 0 ? 2 * radius : radius * (2 + 5 * random.next());
                var model:Model = BuiltInModel.capsule(radius, height);
                assertTrue("closed", Surfaces.isClosed(model));
                for (var v:int = 0; v < model.vertices.length; v += 3)
                {
                    var z:Number = model.vertices[v + 2];
                    var above:Number = z - Math.max(radius, Math.min(height - radius, z));
                    var x:Number = model.vertices[v];
                    var y:Number = model.vertices[v + 1];
                    assertTrue(Math.abs(Math.sqrt(x * x + y * y + above * above) - radius) < 1e-12 * height);
                }
                var volume:Number = Math.PI * radius * radius * (height - 2 * radius / 3);
                assertTrue(Surfaces.volume(model) > 0.92 * volume && Surfaces.volume(model) < volume);
            }
        }

        [Test]
        public function aCapsuleCollidesAsOne():void
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.loadAllBoundingStructures = true;
            greatLand.addModel(BuiltInModel.capsule(0.3, 1.8));
            var fit:Capsule = greatLand.boundingStructures.tightestFit("capsule") as Capsule;
            assertNotNull(fit);
            var volume:Number = Math.PI * 0.09 * 1.6;
            assertTrue("" + fit.volume / volume, Math.abs(fit.volume / volume - 1) < 1e-3);
        }

        [Test]
        public function boxesHaveTheirLengths():void
        {
            check(BuiltInModel.box(4, 0.5, 3), "box", 24, 12, "-2,-0.25,0,2,0.25,3");
            check(BuiltInModel.box(1e-6, 1e9, 8, "wall"), "wall", 24, 12, "-5e-7,-500000000,0,5e-7,500000000,8");
            assertEquals(6, Surfaces.volume(BuiltInModel.box(4, 0.5, 3)));
        }

        [Test]
        public function sizesThatAreNoneAreRefused():void
        {
            for each (var wrong:Number in [0, -1, NaN, Infinity, -Infinity, 1.1e9])
            {
                var told:String = " must be positive and at most 1000000000, not " + wrong;
                assertThrows(RangeError, "model \"capsule\": a capsule's radius" + told, BuiltInModel.capsule, wrong, 2);
                assertThrows(RangeError, "model \"hero\": a capsule's height" + told, BuiltInModel.capsule, 1, wrong, "hero");
                assertThrows(RangeError, "model \"box\": a box's x" + told, BuiltInModel.box, wrong, 1, 1);
                assertThrows(RangeError, "model \"box\": a box's y" + told, BuiltInModel.box, 1, wrong, 1);
                assertThrows(RangeError, "model \"box\": a box's z" + told, BuiltInModel.box, 1, 1, wrong);
            }
            assertThrows(RangeError, "a capsule's height includes its caps, so it must be at least twice its radius of 1, not 1.5", BuiltInModel.capsule, 1, 1.5);
            assertThrows(ModelError, "", BuiltInModel.capsule, 1, 3, "");
            assertThrows(ModelError, "", BuiltInModel.box, 1, 1, 1, "");
        }

        private static function check(model:Model, name:String, vertices:int, triangles:int, bounds:String):void
        {
            assertEquals(name, model.name);
            assertEquals(vertices, model.vertices.length / 3);
            assertEquals(triangles, model.triangles.length / 3);
            assertEquals(bounds, Surfaces.bounds(model.vertices).join());
            assertTrue("closed", Surfaces.isClosed(model));
        }
    }
}
