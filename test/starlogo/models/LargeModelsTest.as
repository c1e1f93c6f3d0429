package starlogo.models
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;
    import starlogo.models.collada.ColladaReader;
    import starlogo.models.obj.ObjReader;
    import starlogo.steps.Steps;
    import support.Collada;
    import support.Failures;

    /** Models of many slices are what they would be in one piece. */
    public class LargeModelsTest
    {
        private static const WIDTH:int = 90;
        private static const HEIGHT:int = 60;
        private static const SPACES:Array = [" ", "  ", "\n", " \n ", "\t", " \t", "\r\n"];

        private var _random:SeededRandom;

        // x, y, z each, those at every seventh place used by no triangle; and what is left without those
        private var _points:Array;
        private var _corners:Array;
        private var _used:Vector.<Number>;
        private var _triangles:Vector.<uint>;

        [Before]
        public function setUp():void
        {
            _random = new SeededRandom(3);
            _points = [];
            _corners = [];
            _used = new Vector.<Number>();
            _triangles = new Vector.<uint>();
            var places:Array = [];
            for (var i:int = 0; i < WIDTH * HEIGHT; i++)
            {
                if (i % 7 == 3)
                {
                    _points.push(_random.integer(-9, 9), _random.integer(-9, 9), 9);
                }
                places.push(_points.length / 3);
                var x:Number = i % WIDTH + _random.integer(0, 60) / 256;
                var y:Number = int(i / WIDTH);
                _points.push(x, y, _random.integer(0, 255) / 256);
                _used.push(x, y, _points[_points.length - 1]);
            }
            for (i = WIDTH; i < WIDTH * HEIGHT; i++)
            {
                if (i % WIDTH > 0)
                {
                    add(places, i, i - 1, i - WIDTH);
                    add(places, i - 1, i - WIDTH - 1, i - WIDTH);
                }
            }
        }

        [Test]
        public function objFiles():void
        {
            var lines:Array = [];
            for (var i:int = 0; i < _points.length; i += 3)
            {
                lines.push("v " + _points.slice(i, i + 3).join(" "));
            }
            for (i = 0; i < _corners.length; i += 3)
            {
                lines.push("f " + (_corners[i] + 1) + " " + (_corners[i + 1] + 1) + " " + (_corners[i + 2] + 1));
            }
            var text:String = lines.join("\n");
            assertSame(new Model("a", _used, _triangles), new ObjModel("a", text));
            assertSame(new Model("a", turned("y"), _triangles), new ObjModel("a", text, "y"));
            assertSame(new Model("a", turned("x"), _triangles), new ObjModel("a", text, "x"));
            assertTrue(steps(new ObjReader("a", text, "y")) > 10 + _corners.length / 20000 + _points.length / 12000);
        }

        [Test]
        public function colladaTriangles():void
        {
            var primitive:String = '<triangles count="' + _corners.length / 3 + '">' + Collada.INPUT + '<p>' + spread(_corners) + '</p></triangles>';
            var text:String = Collada.scene(Collada.geometry("a", spread(_points), primitive),
                    '<node><translate>1 2 3</translate><instance_geometry url="#a"/></node><node><instance_geometry url="#a"/></node>');
            var count:int = _used.length / 3;
            var all:Vector.<Number> = _used.map(function(value:Number, index:int, list:Vector.<Number>):Number
                {
                    return value + 1 + index % 3;
                }).concat(_used);
            var triangles:Vector.<uint> = _triangles.concat(_triangles.map(function(value:uint, index:int, list:Vector.<uint>):uint
                    {
                        return value + count;
                    }));
            assertSame(new Model("a", all, triangles), new ColladaModel("a", text));
            assertTrue(text.length > 200000);
            assertTrue(steps(new ColladaReader("a", text, null)) > text.length / 60000 + 20);
        }

        [Test]
        public function whatIsWrongAtTheEndIsFoundOut():void
        {
            var last:int = _used.length / 3 - 1;
            _used[_used.length - 2] = NaN;
            assertTrue(message().indexOf("the y coordinate of vertex " + last) >= 0);
            _used[_used.length - 2] = 0;
            _triangles[_triangles.length - 1] = last + 1;
            assertTrue(message().indexOf("triangle " + (_triangles.length / 3 - 1) + " names vertex " + (last + 1)) >= 0);
            _triangles.pop();
            assertTrue(message().indexOf("indices in all") >= 0);
            _corners[_corners.length - 1] = "x";
            assertTrue(Failures.of(function():void
                    {
                        new ColladaModel("a", Collada.document(Collada.geometry("a", _points.join(" "),
                                        '<triangles>' + Collada.INPUT + '<p>' + _corners.join(" ") + '</p></triangles>')));
                    }).message.indexOf('"x"') >= 0);
        }

        private function message():String
        {
            return Failures.of(function():void
                {
                    new Model("a", _used, _triangles);
                }).message;
        }

        private function add(places:Array, a:int, b:int, c:int):void
        {
            _corners.push(places[a], places[b], places[c]);
            _triangles.push(a, b, c);
        }

        // Divided by whatever may divide words.
        private function spread(words:Array):String
        {
            var parts:Array = [];
            for each (var word:Object in words)
            {
                parts.push(word, SPACES[_random.integer(0, SPACES.length - 1)]);
            }
            return parts.join("");
        }

        private function turned(up:String):Vector.<Number>
        {
            var result:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < _used.length; i += 3)
            {
                var x:Number = _used[i];
                var y:Number = _used[i + 1];
                var z:Number = _used[i + 2];
                if (up == "x")
                {
                    result.push(-y, -z, x);
                }
                else
                {
                    result.push(x, -z, y);
                }
            }
            return result;
        }

        private static function assertSame(expected:Model, found:Model):void
        {
            assertEquals(expected.vertices.length, found.vertices.length);
            for (var i:int = 0; i < expected.vertices.length; i++)
            {
                if (found.vertices[i] != expected.vertices[i])
                {
                    fail("coordinate " + i + " is " + found.vertices[i] + ", not " + expected.vertices[i]);
                }
            }
            assertTrue(expected.triangles.join() == found.triangles.join());
        }

        private static function steps(work:Steps):int
        {
            var count:int = 1;
            while (work.step())
            {
                count++;
            }
            return count;
        }
    }
}
