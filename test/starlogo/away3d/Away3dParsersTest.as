package starlogo.away3d
{
    import away3d.events.LoaderEvent;
    import away3d.loaders.Loader3D;
    import away3d.loaders.parsers.DAEParser;
    import away3d.loaders.parsers.OBJParser;
    import away3d.loaders.parsers.ParserBase;
    import flash.net.URLRequest;
    import flash.utils.Dictionary;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.async.Async;
    import starlogo.geometry.vertices.PointTable;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Fixtures;
    import support.Surfaces;

    /** The game's files as Away3D's parsers read them, against this project's readers: the same model. */
    public class Away3dParsersTest
    {
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/dragon.dae", "/assets/seagull.dae", "/assets/tree.obj", "/assets/kelp.obj",
                "/assets/fortress.obj", "/assets/spaceship.obj", "/assets/fireman.dae", "/assets/person.dae"];

        private static const TIME_OUT:int = 60000;

        [Test(async)]
        public function bear():void
        {
            compare("bear.obj");
        }

        [Test(async)]
        public function tree():void
        {
            compare("tree.obj");
        }

        [Test(async)]
        public function kelp():void
        {
            compare("kelp.obj");
        }

        [Test(async)]
        public function fortress():void
        {
            compare("fortress.obj");
        }

        [Test(async)]
        public function spaceship():void
        {
            compare("spaceship.obj");
        }

        [Test(async)]
        public function dragon():void
        {
            compare("dragon.dae");
        }

        [Test(async)]
        public function seagull():void
        {
            compare("seagull.dae");
        }

        [Test(async)]
        public function fireman():void
        {
            compare("fireman.dae");
        }

        [Test(async)]
        public function person():void
        {
            compare("person.dae");
        }

        private function compare(file:String):void
        {
            var isObj:Boolean = file.slice(-4) == ".obj";
            var text:String = Fixtures.text("/assets/" + file);
            // Away3D takes y for up whatever the file says
            var expected:Model = isObj ? new ObjModel(file, text, "y") : new ColladaModel(file, text.replace(/<up_axis>.*?<\/up_axis>/, "<up_axis>Y_UP</up_axis>"));
            var parser:ParserBase = isObj ? new OBJParser() : new DAEParser();
            var loader:Loader3D = new Loader3D(false);
            loader.addEventListener(LoaderEvent.RESOURCE_COMPLETE, Async.asyncHandler(this, function(event:LoaderEvent, data:Object):void
                    {
                        assertSame(expected, new Away3dModel(file, loader));
                    }, TIME_OUT));
            loader.load(new URLRequest("/assets/" + file), null, null, parser);
        }

        private static function assertSame(expected:Model, model:Away3dModel):void
        {
            var name:String = model.name;
            var welded:Model = weldedModel(expected);
            assertEquals(name, welded.vertices.length / 3, model.vertices.length / 3);
            assertEquals(name, welded.triangles.length / 3, model.triangles.length / 3);
            var expectedTriangles:Dictionary = trianglesOf(welded, welded);
            var triangles:Dictionary = trianglesOf(model, welded);
            for (var triangle:String in expectedTriangles)
            {
                assertEquals(name + ": " + triangle, expectedTriangles[triangle], triangles[triangle]);
            }
            var volume:Number = Surfaces.volume(welded);
            assertTrue(name + ": " + volume, Math.abs(Surfaces.volume(model) - volume) < 1e-5 * Math.abs(volume) + 1e-6);
        }

        // Each triangle by its corners, from the least on, with how often there is one: a corner is known by the vertex of a
        // reference that is within a millionth of it.
        private static function trianglesOf(model:Model, reference:Model):Dictionary
        {
            var numbers:Vector.<int> = numbersIn(model, reference);
            var found:Dictionary = new Dictionary();
            for (var i:int = 0; i < model.triangles.length; i += 3)
            {
                var corners:Array = [numbers[model.triangles[i]], numbers[model.triangles[i + 1]], numbers[model.triangles[i + 2]]];
                while (corners[0] != Math.min(corners[0], corners[1], corners[2]))
                {
                    corners.push(corners.shift());
                }
                found[corners.join()] = int(found[corners.join()]) + 1;
            }
            return found;
        }

        private static function numbersIn(model:Model, reference:Model):Vector.<int>
        {
            var byX:Array = [];
            for (var i:int = 0; i < reference.vertices.length; i += 3)
            {
                byX.push({x: reference.vertices[i], vertex: i / 3});
            }
            byX.sortOn("x", Array.NUMERIC);
            var numbers:Vector.<int> = new Vector.<int>();
            for (i = 0; i < model.vertices.length; i += 3)
            {
                numbers.push(nearest(byX, reference.vertices, model.vertices[i], model.vertices[i + 1], model.vertices[i + 2]));
            }
            return numbers;
        }

        private static function nearest(byX:Array, vertices:Vector.<Number>, x:Number, y:Number, z:Number):int
        {
            var low:int = 0;
            var high:int = byX.length;
            while (low < high)
            {
                var middle:int = (low + high) / 2;
                if (byX[middle].x < x - 1e-6)
                {
                    low = middle + 1;
                }
                else
                {
                    high = middle;
                }
            }
            for (var i:int = low; i < byX.length && byX[i].x <= x + 1e-6; i++)
            {
                var vertex:int = byX[i].vertex;
                if (Math.abs(vertices[3 * vertex + 1] - y) <= 1e-6 && Math.abs(vertices[3 * vertex + 2] - z) <= 1e-6)
                {
                    return vertex;
                }
            }
            throw new Error("no vertex is within a millionth of " + [x, y, z]);
        }

        // Our readers keep a file's vertices apart where they are at one place.
        private static function weldedModel(model:Model):Model
        {
            var points:PointTable = new PointTable(model.vertices.length / 3);
            var triangles:Vector.<uint> = new Vector.<uint>();
            for each (var vertex:uint in model.triangles)
            {
                triangles.push(points.add(model.vertices[3 * vertex], model.vertices[3 * vertex + 1], model.vertices[3 * vertex + 2]));
            }
            return new Model(model.name, points.coordinates, triangles);
        }
    }
}
