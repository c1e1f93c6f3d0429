package starlogo.models
{
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import support.Collada;
    import support.Failures;
    import support.Zip;

    /** Archives that are not what they say. */
    public class ZipBombTest
    {
        private static const DOCUMENT:String = Collada.document(Collada.geometry("a", "0 0 0 1 0 0 1 1 0",
                    Collada.triangles("0 1 2")));

        [Test]
        public function whatClaimsToBeSmallIsNotUnpacked():void
        {
            var bomb:ByteArray = zeros(40000000);
            fails("a.dae should have 100 bytes unpacked, but has more", Zip.of(["a.dae", bomb], true, 100));
            fails("manifest.xml should have 100 bytes unpacked, but has more", Zip.of(["manifest.xml", bomb], true, 100));
            fails("a.dae should have 39999999 bytes unpacked, but has more", Zip.of(["a.dae", bomb], true, 39999999));
        }

        [Test]
        public function whatIsCutOffIsNotUnpacked():void
        {
            var bomb:ByteArray = zeros(40000000);
            bomb.length -= 5;
            fails("a.dae can't be unpacked: it is cut off", Zip.of(["a.dae", bomb], true, 39999999));
        }

        [Test]
        public function whatIsAsLargeAsItSaysIsUnpacked():void
        {
            var text:String = DOCUMENT + new Array(17000001).join(" ");
            assertEquals("0,1,2", ColladaModel.fromBytes("a", Zip.of(["a.dae", text])).triangles.join());
        }

        [Test]
        public function namesOfPropertiesAreNamesOfFiles():void
        {
            for each (var name:String in ["hasOwnProperty", "toString", "constructor", "__proto__", "isPrototypeOf", "valueOf"])
            {
                var archive:ByteArray = Zip.of([name, "", "manifest.xml", "<dae_root>" + name + ".dae</dae_root>",
                            name + ".dae", DOCUMENT]);
                assertEquals(name, "0,1,2", ColladaModel.fromBytes("a", archive).triangles.join());
                assertEquals(name, "0,1,2", ColladaModel.fromBytes("a", Zip.of(["manifest.xml",
                                    "<dae_root>" + name + "</dae_root>", "a.dae", DOCUMENT])).triangles.join());
                fails("no COLLADA document", Zip.of([name, ""]));
            }
        }

        [Test]
        public function manifestsAreSmall():void
        {
            var space:String = new Array(99981).join(" ");
            assertEquals("0,1,2", ColladaModel.fromBytes("a", Zip.of(["manifest.xml", "<a>" + space + "./b.dae#c</a>",
                                "b.dae", DOCUMENT])).triangles.join());
            fails("manifest.xml has 199960 bytes unpacked: expected at most 100000", Zip.of(["manifest.xml", space + space, "b.dae", DOCUMENT]));
        }

        [Test]
        public function filesAreNotTooLarge():void
        {
            var large:ByteArray = new ByteArray();
            large.length = 67108865;
            fails("the file has 67108865 bytes", large);
        }

        private static function zeros(count:int):ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.length = count;
            bytes.deflate();
            return bytes;
        }

        private static function fails(words:String, archive:ByteArray):void
        {
            Failures.assertFails("", words, function():void
                {
                    ColladaModel.fromBytes("a", archive);
                });
        }
    }
}
