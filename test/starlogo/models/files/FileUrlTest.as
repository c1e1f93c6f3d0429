package starlogo.models.files
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;

    /** Addresses in files never lead out of the folder of the file, whatever a browser or server makes of them. */
    public class FileUrlTest
    {
        [Test]
        public function filesInTheFolderAndBelow():void
        {
            for each (var inside:String in ["a.bin", "./a.bin", "a/b/c.bin", "my model.bin", "my%20model.bin", "a.b.c", "%E2%82%AC.bin", "\u20AC.bin",
                        "a.bin?v=1", "a%.bin", "a/./b.bin", "100%25.bin", "a.../b.bin"])
            {
                assertTrue(inside, FileUrl.isWithin(inside));
            }
        }

        [Test]
        public function nothingElse():void
        {
            for each (var outside:String in ["", "../a.bin", "../../x", "a/../../b", "a/..", "..", "/a.bin", "//other.host/a", "https://other.host/a", "http:a",
                        "HTTPS://x", "file:///etc/passwd", "data:x", "blob:x", "C:/a", "C:\\a", "\\a", "\\\\other.host\\a", "a\\..\\..\\b", "\t//other.host/x",
                        " //other.host/x", "\n/x", "ht\ntps://other.host/x", "ht\ttps:x", "a\r.bin", ".\t./x", "./../x", "%2e%2e/x", "%2E./x", ".%2e/x",
                        "a/%2e%2e/%2e%2e/x", "%2Fx", "%2f%2fother.host", "%5Cx", "%5c%5Cother.host/x", "%252e%252e/x", "%25252e./x", "https%3A//x", "%09//x",
                        "a/ ../b", "a/%20../b", "\u0000a", "a\u007F", "%00", "%u002e%u002e/x", "a/..;/x", new Array(2002).join("a")])
            {
                assertFalse(outside, FileUrl.isWithin(outside));
            }
        }

        [Test]
        public function noFileIsBesideWhatHasNoFolder():void
        {
            for each (var alone:String in ["data:model/gltf+json,{}", "DATA:x", "blob:https://host/1", "Blob:x", "", null])
            {
                assertFalse(alone, FileUrl.hasFolder(alone));
            }
            assertTrue(FileUrl.hasFolder("models/data.obj"));
        }

        [Test]
        public function folders():void
        {
            var folders:Object = {"": "", "a.gltf": "", "models/a.gltf": "models/", "/a.gltf": "/", "https://host": "https://host/", "https://host?a/b": "https://host/",
                    "https://host/a.gltf": "https://host/", "//host": "//host/", "//host/b/a.gltf?c=/d#e/f": "//host/b/", "file:///a/b.gltf": "file:///a/",
                    "app:/a/b.gltf": "app:/a/", "../a.gltf": "../"};
            for (var url:String in folders)
            {
                assertEquals(url, folders[url], FileUrl.folderOf(url));
            }
        }
    }
}
