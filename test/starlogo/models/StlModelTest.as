package starlogo.models
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import support.Failures;
    import support.Surfaces;
    import support.encoded;

    public class StlModelTest
    {
        private static const TETRAHEDRON:Array = [[0, 0, 0, 0, 4, 0, 3, 0, 0], [0, 0, 0, 3, 0, 0, 0, 0, 2], [0, 0, 0, 0, 0, 2, 0, 4, 0],
                [3, 0, 0, 0, 4, 0, 0, 0, 2]];

        [Test(timeout="600000")]
        public function readsOldMacsLinesInFilesOfAnyLength():void
        {
            var bytes:ByteArray = new ByteArray();
            bytes.writeUTFBytes("solid a\r" + new Array(15001).join("facet normal 0 0 1\router loop\rvertex 0 0 0\rvertex 1 0 0\r" +
                        "vertex 0 1 0\rendloop\rendfacet\r") + "endsolid\r");
            assertTrue(bytes.length > 1000000);
            assertEquals(45000, StlModel.fromBytes("a", bytes).triangles.length);
        }

        [Test]
        public function readsBothKinds():void
        {
            var binary:Model = StlModel.fromBytes("a", binaryOf(TETRAHEDRON));
            var text:Model = StlModel.fromBytes("a", encoded(textOf(TETRAHEDRON)));
            assertEquals(binary.vertices.join(), text.vertices.join());
            assertEquals("vertices at equal places are one", 12, binary.vertices.length);
            assertEquals("0,1,2,0,2,3,0,3,1,2,1,3", binary.triangles.join());
            assertEquals(binary.triangles.join(), text.triangles.join());
            assertTrue(Surfaces.volume(binary) > 0);
        }

        [Test]
        public function aBinaryFileMayBeginLikeText():void
        {
            assertEquals(12, StlModel.fromBytes("a", binaryOf(TETRAHEDRON, "solid facet normal 0 0 1\n")).triangles.length);
            var trailing:ByteArray = binaryOf(TETRAHEDRON, "solid");
            trailing.position = trailing.length;
            trailing.writeUTFBytes("more");
            assertEquals(12, StlModel.fromBytes("a", trailing).triangles.length);
        }

        [Test]
        public function takesAnAxisUpOrATransformAndAScaling():void
        {
            var bytes:ByteArray = binaryOf([[0, 0, 0, 1, 0, 0, 0, 2, 0]]);
            assertEquals("0,0,0,1,0,0,0,2,0", StlModel.fromBytes("a", bytes, "z", Model.AS_GIVEN).vertices.join());
            assertEquals(2, StlModel.fromBytes("a", bytes, "y", Model.AS_GIVEN).vertices[8]);
            var moved:ModelTransform = new ModelTransform(null, null, new Vector3D(1, 2, 3));
            assertEquals("1,2,3,2,2,3,1,4,3", StlModel.fromBytes("a", bytes, moved, Model.AS_GIVEN).vertices.join());
        }

        [Test]
        public function readsTextHoweverItIsWritten():void
        {
            var facet:String = "facet normal 0 0 0 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet";
            for each (var text:String in [textOf(TETRAHEDRON.slice(0, 1)), textOf(TETRAHEDRON.slice(0, 1)).split("\n").join("\r\n"),
                        "SOLID A VERTEX\nFACET NORMAL 0 0 0\n OUTER LOOP\n\tVERTEX 0 0 0\n\tVERTEX\t1e0  0 0\nVERTEX 0 1 -0\nENDLOOP\nENDFACET\nENDSOLID",
                        "\uFEFFsolid\n\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\ncolor 1 0 0\nendfacet\n"])
            {
                assertEquals(text, 3, StlModel.fromBytes("a", encoded(text)).triangles.length);
            }
            var two:String = textOf(TETRAHEDRON.slice(0, 2)) + textOf([]) + textOf(TETRAHEDRON.slice(2));
            assertEquals("several solids make one model", 12, StlModel.fromBytes("a", encoded(two)).triangles.length);
            var comma:String = facet.replace("vertex 1 0 0", "vertex 2,5 0 0");
            assertEquals("a decimal comma", 2.5, StlModel.fromBytes("a", encoded("solid\n" + comma), "z", Model.AS_GIVEN).vertices[3]);
            assertEquals("all in one line", 6, StlModel.fromBytes("a", encoded("solid a\n" + facet + " " + facet)).triangles.length);
        }

        [Test]
        public function saysWhatIsWrongAndWhere():void
        {
            refuses("", "the file is empty", "");
            refuses("", "no vertices", textOf([]));
            refuses("line 4", "expected a vertex, three finite numbers, but found \"vertex 0 0\"", "solid\nfacet\nouter loop\nvertex 0 0\n");
            refuses("line 4", "but found \"vertex a b c\"", "solid\nfacet\nouter loop\nvertex a b c\n");
            refuses("line 4", "but found \"vertex 1,000.5 2 3\"", "solid\nfacet\nouter loop\nvertex 1,000.5 2 3\n");
            refuses("line 4", "but found \"vertex 1 2 Infinity\"", "solid\nfacet\nouter loop\nvertex 1 2 Infinity\n");
            refuses("line 4", "expected a facet of three vertices, but found 1", "solid\nouter loop\nvertex 1 2 3\nendloop\n");
            refuses("line 5", "a facet has more than three vertices", "solid\nvertex 1 2 3\nvertex 1 2 3\nvertex 1 2 3\nvertex 1 2 3\n");
            refuses("line 3", "a loop begins before", "solid\nvertex 1 2 3\nouter loop\n");
            refuses("line 3", "the file is cut off", "solid\nvertex 1 2 3\nvertex 1 2 3");
            for each (var vertex:Array in [[NaN, 2, 3], [1, NaN, 3], [1, 2, NaN]])
            {
                var triangle:Array = [0, 0, 0].concat(vertex, [0, 0, 0]);
                Failures.assertFails("triangle 1", "three finite numbers for a vertex, but found " + vertex.join(", "), StlModel.fromBytes, "a",
                        binaryOf([TETRAHEDRON[0], triangle]));
            }
            Failures.assertFails("", "no vertices", StlModel.fromBytes, "a", binaryOf([]));
            var other:ByteArray = binaryOf([]);
            other.length = 200;
            Failures.assertFails("", "no STL file", StlModel.fromBytes, "a", other);
            Failures.assertFails("", "the up axis must be", StlModel.fromBytes, "a", binaryOf(TETRAHEDRON), "up");
            var whole:ByteArray = binaryOf(TETRAHEDRON);
            for (var length:int = 0; length < whole.length; length++)
            {
                var part:ByteArray = new ByteArray();
                if (length > 0)
                {
                    part.writeBytes(whole, 0, length);
                }
                Failures.of(StlModel.fromBytes, "a", part);
            }
            Failures.assertFails("", "no STL file, or one that is cut off", StlModel.fromBytes, "a", part);
        }

        private static function binaryOf(facets:Array, header:String = ""):ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.endian = Endian.LITTLE_ENDIAN;
            bytes.writeUTFBytes(header);
            bytes.length = 80;
            bytes.position = 80;
            bytes.writeUnsignedInt(facets.length);
            for each (var facet:Array in facets)
            {
                for each (var number:Number in [0, 0, 0].concat(facet))
                {
                    bytes.writeFloat(number);
                }
                bytes.writeShort(0);
            }
            return bytes;
        }

        private static function textOf(facets:Array):String
        {
            var text:String = "solid vertex of something\n";
            for each (var f:Array in facets)
            {
                text += "  facet normal 0 0 0\n    outer loop\n";
                for (var i:int = 0; i < 9; i += 3)
                {
                    text += "      vertex " + f[i] + " " + f[i + 1] + " " + f[i + 2] + "\n";
                }
                text += "    endloop\n  endfacet\n";
            }
            return text + "endsolid vertex of something\n";
        }

        private static function refuses(place:String, words:String, text:String):void
        {
            Failures.assertFails(place, words, StlModel.fromBytes, "a", encoded(text));
        }
    }
}
