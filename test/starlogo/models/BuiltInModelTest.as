package starlogo.models
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import support.Surfaces;

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
