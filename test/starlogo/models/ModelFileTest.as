package starlogo.models
{
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import support.Collada;
    import support.Failures;
    import support.Zip;
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
            assertEquals("\u20AC\u0178\u0081\u00E9A", WideText.latin(bytesOf("\u0080\u009F\u0081\u00E9A", "latin", []), true));
            assertEquals("\u0080\u009F\u0081\u00E9A", WideText.latin(bytesOf("\u0080\u009F\u0081\u00E9A", "latin", []), false));
            var long:String = new Array(2000).join("\u4E2D\uD83D\uDE00");
            assertEquals(long, WideText.utf16(bytesOf(long, "unicode", []), true));
            assertEquals("an odd byte", "ab", WideText.utf16(bytesOf("ab", "unicodeFFFE", [], 1), false));
            assertEquals("a zero ends a text", "ab", WideText.utf16(bytesOf("ab\u0000c", "unicode", []), true));
            assertEquals("", WideText.latin(new ByteArray(), true));
        }

        [Test]
        public function readsArchives():void
        {
            assertEquals("0,1,2", ColladaModel.fromBytes("a", Zip.of(["a.dae", DOCUMENT])).triangles.join());
            assertEquals("0,1,2", ColladaModel.fromBytes("a", Zip.of(["image.png", "", "b/a.DAE", DOCUMENT],
                            false)).triangles.join());
            assertEquals("0,1,2", ColladaModel.fromBytes("a", Zip.of(["no.dae", "<a/>", "manifest.xml",
                                '<?xml version="1.0"?>\n<dae_root> ./a%20b.dae#x</dae_root>', "a b.dae",
                                DOCUMENT])).triangles.join());
        }

        [Test]
        public function saysWhatIsWrongWithBytes():void
        {
            fails("empty", null);
            fails("empty", new ByteArray());
            fails("binary", bytesOf("\u0089PNG\r\n\u001A\n", "iso-8859-1", [], 40));
            fails("binary", bytesOf("<COLLADA>\u00E9" + new Array(3000).join(" "), "utf-8", [], 40));
            fails("no COLLADA document", Zip.of(["a.obj", OBJ]));
            fails("directory is missing", cut(Zip.of(["a.dae", DOCUMENT]), 30));
            fails("the file is empty", Zip.of(["a.dae", ""], false));
        }

        [Test]
        public function refusesDamagedArchives():void
        {
            var archive:ByteArray = Zip.of(["a.dae", DOCUMENT]);
            var directory:int = archive.length - 22 - 46 - 5;
            fails("encrypted", changed(archive, directory + 8, 1));
            fails("encrypted", changed(archive, directory + 10, 9));
            fails("should have", changed(archive, directory + 24, 7));
            fails("at most", changed(archive, directory + 27, 200));
            fails("cut off", changed(archive, directory + 22, 200));
            fails("not where", changed(archive, directory + 42, 3));
            fails("not where", changed(archive, directory + 45, 200));
            fails("damaged at file 1 of 1", changed(archive, directory, 3));
            fails("cut off at file 1 of 1", changed(archive, directory + 29, 200));
            fails("can't be unpacked", changed(archive, 30 + 5, 255));
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

        private static function cut(bytes:ByteArray, count:int):ByteArray
        {
            bytes.length -= count;
            return bytes;
        }

        private static function changed(bytes:ByteArray, position:int, value:int):ByteArray
        {
            var copy:ByteArray = new ByteArray();
            copy.writeBytes(bytes);
            copy[position] = value;
            return copy;
        }

        private static function fails(words:String, bytes:ByteArray):void
        {
            Failures.assertFails("", words, function():void
                {
                    ColladaModel.fromBytes("a", bytes);
                });
        }
    }
}
