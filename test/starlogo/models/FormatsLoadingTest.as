package starlogo.models
{
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import flash.events.IOErrorEvent;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.async.Async;
    import support.Collada;
    import support.Gltf;
    import support.SlowReceiver;
    import support.assertThrows;
    import support.encoded;
    import support.whenComplete;

    /** A ModelLoader tells formats apart by what is in the files, whatever they are called, and fetches what is beside a glTF file. */
    public class FormatsLoadingTest
    {
        private static const OBJ:String = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
        private static const STL:String = "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid\n";
        private static const DOCUMENT:String = Collada.document(Collada.geometry("a", "0 0 0 1 0 0 1 1 0", Collada.triangles("0 1 2")));

        private var _loader:TestedLoader = new TestedLoader(new SlowReceiver(0), 200);
        private var _log:Array = [];

        [Before]
        public function setUp():void
        {
            _loader.addEventListener(ModelEvent.LOADED, function(event:ModelEvent):void
                {
                    _log.push(event.model.name + " " + event.model.triangles.length / 3);
                });
            _loader.addEventListener(ErrorEvent.ERROR, function(event:ErrorEvent):void
                {
                    _log.push(event.text);
                });
        }

        [Test(async, timeout="150000")]
        public function fetchesNothingFromElsewhere():void
        {
            var addresses:Array = ["../../x.bin", "\t//other.host/x", "ht\ntps://other.host/x", "\\\\other.host\\x", "%2e%2e/x.bin", "//other.host/x", "a/../../x"];
            for each (var address:String in addresses)
            {
                _loader.load("a", "model.gltf");
                _loader.load("b", "http://host?model");
                _loader.fetches[_loader.fetches.length - 2].deliver(Gltf.tetrahedron().toTextBytes(address));
                _loader.fetches[_loader.fetches.length - 1].deliver(Gltf.tetrahedron().toTextBytes(address));
            }
            _loader.load("c", "http://host?model");
            _loader.fetches[_loader.fetches.length - 1].deliver(Gltf.tetrahedron().toTextBytes("other.host/x.bin"));
            _loader.addEventListener("progress", function(event:Event):void
                {
                    if (_loader.fetches.length == 16)
                    {
                        _loader.fetches[15].deliver(Gltf.tetrahedron().binary);
                    }
                });
            whenComplete(this, _loader, function():void
                {
                    assertEquals(16, _loader.fetches.length);
                    assertEquals("http://host/other.host/x.bin", _loader.fetches[15].addresses.join());
                    assertEquals("c 4", _log.pop());
                    assertEquals(14, _log.length);
                    for each (var line:String in _log)
                    {
                        assertTrue(line, line.indexOf("buffers[0].uri: expected data, or a path from the file's folder on") > 0);
                    }
                });
        }

        /** A scaling in the place of the axis would otherwise be ignored where a file names its own axis. */
        [Test]
        public function aWrongUpAxisOrScalingIsRefusedAtOnce():void
        {
            for each (var text:String in [OBJ, STL, DOCUMENT, Gltf.tetrahedron().toText()])
            {
                assertThrows(ArgumentError, /"a": the up axis must be .* not "as given": a scaling is the argument after it/, _loader.loadText, "a", text, Model.AS_GIVEN);
            }
            assertThrows(ArgumentError, 'model "a": the up axis must be', _loader.load, "a", "a.obj", "up");
            assertThrows(ArgumentError, 'model "b": the scaling must be', _loader.load, "b", "b.dae", "z", "huge");
            assertThrows(ArgumentError, 'model "b": the up axis must be', _loader.loadBytes, "b", new ByteArray(), 7);
            assertEquals(0, _loader.pendingCount);
            assertEquals(0, _loader.fetches.length);
        }

        [Test(async, timeout="150000")]
        public function aBinaryStlFileOfTooManyBytesIsRefused():void
        {
            var bytes:ByteArray = new ByteArray();
            bytes.length = 67108865;
            _loader.loadBytes("a", bytes);
            whenComplete(this, _loader, function():void
                {
                    assertEquals("model \"a\": the file has 67108865 bytes: expected at most 67108864", _log.join());
                });
        }

        [Test(async, timeout="150000")]
        public function tellsFormatsApartWhateverTheyAreCalled():void
        {
            var files:Array = ["obj", encoded(OBJ), "stl", encoded(STL), "binary stl", binaryStl(), "gltf", Gltf.tetrahedron().toTextBytes(),
                    "glb", Gltf.tetrahedron().toBinary(), "COLLADA", encoded(DOCUMENT)];
            var names:Array = ["a.obj", "a.stl", "a.glb?x=1", "a.gltf", "a.dae", "a.png", "a"];
            for each (var name:String in names)
            {
                for (var i:int = 0; i < files.length; i += 2)
                {
                    _loader.load(files[i], name);
                    _loader.fetches[_loader.fetches.length - 1].deliver(files[i + 1]);
                }
            }
            // what says nothing is what it is called
            for each (name in ["a.stl", "a.gltf", "a.dae", "a.obj", "a", "a.stl?v=1.obj", "a.stl#x"])
            {
                _loader.load("nothing", name);
                _loader.fetches[_loader.fetches.length - 1].deliver(encoded("# nothing"));
            }
            _loader.loadText("text", OBJ);
            _loader.loadText("text", STL);
            _loader.loadText("text", Gltf.tetrahedron().toText());
            _loader.loadText("text", "\uFEFF \n" + Gltf.tetrahedron().toText());
            _loader.loadText("text", DOCUMENT);
            _loader.loadBytes("bytes", Gltf.tetrahedron().toBinary());
            var wanted:int = _loader.pendingCount;
            whenComplete(this, _loader, function():void
                {
                    assertEquals(wanted, _log.length);
                    assertEquals('no vertices: expected facets; its JSON; this is; no vertices, so this is no OBJ; no vertices, so this is no OBJ; no vertices: expected facets; no vertices: expected facets',
                            nothings());
                    for each (var line:String in _log)
                    {
                        assertTrue(line, /^(obj|stl|binary stl|COLLADA) 1$|^(gltf|glb|bytes) 4$|^text [14]$/.test(line));
                    }
                });
        }

        // The beginnings of what is said of "nothing", which is taken out of the log.
        private function nothings():String
        {
            var all:Array = [];
            for (var i:int = _log.length - 1; i >= 0; i--)
            {
                var words:Array = _log[i].match(/^model "nothing"[^:]*: (\w+ \w+(: \w+ \w+|, so this is no \w+)?)/);
                if (words != null)
                {
                    all.unshift(words[1]);
                    _log.splice(i, 1);
                }
            }
            return all.join("; ");
        }

        [Test(async, timeout="150000")]
        public function fetchesWhatIsBesideAFile():void
        {
            var file:Gltf = Gltf.tetrahedron();
            var isDelivered:Boolean = false;
            _loader.load("a", "http://host/models/bear.gltf?v=1#x");
            _loader.load("b", "bear.gltf");
            _loader.load("lost", "lost.gltf");
            _loader.loadBytes("bytes", file.toTextBytes("bear.bin"));
            _loader.fetches[0].deliver(file.toTextBytes("parts/bear.bin"));
            _loader.fetches[1].deliver(file.toTextBytes("bear.bin"));
            _loader.fetches[2].deliver(file.toTextBytes("lost.bin"));
            _loader.addEventListener("progress", function(event:Event):void
                {
                    if (_loader.fetches.length == 6 && !isDelivered)
                    {
                        isDelivered = true;
                        _loader.fetches[3].deliver(file.binary);
                        _loader.fetches[4].deliver(file.binary);
                        _loader.fetches[5].dispatchEvent(new IOErrorEvent(IOErrorEvent.IO_ERROR, false, false, "404"));
                    }
                });
            whenComplete(this, _loader, function():void
                {
                    _log.sort();
                    assertEquals("http://host/models/parts/bear.bin,bear.bin,lost.bin", [_loader.fetches[3].addresses, _loader.fetches[4].addresses,
                                _loader.fetches[5].addresses].join());
                    assertEquals('a 4\nb 4\nmodel "bytes", buffers[0].uri: it is in another file, and the address of this file is not known: load() fetches both\n' +
                            'model "lost", buffers[0].uri: its file can\'t be fetched: lost.bin (404)', _log.join("\n"));
                });
        }

        [Test(async, timeout="150000")]
        public function cancelledLoadsFetchNothingMore():void
        {
            _loader.load("a", "bear.gltf");
            _loader.fetches[0].deliver(Gltf.tetrahedron().toTextBytes("bear.bin"));
            _loader.addEventListener("progress", function(event:Event):void
                {
                    if (_loader.fetches.length == 2)
                    {
                        _loader.cancel("a");
                    }
                });
            Async.handleEvent(this, _loader, Event.CANCEL, function(event:Event, data:Object):void
                {
                    assertEquals(1, _loader.fetches[1].closeCount);
                    assertEquals(0, _log.length);
                }, 120000);
        }

        private static function binaryStl():ByteArray
        {
            var bytes:ByteArray = encoded("solid");
            bytes.length = 84;
            bytes[80] = 1;
            bytes.position = 96;
            for each (var number:Number in [0, 0, 0, 1, 0, 0, 1, 1, 0])
            {
                bytes.endian = "littleEndian";
                bytes.writeFloat(number);
            }
            bytes.writeShort(0);
            return bytes;
        }
    }
}
