package starlogo.models
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.models.building.ModelBuilder;
    import starlogo.models.building.ModelData;
    import support.Surfaces;
    import support.assertThrows;
    import support.create;

    public class ModelTest
    {
        [Test]
        public function normalisesToTheUnitFrame():void
        {
            var model:Model = new Model("bar", new <Number>[10, 20, 30, 14, 22, 38]);
            assertEquals("-0.5,-0.25,0,0.5,0.25,2", model.vertices.join());
            assertEquals("bar", model.name);
            assertNull(model.triangles);
        }

        [Test]
        public function copiesWhatItIsGiven():void
        {
            var vertices:Vector.<Number> = new <Number>[0, 0, 0, 2, 0, 0, 0, 2, 0];
            var triangles:Vector.<uint> = new <uint>[0, 1, 2];
            var model:Model = new Model("triangle", vertices, triangles);
            vertices[0] = 7;
            triangles[0] = 2;
            assertEquals("-0.5,-0.5,0,0.5,-0.5,0,-0.5,0.5,0", model.vertices.join());
            assertEquals("0,1,2", model.triangles.join());
        }

        /** A builder's lists are not copied. */
        [Test]
        public function keepsTheDataOfItsBuilder():void
        {
            var data:ModelData = new ModelData("bar");
            data.scaling = Model.FOOTPRINT;
            data.vertices.push(10, 20, 30, 14, 22, 38);
            var model:Model = new Model("bar", null, null, null, new ModelBuilder(data).build());
            assertEquals("bar", model.name);
            assertStrictlyEquals(data.vertices, model.vertices);
        }

        [Test]
        public function keepsFlatGround():void
        {
            assertEquals("-0.5,-0.5,0,0.5,0.5,0", new Model("ground", new <Number>[0, 0, 5, 8, 8, 5]).vertices.join());
        }

        [Test]
        public function scalesAVerticalLineToUnitHeight():void
        {
            assertEquals("0,0,0,0,0,1", new Model("line", new <Number>[3, 3, 1, 3, 3, 5]).vertices.join());
            var askew:Model = new Model("line", new <Number>[3, 3, 1, 3.0000000001, 3, 5]);
            assertEquals(1, askew.vertices[5]);
        }

        [Test]
        public function onlyMovesASinglePoint():void
        {
            assertEquals("0,0,0", new Model("point", new <Number>[1e300, -1e300, 1e-300]).vertices.join());
            assertEquals("0,0,0,0,0,0", new Model("point", new <Number>[7, 7, 7, 7, 7, 7]).vertices.join());
        }

        [Test]
        public function takesTheSmallestAndLargestNumbers():void
        {
            assertEquals("-0.5,0,0,0.5,0,0", new Model("small", new <Number>[0, 0, 0, Number.MIN_VALUE * 2, 0,
                            0]).vertices.join());
            assertEquals("-0.5,0,0,0.5,0,0", new Model("large", new <Number>[0, 0, 0, 1.7e308, 0, 0]).vertices.join());
        }

        [Test]
        public function keepsItsShapeHoweverItWasTurned():void
        {
            var random:SeededRandom = new SeededRandom(6);
            for (var run:int = 0; run < 200; run++)
            {
                var vertices:Vector.<Number> = cloud(random, 30);
                var placement:Matrix3D = new Matrix3D();
                placement.appendRotation(random.between(0, 360), new Vector3D(random.normal(), random.normal(), random.normal()));
                placement.appendTranslation(random.normal(), random.normal(), random.normal());
                placement.appendScale(random.logBetween(0.1, 10), random.logBetween(0.1, 10), random.logBetween(0.1, 10));
                var turned:Vector.<Number> = new Vector.<Number>(vertices.length);
                placement.transformVectors(vertices, turned);
                var model:Model = new Model("a", turned);
                assertUnitFrame(model, model.vertices);
                var ratio:Number = distance(model.vertices, 0, 3) / distance(turned, 0, 3);
                for (var i:int = 6; i < turned.length; i += 3)
                {
                    assertTrue(Math.abs(distance(model.vertices, 0, i) / distance(turned, 0, i) / ratio - 1) < 1e-9);
                }
            }
        }

        private static function distance(vertices:Vector.<Number>, a:int, b:int):Number
        {
            var x:Number = vertices[a] - vertices[b];
            var y:Number = vertices[a + 1] - vertices[b + 1];
            var z:Number = vertices[a + 2] - vertices[b + 2];
            return Math.sqrt(x * x + y * y + z * z);
        }

        [Test]
        public function refusesWhatIsNoModel():void
        {
            refuses("needs a name", "", new <Number>[0, 0, 0]);
            refuses("needs a name", null, new <Number>[0, 0, 0]);
            refuses("no vertices", "a", null);
            refuses("no vertices", "a", new Vector.<Number>());
            refuses("three coordinates", "a", new <Number>[1, 2]);
            refuses("the y coordinate of vertex 1 must be a finite number, not NaN", "a", new <Number>[1, 2, 3, 4, NaN, 6]);
            refuses("the z coordinate of vertex 0", "a", new <Number>[1, 2, Infinity]);
            refuses("too large", "a", new <Number>[1e308, 0, 0, -1e308, 0, 0]);
            refuses("three vertices", "a", new <Number>[1, 2, 3], new <uint>[0, 0]);
            refuses("triangle 1 names vertex 1", "a", new <Number>[1, 2, 3], new <uint>[0, 0, 0, 0, 0, 1]);
        }

        private static function refuses(words:String, name:String, vertices:Vector.<Number>,
                triangles:Vector.<uint> = null):void
        {
            assertThrows(ModelError, words, create, Model, name, vertices, triangles);
        }

        private static function cloud(random:SeededRandom, count:int):Vector.<Number>
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < 3 * count; i++)
            {
                vertices.push(random.between(-1, 1));
            }
            return vertices;
        }

        private static function assertUnitFrame(model:Model, expected:Vector.<Number>):void
        {
            var bounds:Vector.<Number> = Surfaces.bounds(model.vertices);
            assertEquals(1, Math.max(bounds[3] - bounds[0], bounds[4] - bounds[1]));
            assertEquals(0, bounds[0] + bounds[3]);
            assertEquals(0, bounds[1] + bounds[4]);
            assertEquals(0, bounds[2]);
            for (var i:int = 0; i < expected.length; i++)
            {
                assertTrue(Math.abs(model.vertices[i] - expected[i]) < 1e-12);
            }
        }
    }
}
