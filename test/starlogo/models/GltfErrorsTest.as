package starlogo.models
{
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import support.Failures;
    import support.Gltf;
    import support.assertThrows;

    /** glTF files that are wrong: each is refused, and the error says where. */
    public class GltfErrorsTest
    {
        [Test]
        public function saysWhere():void
        {
            refuses("asset.version", "expected glTF 2.0", function(json:Object):void
                {
                    delete json.asset;
                });
            refuses("asset.version", "found \"1.0\"", function(json:Object):void
                {
                    json.asset.version = "1.0";
                });
            refuses("asset.version", "found \"2\"", function(json:Object):void
                {
                    json.asset.version = "2";
                });
            refuses("asset.version", "found \"2.5\"", function(json:Object):void
                {
                    json.asset.minVersion = "2.5";
                });
            // a value whose toString() is no function
            refuses("asset.version", "found an object", changed("asset", {version: {toString: 1}}));
            refuses("extensionsRequired", "the extension \"an object\"", changed("extensionsRequired", [ {toString: 1}]));
            refuses("extensionsRequired", "the extension \"a list\"", changed("extensionsRequired", [["KHR_mesh_quantization"]]));
            refuses("nodes[0].mesh", "one of 1 meshes, but found \"\uE0020\"", setIn("nodes", {mesh: "\uE0020"}));
            refuses("asset", "expected an object, but found a list", changed("asset", []));
            refuses("nodes", "expected a list, but found an object", changed("nodes", {}));
            refuses("nodes[0]", "expected an object, but found null", changed("nodes", [null]));
            refuses("nodes[0].mesh", "one of 1 meshes, but found 1", setIn("nodes", {mesh: 1}));
            refuses("nodes[0].mesh", "but found \"0\"", setIn("nodes", {mesh: "0"}));
            refuses("nodes[0].mesh", "but found 0.5", setIn("nodes", {mesh: 0.5}));
            refuses("nodes[0].mesh", "but found -1", setIn("nodes", {mesh: -1}));
            refuses("nodes[0].mesh", "but found null", setIn("nodes", {mesh: null}));
            refuses("nodes[0].children[0]", "contains itself", setIn("nodes", {children: [0]}));
            refuses("nodes[0].children[0]", "one of 1 nodes", setIn("nodes", {children: [1]}));
            refuses("nodes[0].matrix", "expected 16 numbers, but found 1", setIn("nodes", {matrix: [1]}));
            refuses("nodes[0].scale[2]", "expected a finite number, but found \"1\"", setIn("nodes", {scale: [1, 1, "1"]}));
            refuses("nodes[0].skin", "one of 0 skins", setIn("nodes", {skin: 0}));
            refuses("scene", "one of 0 scenes", changed("scene", 0));
            refuses("scenes[0].nodes[0]", "one of 1 nodes", changed("scenes", [ {nodes: [7]}]));
            refuses("meshes[0].primitives", "expected a list", setIn("meshes", {primitives: 5}));
            refuses("meshes[0].primitives[0]", "expected an object", setIn("meshes", {primitives: ["a"]}));
            refuses("meshes[0].primitives[0].mode", "from 0 to 6, but found 7", setIn("meshes", {primitives: [ {attributes: {POSITION: 0}, mode: 7}]}));
            refuses("meshes[0].primitives[0].attributes.POSITION", "one of 2 accessors", setIn("meshes", {primitives: [ {attributes: {POSITION: 2}}]}));
            refuses("meshes[0].primitives[0].indices", "one of 2 accessors", setIn("meshes", {primitives: [ {attributes: {POSITION: 0}, indices: "a"}]}));
            refuses("", "no vertices", setIn("meshes", {primitives: [ {attributes: {NORMAL: 0}}]}));
            refuses("accessors[0].type", "expected \"VEC3\", but found \"VEC2\"", setIn("accessors", {type: "VEC2"}));
            refuses("accessors[0].type", "but found nothing", setIn("accessors", {type: undefined}));
            refuses("accessors[0]", "it needs 12000012 bytes of bufferViews[0]", setIn("accessors", {count: 1000001}));
            refuses("accessors[0].count", "but found nothing", setIn("accessors", {count: undefined}));
            refuses("accessors[0].componentType", "but found 5124", setIn("accessors", {componentType: 5124}));
            refuses("accessors[0].bufferView", "one of 2 bufferViews", setIn("accessors", {bufferView: 9}));
            refuses("accessors[0]", "it needs 60 bytes of bufferViews[0], which has 48", setIn("accessors", {count: 5}));
            refuses("accessors[0]", "it needs 49 bytes", setIn("accessors", {byteOffset: 1}));
            refuses("accessors[0].byteOffset", "but found -4", setIn("accessors", {byteOffset: -4}));
            refuses("accessors[0].sparse", "expected indices and values", setIn("accessors", {sparse: {count: 1}}));
            refuses("accessors[0].sparse.count", "from 0 to 4", setIn("accessors", {sparse: {count: 5}}));
            refuses("bufferViews[0].byteStride", "expected at least 12", setIn("bufferViews", {byteStride: 8}));
            refuses("bufferViews[0].byteStride", "from 0 to 252", setIn("bufferViews", {byteStride: 256}));
            refuses("bufferViews[0].buffer", "one of 1 buffers", setIn("bufferViews", {buffer: 1}));
            refuses("bufferViews[0]", "it ends at byte", setIn("bufferViews", {byteOffset: 1000}));
            refuses("buffers[0]", "it should have 1000 bytes", setIn("buffers", {byteLength: 1000}));
            refuses("extensionsRequired", "expected a list", changed("extensionsRequired", "KHR"));
        }

        [Test]
        public function checksIndicesAndSparseIndices():void
        {
            var file:Gltf = new Gltf();
            file.addMesh({attributes: {POSITION: file.addNumbers([0, 0, 0, 1, 0, 0, 0, 1, 0], "VEC3", Gltf.FLOAT)},
                        indices: file.addNumbers([0, 1, 3], "SCALAR", Gltf.UNSIGNED_BYTE)});
            file.json.nodes.push({mesh: 0});
            Failures.assertFails("accessors[1]", "element 2 names vertex 3: meshes[0].primitives[0] has 3", GltfModel.fromBytes, "a", file.toBinary());
            file.json.accessors[0].sparse = {count: 1, indices: {bufferView: file.addView([3], 1, Gltf.UNSIGNED_SHORT), componentType: Gltf.UNSIGNED_SHORT},
                    values: {bufferView: file.addView([1, 1, 1], 3, Gltf.FLOAT)}};
            Failures.assertFails("accessors[0].sparse.indices", "element 0 is 3, but there are only 3", GltfModel.fromBytes, "a", file.toBinary());
        }

        [Test]
        public function verticesAreFinite():void
        {
            for each (var wrong:Number in [NaN, Infinity])
            {
                var file:Gltf = new Gltf();
                file.addMesh({attributes: {POSITION: file.addNumbers([0, 0, 0, 1, wrong, 0, 0, 1, 0], "VEC3", Gltf.FLOAT)}});
                file.json.nodes.push({mesh: 0});
                Failures.assertFails("nodes[0]", "not finite numbers", GltfModel.fromBytes, "a", file.toBinary());
            }
        }

        [Test]
        public function nodesAreInNothingTwice():void
        {
            for each (var children:Array in [[[1], [0]], [[2], [2], []], [[1], [2], [0]]])
            {
                var file:Gltf = Gltf.tetrahedron();
                file.json.nodes = [];
                for each (var list:Array in children)
                {
                    file.json.nodes.push({mesh: 0, children: list});
                }
                file.json.scenes = [ {nodes: [0]}];
                var error:ModelError = Failures.of(GltfModel.fromBytes, "a", file.toBinary());
                assertTrue(error.message, /contains itself/.test(error.message));
            }
        }

        [Test]
        public function jsonHasLimits():void
        {
            var deep:String = "";
            for (var i:int = 0; i < 100000; i++)
            {
                deep += "[";
            }
            refusesText("nested deeper than 100", '{"asset":{"version":"2.0"},"extras":' + deep);
            refusesText("character 26: its JSON can't be read: it is cut off", '{"asset":{"version":"2.0"}');
            refusesText("character 28: its JSON can't be read: unexpected \"]\"", '{"asset":{"version":"2.0"}}]');
            refusesText("can't be read", '{"asset":{"version":"2.0"},"a":"');
            refusesText("can't be read", '{"asset":{"version":"2.0"},"a":"\\');
            refusesText("no object", "[]");
            refusesText("no object", "null");
            refusesText("the file is empty", "");
            // brackets in strings are no lists
            refusesText("no vertices", '{"asset":{"version":"2.0"},"a":"' + deep + '\\"' + deep + '\\\\"}');
        }

        [Test]
        public function everyBeginningOfAFileIsRefused():void
        {
            var whole:ByteArray = Gltf.tetrahedron().toBinary();
            for (var length:int = 0; length < whole.length; length++)
            {
                var part:ByteArray = new ByteArray();
                if (length > 0)
                {
                    part.writeBytes(whole, 0, length);
                }
                Failures.of(GltfModel.fromBytes, "a", part);
            }
            assertEquals(12, GltfModel.fromBytes("a", whole).triangles.length);
        }

        [Test]
        public function chunksAreChecked():void
        {
            refusesBytes("byte 4", "version 2, but found 1", 4, 1);
            refusesBytes("byte 8", "the file is cut off", 8, 100000);
            refusesBytes("byte 12", "a chunk should have", 12, 100000);
            refusesBytes("byte 12", "must be JSON", 16, 0x004E4942);
        }

        private static function changed(key:String, value:*):Function
        {
            return function(json:Object):void
            {
                json[key] = value;
            };
        }

        private static function setIn(list:String, values:Object):Function
        {
            return function(json:Object):void
            {
                for (var key:String in values)
                {
                    json[list][0][key] = values[key];
                }
            };
        }

        private static function refuses(place:String, words:String, change:Function):void
        {
            var file:Gltf = Gltf.tetrahedron();
            file.toText();
            change(file.json);
            var text:ByteArray = new ByteArray();
            text.writeUTFBytes(JSON.stringify(file.json));
            Failures.assertFails(place, words, GltfModel.fromBytes, "a", text);
        }

        private static function refusesText(words:String, text:String):void
        {
            var bytes:ByteArray = new ByteArray();
            bytes.writeUTFBytes(text);
            assertThrows(ModelError, words, GltfModel.fromBytes, "a", bytes);
        }

        private static function refusesBytes(place:String, words:String, at:int, word:uint):void
        {
            var bytes:ByteArray = Gltf.tetrahedron().toBinary();
            bytes.position = at;
            bytes.writeUnsignedInt(word);
            Failures.assertFails(place, words, GltfModel.fromBytes, "a", bytes);
        }
    }
}
