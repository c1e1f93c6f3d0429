package starlogo.models
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.models.files.ModelFile;
    import starlogo.models.gltf.GltfFile;
    import starlogo.models.gltf.GltfScene;
    import starlogo.models.text.Decimal;
    import support.Failures;
    import support.Gltf;
    import support.Surfaces;
    import support.encoded;

    /** What glTF files have. What three.js draws of random ones is compared in test/module/gltf.test.mjs. */
    public class GltfModelTest
    {
        private static const SQUARE:Array = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];

        private var _file:Gltf = new Gltf();

        [Test]
        public function readsBothKindsOfFiles():void
        {
            var file:Gltf = Gltf.tetrahedron();
            var binary:Model = GltfModel.fromBytes("a", file.toBinary());
            var text:Model = GltfModel.fromBytes("a", file.toTextBytes());
            assertEquals(binary.vertices.join(), text.vertices.join());
            assertEquals("0,2,1,0,1,3,0,3,2,1,2,3", binary.triangles.join());
            assertEquals(binary.triangles.join(), text.triangles.join());
            // y is up in the file: its z of 2 is the extent in y, its y of 4 the height
            var bounds:Vector.<Number> = Surfaces.bounds(binary.vertices);
            assertTrue(bounds.join(), Math.abs(bounds[5] - 4 / 3) < 1e-12 && Math.abs(bounds[4] - 1 / 3) < 1e-12);
            assertTrue(Surfaces.volume(binary) > 0);
        }

        /** A later 2.x may be read, because it only adds to 2.0, unless the file says that it needs more than 2.0. */
        [Test]
        public function readsLaterMinorVersions():void
        {
            for each (var asset:Object in [ {version:"2.1"}, {version:"2.1", minVersion:"2.0"}])
            {
                _file = Gltf.tetrahedron();
                _file.json.asset = asset;
                assertEquals(12, read().triangles.length);
            }
        }

        [Test]
        public function takesAnotherAxisUpOrATransform():void
        {
            var bytes:ByteArray = Gltf.tetrahedron().toBinary();
            assertEquals("0,0,0,3,0,0,0,4,0,0,0,2", GltfModel.fromBytes("a", bytes, "z", Model.AS_GIVEN).vertices.join());
            assertEquals("0,0,0,3,0,0,0,0,4,0,-2,0", positive(GltfModel.fromBytes("a", bytes, null, Model.AS_GIVEN)));
            assertEquals("0,0,0,3,0,0,0,0,4,0,-2,0", positive(GltfModel.fromBytes("a", bytes, "y", Model.AS_GIVEN)));
            assertEquals("0,0,0,0,0,3,-4,0,0,0,-2,0", positive(GltfModel.fromBytes("a", bytes, "x", Model.AS_GIVEN)));
            var moved:ModelTransform = new ModelTransform(null, null, new Vector3D(1, 2, 3));
            assertEquals("1,2,3,4,2,3,1,6,3,1,2,5", GltfModel.fromBytes("a", bytes, moved, Model.AS_GIVEN).vertices.join());
        }

        /** Positions behind the normals of their vertices: nothing stands behind the last one. */
        [Test]
        public function readsPositionsBehindNormals():void
        {
            var view:int = _file.addView([0, 0, 1, 0, 0, 0, 0, 0, 1, 3, 0, 0, 0, 0, 1, 0, 4, 0], 6, Gltf.FLOAT);
            _file.json.bufferViews[view].byteStride = 24;
            var position:int = _file.json.accessors.push({componentType: Gltf.FLOAT, type: "VEC3", count: 3, bufferView: view, byteOffset: 12}) - 1;
            _file.addMesh({attributes: {POSITION: position}});
            _file.json.nodes.push({mesh: 0});
            assertEquals("0,0,0,3,0,0,0,4,0", read().vertices.join());
        }

        [Test]
        public function readsEveryKindOfNumber():void
        {
            for each (var each:Array in [[Gltf.BYTE, 127, -128], [Gltf.UNSIGNED_BYTE, 255, 0], [Gltf.SHORT, 32767, -32768],
                        [Gltf.UNSIGNED_SHORT, 65535, 0], [Gltf.FLOAT, 1, -1]])
            {
                for each (var isNormalised:Boolean in [false, true])
                {
                    _file = new Gltf();
                    var least:Number = each[2];
                    var most:Number = each[1];
                    var position:int = _file.addNumbers([least, 0, 0, most, 0, 0, 0, most, 0], "VEC3", each[0]);
                    _file.json.accessors[position].normalized = isNormalised;
                    _file.json.extensionsRequired = ["KHR_mesh_quantization"];
                    _file.addMesh({attributes: {POSITION: position}});
                    _file.json.nodes.push({mesh: 0});
                    var low:Number = isNormalised ? (least < 0 ? -1 : 0) : least;
                    var high:Number = isNormalised ? 1 : most;
                    assertEquals([low, 0, 0, high, 0, 0, 0, high, 0].join(), read().vertices.join());
                }
            }
        }

        // Players read long numbers differently, and Ruffle keeps whole ones within 32 bits.
        [Test]
        public function numbersAreTheSameOnEveryMachine():void
        {
            for each (var word:String in ["0.22349309909760888", "-5.9066087652313134e-8", "4294967311", "123456789012345678901", "0.1", "7"])
            {
                _file = Gltf.tetrahedron();
                _file.json.nodes[0].translation = [987, 0, 0];
                _file.json.nodes[0].name = "-1234567890.5 \\\" 123456789012345";
                var text:String = _file.toText().replace("987", word).replace("\"count\":4", "\"count\":4.000000000000");
                assertEquals(word, Decimal.of(word), GltfModel.fromBytes("a", encoded(text), "z", Model.AS_GIVEN).vertices[0]);
            }
            Failures.assertFails("character " + (text.indexOf("[7") + 2), "its JSON can't be read", GltfModel.fromBytes, "a", encoded(text.replace("[7", "[123456.7.8901")));
        }

        [Test]
        public function readsTheSceneThatIsShown():void
        {
            _file = Gltf.tetrahedron();
            _file.json.nodes = [ {mesh: 0}, {mesh: 0, translation: [10, 0, 0]}, {mesh: 0, translation: [20, 0, 0]}];
            assertEquals("without scenes, all nodes", "0,23", widthOf(read()));
            _file.json.scenes = [ {nodes: [0]}, {nodes: [1]}];
            assertEquals("none is shown: all scenes", "0,13", widthOf(read()));
            _file.json.scene = 1;
            assertEquals("10,13", widthOf(read()));
            _file.json.scenes = [ {name: "a"}, {name: "b"}];
            Failures.assertFails("", "no vertices", read);
        }

        [Test]
        public function makesPointsOfWhatHasNoSurface():void
        {
            _file.addMesh({attributes: {POSITION: _file.addNumbers(SQUARE, "VEC3", Gltf.FLOAT)}, mode: 0});
            _file.json.nodes.push({mesh: 0});
            var model:Model = read();
            assertNull(model.triangles);
            assertEquals(SQUARE.join(), model.vertices.join());
            _file.addMesh({attributes: {POSITION: _file.addNumbers([5, 5, 5, 6, 5, 5, 6, 6, 5], "VEC3", Gltf.FLOAT)}});
            _file.json.nodes.push({mesh: 1});
            assertEquals("a surface alone counts", "5,5,5,6,5,5,6,6,5", read().vertices.join());
        }

        [Test]
        public function aSurfaceMayHaveThePositionsOfLoosePoints():void
        {
            var triangle:Array = [5, 5, 5, 6, 5, 5, 6, 6, 5];
            var position:int = _file.addNumbers(SQUARE.concat(), "VEC3", Gltf.FLOAT);
            _file.addMesh({attributes: {POSITION: _file.addNumbers(triangle, "VEC3", Gltf.FLOAT)}}, {attributes: {POSITION: position}, mode: 0},
                    {attributes: {POSITION: position}, indices: _file.addNumbers([0, 1, 2, 0, 2, 3], "SCALAR", Gltf.UNSIGNED_INT)});
            _file.json.nodes.push({mesh: 0});
            assertEquals(triangle.concat(SQUARE).join(), read().vertices.join());
            assertEquals("0,1,2,3,4,5,3,5,6", read().triangles.join());
        }

        [Test]
        public function leavesOutWhatNoTriangleUsesAndSharesTheRest():void
        {
            var position:int = _file.addNumbers(SQUARE.concat([7, 7, 7]), "VEC3", Gltf.FLOAT);
            _file.addMesh({attributes: {POSITION: position}, indices: _file.addNumbers([0, 1, 2], "SCALAR", Gltf.UNSIGNED_INT)},
                    {attributes: {POSITION: position}, indices: _file.addNumbers([0, 2, 3], "SCALAR", Gltf.UNSIGNED_INT)});
            _file.json.nodes.push({mesh: 0});
            assertEquals(SQUARE.join(), read().vertices.join());
            assertEquals("0,1,2,0,2,3", read().triangles.join());
        }

        [Test]
        public function takesBuffersBesideTheFile():void
        {
            var file:Gltf = Gltf.tetrahedron();
            var bytes:ByteArray = file.toTextBytes("a%20b.bin");
            var given:Object = {};
            given["a%20b.bin"] = file.binary;
            assertEquals(12, GltfModel.fromBytes("a", bytes, null, Model.FOOTPRINT, given).triangles.length);
            Failures.assertFails("buffers[0].uri", "is another file and was not given", GltfModel.fromBytes, "a", bytes);
            Failures.assertFails("buffers[0].uri", "is another file and was not given", function():void
                {
                    GltfModel.fromBytes("a", file.toTextBytes("constructor"), null, Model.FOOTPRINT, {});
                });
            for each (var uri:String in ["http://host/a.bin", "/a.bin", "\\a", "file:a", "data:,abc", "data:;base64", "data:;base64,ab$d"])
            {
                Failures.assertFails("buffers[0].uri", "expected", GltfModel.fromBytes, "a", file.toTextBytes(uri), null, Model.FOOTPRINT, {});
            }
        }

        /** Several buffers may be in one file. */
        [Test]
        public function fetchesAFileOnce():void
        {
            var file:Gltf = Gltf.tetrahedron();
            file.json.bufferViews[1].buffer = 1;
            file.json.buffers[1] = {byteLength: file.binary.length, uri: "a.bin"};
            var fetched:Array = [];
            var scene:GltfScene = new GltfScene(new GltfFile(new ModelFile("a", file.toTextBytes("a.bin")), function(uri:String):Object
                    {
                        fetched.push(uri);
                        return {bytes: file.binary, problem: null};
                    }), null, Model.FOOTPRINT);
            assertEquals(12, scene.building().build().triangles.length);
            assertEquals("a.bin", fetched.join());
        }

        /** Any character of an address may stand as its number, and its scheme and "base64" in capitals (RFC 3986, RFC 2397). */
        [Test]
        public function takesEscapedDigitsOfBase64():void
        {
            var file:Gltf = Gltf.tetrahedron();
            var uri:String = JSON.parse(file.toText()).buffers[0].uri;
            // more bytes than the buffer needs
            uri = uri.split("=")[0];
            uri += ["", "", "AA", "A"][(uri.length - uri.indexOf(",") - 1) % 4] + "//++AA==";
            var escaped:String = uri.substring(0, uri.indexOf(",") + 1)
                + uri.substr(uri.indexOf(",") + 1).split("+").join("%2B").split("/").join("%2f").split("=").join("%3D");
            assertTrue(escaped, /%2f%2f%2B%2BAA%3D%3D$/.test(escaped));
            assertEquals(GltfModel.fromBytes("a", file.toTextBytes(uri)).vertices.join(), GltfModel.fromBytes("a", file.toTextBytes(escaped)).vertices.join());
            assertEquals(GltfModel.fromBytes("a", file.toTextBytes(uri)).vertices.join(),
                    GltfModel.fromBytes("a", file.toTextBytes("Data:;BASE64" + uri.substr(uri.indexOf(",")))).vertices.join());
            Failures.assertFails("buffers[0].uri", "expected base64", GltfModel.fromBytes, "a", file.toTextBytes("data:;base64,AB%zzCD%"));
        }

        [Test]
        public function refusesWhatIsCompressedInWordsThatSayWhatToDo():void
        {
            // the names of what cannot be read say what to do
            for each (var each:Array in [["KHR_draco_mesh_compression", "Draco.*without compression"], ["EXT_meshopt_compression", "meshopt.*gltfpack"],
                        ["KHR_meshopt_compression", "meshopt"], ["ACME_curves", "needs the extension \"ACME_curves\""]])
            {
                _file = Gltf.tetrahedron();
                _file.json.extensionsUsed = [each[0]];
                assertEquals("it may do without", 12, read().triangles.length);
                _file.json.extensionsRequired = ["KHR_materials_unlit", "KHR_texture_transform", each[0]];
                var error:ModelError = Failures.of(read);
                assertEquals("extensionsRequired", error.place);
                assertTrue(error.message, new RegExp(each[1]).test(error.message));
            }
            _file = Gltf.tetrahedron();
            _file.json.meshes[0].primitives[0].extensions = {KHR_draco_mesh_compression: {}};
            Failures.assertFails("meshes[0].primitives[0]", "Draco", read);
            _file = Gltf.tetrahedron();
            _file.json.buffers.push({byteLength: 100});
            _file.json.bufferViews[0].buffer = 1;
            _file.json.bufferViews[0].extensions = {EXT_meshopt_compression: {}};
            Failures.assertFails("bufferViews[0]", "meshopt", read);
        }

        private function read():Model
        {
            return GltfModel.fromBytes("a", _file.toBinary(), "z", Model.AS_GIVEN);
        }

        private static function widthOf(model:Model):String
        {
            var bounds:Vector.<Number> = Surfaces.bounds(model.vertices);
            return bounds[0] + "," + bounds[3];
        }

        // -0 as 0
        private static function positive(model:Model):String
        {
            var numbers:Array = [];
            for each (var number:Number in model.vertices)
            {
                numbers.push(number + 0);
            }
            return numbers.join();
        }
    }
}
