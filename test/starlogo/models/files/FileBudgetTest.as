package starlogo.models.files
{
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.models.ColladaModel;
    import starlogo.models.GltfAnimations;
    import starlogo.models.GltfModel;
    import starlogo.models.Model;
    import starlogo.models.ModelError;
    import support.Collada;
    import support.Failures;
    import support.Gltf;
    import support.assertThrows;

    /** What a file only declares, or repeats, is refused before it costs more memory or time than the file's bytes pay for. */
    public class FileBudgetTest
    {
        private static const MANY:int = 200000;
        private static const CORNER:Array = [0, 0, 0, 1, 0, 0, 0, 1, 0];

        [Test]
        public function declaredNumbersNeedBytes():void
        {
            refusesDeclared({attributes: {POSITION: 0}});
            refusesDeclared({attributes: {POSITION: 1, JOINTS_0: 2, WEIGHTS_0: 2}});
            refusesDeclared({attributes: {POSITION: 1, JOINTS_0: 1, WEIGHTS_0: 2}});
            refusesDeclared({attributes: {POSITION: 1}, targets: [ {POSITION: 0}]});
            refusesDeclared({attributes: {POSITION: 1}, indices: 3});
        }

        [Test]
        public function someNumbersWithoutDataAreZeros():void
        {
            var file:Gltf = Gltf.tetrahedron();
            file.json.accessors.push({componentType: Gltf.FLOAT, type: "VEC3", count: 4, sparse: {count: 1,
                            indices: {bufferView: file.addView([3], 1, Gltf.UNSIGNED_BYTE), componentType: Gltf.UNSIGNED_BYTE},
                            values: {bufferView: file.addView([0, 0, 4], 3, Gltf.FLOAT)}}});
            file.json.meshes[0].primitives[0].targets = [ {POSITION: 2}];
            file.json.meshes[0].weights = [0.5];
            assertEquals(4, GltfModel.fromBytes("a", file.toBinary(), "z", Model.AS_GIVEN).vertices[11]);
        }

        [Test]
        public function setsOfJointsAreReadOnce():void
        {
            var file:Gltf = skinned(2001, 30);
            assertEquals(6003, GltfModel.fromBytes("a", file.toBinary(), "z").vertices.length);
            refusesNumbers(skinned(2000, 2000).toBinary());
        }

        /** All sets are of one accessor, and have more numbers than a Vector can have. */
        [Test]
        public function setsOfJointsAreCountedBeforeTheyAreRead():void
        {
            var file:Gltf = skinned(3, 600);
            file.binary.length = 3800000;
            for (var i:int = 0; i < 2; i++)
            {
                file.json.accessors[i].count = 950000;
                file.json.bufferViews[i] = {buffer: 0, byteLength: file.binary.length};
            }
            refusesNumbers(file.toBinary());
        }

        [Test(timeout="600000")]
        public function primitivesMayShareTheirPoints():void
        {
            var file:Gltf = skinned(501, 1);
            var primitive:Object = file.json.meshes[0].primitives[0];
            for (var i:int = 1; i < 100; i++)
            {
                file.json.meshes[0].primitives.push(primitive);
            }
            assertEquals(150300, GltfModel.fromBytes("a", file.toBinary(), "z").vertices.length);
            for (i = 0; i < 2000; i++)
            {
                file.json.meshes[0].primitives.push(primitive);
            }
            refuses("more than", GltfModel.fromBytes, "a", file.toBinary());
        }

        [Test]
        public function viewsOfTheSameBytesCountAgain():void
        {
            var file:Gltf = new Gltf();
            var points:Array = [];
            for (var i:int = 0; i < 3000; i++)
            {
                points.push(i % 7, i % 5, i % 3);
            }
            file.addNumbers(points, "VEC3", Gltf.UNSIGNED_BYTE);
            var primitives:Array = [];
            for (i = 0; i < 500; i++)
            {
                file.json.accessors.push(file.json.accessors[0]);
                primitives.push({attributes: {POSITION: i}});
            }
            file.json.meshes.push({primitives: primitives});
            file.json.nodes.push({mesh: 0});
            refusesNumbers(file.toBinary());
        }

        [Test(timeout="600000")]
        public function primitivesCountForEachNode():void
        {
            var file:Gltf = new Gltf();
            var primitives:Array = [];
            for (var i:int = 0; i < 2000; i++)
            {
                primitives.push({});
                file.json.nodes.push({mesh: 0});
            }
            file.json.meshes.push({primitives: primitives});
            Failures.assertFails("meshes[0]", "each counted as often as it is placed", GltfModel.fromBytes, "a", file.toBinary());
        }

        [Test]
        public function longNumbersAreIndicesToo():void
        {
            var file:Gltf = Gltf.tetrahedron();
            file.json.nodes = [ {children: [1]}, {mesh: 0}];
            var bytes:ByteArray = new ByteArray();
            bytes.writeUTFBytes(file.toText().replace('"children":[1]', '"children":[1.000000000]'));
            assertEquals(12, GltfModel.fromBytes("a", bytes).vertices.length);
            bytes = new ByteArray();
            bytes.writeUTFBytes(file.toText().replace('"byteLength":' + file.binary.length, '"byteLength":1000.0000000'));
            Failures.assertFails("buffers[0]", "it should have 1000 bytes", GltfModel.fromBytes, "a", bytes);
        }

        /** The numbers of a key are not declared by its time: morph targets may be many. */
        [Test(timeout="600000")]
        public function keysCountForEachChannel():void
        {
            var file:Gltf = Gltf.tetrahedron();
            var input:int = file.addNumbers([0], "SCALAR", Gltf.FLOAT);
            file.json.accessors.push({componentType: Gltf.FLOAT, type: "SCALAR", count: 60000});
            for each (var interpolation:String in ["LINEAR", "CUBICSPLINE"])
            {
                var animation:Object = {channels: [], samplers: [ {input: input, output: input + 1, interpolation: interpolation}]};
                for (var i:int = 0; i < 100; i++)
                {
                    animation.channels.push({sampler: 0, target: {node: 0, path: "weights"}});
                }
                file.json.animations = [animation];
                Failures.assertFails("animations[0].samplers[0]", "numbers, each counted as often as it is used", readingAnimations, file.toBinary());
            }
        }

        [Test(timeout="600000")]
        public function aTransformIsReadOnce():void
        {
            var long:String = "<translate>0 0" + new Array(200001).join(" ") + "0</translate>";
            var places:String = new Array(1001).join('<instance_node url="#b"/>');
            var model:ColladaModel = new ColladaModel("a", Collada.scene(Collada.geometry("a", CORNER.join(" "), Collada.triangles("0 1 2")) +
                        '<library_nodes><node id="b">' + long + '<instance_geometry url="#a"/></node></library_nodes>', "<node>" + places + "</node>"));
            assertEquals(9000, model.vertices.length);
        }

        [Test(timeout="600000")]
        public function manySourcesOfOneMesh():void
        {
            var parts:Array = [];
            for (var i:int = 0; i < 8000; i++)
            {
                parts.push('<source id="p' + i + '"><float_array id="f">' + CORNER.join(" ") + '</float_array><technique_common>' +
                        '<accessor source="#f" stride="3"/></technique_common></source>' +
                        '<triangles count="1"><input semantic="POSITION" source="#p' + i + '"/><p>0 1 2</p></triangles>');
            }
            assertEquals(72000, new ColladaModel("a", Collada.document('<library_geometries><geometry id="a"><mesh>' + parts.join("") +
                            "</mesh></geometry></library_geometries>")).vertices.length);
        }

        [Test(timeout="600000")]
        public function aSourceThatIsReadAgainCountsItsText():void
        {
            var meshes:Array = [];
            for (var i:int = 0; i < 1000; i++)
            {
                meshes.push('<geometry id="g' + i + '"><mesh><triangles count="1"><input semantic="POSITION" source="#p"/><p>0 1 2</p></triangles>' +
                        "</mesh></geometry>");
            }
            refuses("each counted as often as it is used", function():void
                {
                    new ColladaModel("a", Collada.document(Collada.geometry("a", CORNER.join(" ") + new Array(200001).join(" "), Collada.triangles("0 1 2")) +
                                "<library_geometries>" + meshes.join("") + "</library_geometries>"));
                });
        }

        [Test(timeout="600000")]
        public function symbolsOfMaterialsCountForEachPlace():void
        {
            var parts:String = Collada.triangles("0 1 2");
            for (var i:int = 0; i < 1500; i++)
            {
                parts += '<triangles material="' + i + '"><input semantic="VERTEX" source="#v"/><p></p></triangles>';
            }
            var places:String = new Array(1501).join('<instance_geometry url="#a"/>');
            refuses("each counted as often as it is placed", function():void
                {
                    new ColladaModel("a", Collada.scene(Collada.geometry("a", CORNER.join(" "), parts), "<node>" + places + "</node>"));
                });
        }

        private static function refusesDeclared(primitive:Object):void
        {
            var file:Gltf = new Gltf();
            file.json.accessors = [ {componentType: Gltf.FLOAT, type: "VEC3", count: MANY}];
            file.addNumbers(CORNER, "VEC3", Gltf.FLOAT);
            file.json.accessors.push({componentType: Gltf.UNSIGNED_BYTE, type: "VEC4", count: MANY},
                    {componentType: Gltf.UNSIGNED_BYTE, type: "SCALAR", count: MANY});
            file.json.meshes.push({primitives: [primitive], weights: [1]});
            file.json.nodes.push({mesh: 0, skin: 0});
            file.json.skins = [ {joints: [0]}];
            var error:ModelError = Failures.of(GltfModel.fromBytes, "a", file.toBinary());
            assertTrue(error.message, /more than \d+ (numbers, each|vertices)|expected "VEC4"/.test(error.message));
        }

        // Points that have sets of joints, all of one accessor.
        private static function skinned(count:int, sets:int):Gltf
        {
            var file:Gltf = new Gltf();
            var points:Array = [];
            var numbers:Array = [];
            for (var i:int = 0; i < count; i++)
            {
                points.push(i % 7, i % 5, i % 3);
                numbers.push(0, 0, 0, 0);
            }
            var attributes:Object = {POSITION: file.addNumbers(points, "VEC3", Gltf.UNSIGNED_BYTE)};
            var set :int = file.addNumbers(numbers, "VEC4", Gltf.UNSIGNED_BYTE);
            for (i = 0; i < sets; i++)
            {
                attributes["JOINTS_" + i] = attributes["WEIGHTS_" + i] = set;
            }
            file.json.meshes.push({primitives: [ {attributes: attributes}]});
            file.json.nodes.push({mesh: 0, skin: 0});
            file.json.skins = [ {joints: [0]}];
            return file;
        }

        private static function refusesNumbers(bytes:ByteArray):void
        {
            refuses("numbers, each counted as often as it is used", GltfModel.fromBytes, "a", bytes);
        }

        private static function readingAnimations(bytes:ByteArray):void
        {
            new GltfAnimations("a", bytes);
        }

        private static function refuses(words:String, call:Function, ...args):void
        {
            assertThrows.apply(null, [ModelError, words, call].concat(args));
        }
    }
}
