package starlogo.models.files
{
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import starlogo.models.ColladaModel;
    import starlogo.models.ObjModel;
    import support.Collada;
    import support.Failures;
    import support.encoded;

    public class ModelFileTest
    {
        private static const OBJ:String = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n# \u00E9\u4E2D\n";
        private static const DOCUMENT:String = Collada.document(Collada.geometry("\u00E9", "0 0 0 1 0 0 1 1 0",
                    Collada.triangles("0 1 2")), "", Collada.Z_UP);

        [Test]
        public function readsTextInAnyEncoding():void
        {
            assertObj("utf-8", []);
            assertObj("utf-8", [0xEF, 0xBB, 0xBF]);
            assertObj("unicode", [0xFF, 0xFE]);
            assertObj("unicodeFFFE", [0xFE, 0xFF]);
        }

        [Test]
        public function readsDocumentsInAnyEncoding():void
        {
            for each (var encoding:String in ["utf-8", "unicode", "unicodeFFFE", "iso-8859-1", "windows-1252"])
            {
                var bytes:ByteArray = bytesOf('<?xml version="1.0" encoding="' + encoding + '"?>' + DOCUMENT,
                        encoding, []);
                assertEquals(encoding, "0,1,2", ColladaModel.fromBytes("a", bytes).triangles.join());
            }
        }

        [Test]
        public function everyByteIsTheRightLetter():void
        {
            assertEquals("\u20AC\u0178\u0081\u00E9A", ModelFile.latin(bytesOf("\u0080\u009F\u0081\u00E9A", "latin", []), true));
            assertEquals("\u0080\u009F\u0081\u00E9A", ModelFile.latin(bytesOf("\u0080\u009F\u0081\u00E9A", "latin", []), false));
            var long:String = new Array(2000).join("\u4E2D\uD83D\uDE00");
            assertEquals(long, ModelFile.utf16(bytesOf(long, "unicode", []), true));
            assertEquals("an odd byte", "ab", ModelFile.utf16(bytesOf("ab", "unicodeFFFE", [], 1), false));
            assertEquals("a zero ends a text", "ab", ModelFile.utf16(bytesOf("ab\u0000c", "unicode", []), true));
            assertEquals("", ModelFile.latin(new ByteArray(), true));
        }

        [Test]
        public function saysWhatIsWrongWithBytes():void
        {
            fails("empty", new ByteArray());
            fails("binary", bytesOf("\u0089PNG\r\n\u001A\n", "iso-8859-1", [], 40));
            fails("binary", bytesOf("<COLLADA>\u00E9" + new Array(3000).join(" "), "utf-8", [], 40));
            fails("this is a zip archive (.zae is one too): unpack it", bytesOf("PK\u0003\u0004\u0014", "iso-8859-1", [], 40));
        }

        private static function assertObj(encoding:String, mark:Array):void
        {
            assertEquals(encoding, "0,1,2", ObjModel.fromBytes("a", bytesOf(OBJ, encoding, mark)).triangles.join());
        }

        private static function bytesOf(text:String, encoding:String, mark:Array, zeros:int = 0):ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            for each (var byte:int in mark)
            {
                bytes.writeByte(byte);
            }
            bytes.writeBytes(encoded(text, encoding));
            bytes.length += zeros;
            return bytes;
        }

        private static function fails(words:String, bytes:ByteArray):void
        {
            Failures.assertFails("", words, ColladaModel.fromBytes, "a", bytes);
        }
    }
}
