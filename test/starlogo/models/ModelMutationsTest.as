package starlogo.models
{
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;
    import flash.utils.getTimer;
    import org.flexunit.asserts.assertTrue;
    import support.Collada;
    import support.Effort;
    import support.Gltf;
    import support.Mutations;
    import support.encoded;

    /** Damaged files: each loads, or fails with a ModelError, and soon. */
    public class ModelMutationsTest
    {
        private static const LONGEST_MS:int = 100000;

        private static const OBJ:String = "# a house\nmtllib house.mtl\no house\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\nv 0 1e0 0\r\n" +
            "v -1.5e-1 0.5 +2.\nv\t.5  .5 2.5 # top\nvt 0 0\nvt 1 1\nvn 0 0 1\ng walls\nusemtl brick\ns off\nf 1/1/1 2/2/1 3/1/1 4/2/1\n" +
            "f 1 2 6\nf 2//1 3//1 -1//1\nf -4/1 4/1 \\\n 6/1\nf 4 1 5 6\nl 1 2\np 3\ng roof\nv 2 0 0\nv 2 2 0\nv 1 1 1\nv 0 2 0\nv 0 0 1\n" +
            "f 7 8 9 10 11\nf 1 2 3 4 5 6 7 8\n";

        private static const LIBRARIES:String = Collada.geometry("a",
                "0 0 0 4 0 0 4 4 0 0 4 0 1 1 0 2 1 0 2 2 0 1 2 1.5e0",
                Collada.triangles("0 1 2 0 2 3") + Collada.polylist("4 3 5", "0 1 2 3 4 5 6 0 1 6 2 7") +
                '<polygons count="2">' + Collada.INPUT + '<p>0 1 2</p><ph><p>0 1 2 3</p><h>4 5 6 7</h></ph></polygons>' +
                '<tristrips count="1"><input semantic="NORMAL" source="#p" offset="1"/>' + Collada.INPUT +
                '<p>0 0 1 1 3 0 2 9</p></tristrips>' +
                '<trifans count="1">' + Collada.INPUT + "<p>0 1 2 3</p></trifans>") +
            '<library_nodes><node id="n"><skew>20 1 0 0 0 1 0</skew><instance_geometry url="#a"/></node></library_nodes>' +
            "<library_controllers>" + Collada.skin("c", "m", 8, "3 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1") +
            '<controller id="m"><morph source="#a"/></controller></library_controllers>';
        private static const COLLADA:String = '<?xml version="1.0" encoding="utf-8"?>\n' + Collada.scene(LIBRARIES,
                '<node id="top">' +
                '<translate>1 2 3</translate><rotate>0 0 1 45</rotate><scale>1 2 3</scale><lookat>1 2 3 4 5 6 0 0 1</lookat>' +
                '<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix><instance_geometry url="#a"/><node id="joint"><instance_controller url="#c"/>' +
                '</node><instance_node url="#n"/></node>');

        private static const STL:String = "solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n  endloop\n" +
            " endfacet\n facet normal 1 0 0\n  outer loop\n   vertex 0 0 0\n   vertex 0 1.5e0 0\n   vertex 0 0 1\n  endloop\n endfacet\nendsolid a\n";

        [Test]
        public function objText():void
        {
            mutate("OBJ", 6000, 101, objOf);
        }

        [Test]
        public function colladaText():void
        {
            mutate("COLLADA", 3000, 201, colladaOf);
        }

        [Test]
        public function bytesOfEitherFormat():void
        {
            mutate("bytes", 1500, 401, bytesOf);
        }

        [Test]
        public function binaryGltf():void
        {
            mutate("binary glTF", Effort.choose(500, 10000), 501, binaryGltfOf);
        }

        [Test]
        public function gltfText():void
        {
            mutate("glTF text", Effort.choose(500, 10000), 502, gltfOf);
        }

        [Test]
        public function stl():void
        {
            mutate("STL", Effort.choose(500, 10000), 503, stlOf);
        }

        private static function binaryGltfOf(random:SeededRandom):Model
        {
            return GltfModel.fromBytes("mutation", Mutations.ofBytes(everythingOfGltf().toBinary(), random));
        }

        private static function gltfOf(random:SeededRandom):Model
        {
            return GltfModel.fromBytes("mutation", encoded(Mutations.ofText(everythingOfGltf().toText(), random), "utf-8"));
        }

        private static function stlOf(random:SeededRandom):Model
        {
            if (random.chance())
            {
                return StlModel.fromBytes("mutation", encoded(Mutations.ofText(STL, random), "utf-8"));
            }
            var bytes:ByteArray = new ByteArray();
            bytes.length = 84 + 50 * 3;
            bytes[80] = 3;
            for (var i:int = 96; i < bytes.length; i += 7)
            {
                bytes[i] = i;
            }
            return StlModel.fromBytes("mutation", Mutations.ofBytes(bytes, random));
        }

        /** A file with nodes in nodes, a skin, a morph target, indices, rows with gaps, and what is sparse. */
        private static function everythingOfGltf():Gltf
        {
            var file:Gltf = Gltf.tetrahedron();
            var json:Object = file.json;
            var position:int = file.addNumbers([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], "VEC3", Gltf.FLOAT, 16);
            json.accessors[position].sparse = {count: 1, indices: {bufferView: file.addView([2], 1, Gltf.UNSIGNED_SHORT), componentType: Gltf.UNSIGNED_SHORT},
                    values: {bufferView: file.addView([0, 2, 0], 3, Gltf.FLOAT)}};
            var target:int = file.addNumbers([0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0], "VEC3", Gltf.SHORT);
            var joints:int = file.addNumbers([0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0], "VEC4", Gltf.UNSIGNED_BYTE);
            var weights:int = file.addNumbers([1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0, 1, 1, 0, 0], "VEC4", Gltf.FLOAT);
            file.addMesh({attributes: {POSITION: position, JOINTS_0: joints, WEIGHTS_0: weights}, targets: [ {POSITION: target}], mode: 5},
                    {attributes: {POSITION: position}, indices: file.addNumbers([0, 1, 2, 3], "SCALAR", Gltf.UNSIGNED_INT), mode: 6});
            json.meshes[1].weights = [0.5];
            var matrices:int = file.addNumbers([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1], "MAT4", Gltf.FLOAT);
            json.skins = [ {joints: [1, 2], inverseBindMatrices: matrices}];
            json.nodes = [ {mesh: 0, children: [1], rotation: [0, 0.6, 0, 0.8]}, {mesh: 1, translation: [1, 2, 3], children: [2]}, {mesh: 0, scale: [1, -2, 1]},
                    {mesh: 1, skin: 0}, {mesh: 0, matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4, 0, 0, 1]}];
            json.scenes = [ {nodes: [0, 3]}, {nodes: [4]}];
            json.scene = 0;
            return file;
        }

        private static function objOf(random:SeededRandom):Model
        {
            return new ObjModel("mutation", Mutations.ofText(OBJ, random));
        }

        private static function colladaOf(random:SeededRandom):Model
        {
            return new ColladaModel("mutation", Mutations.ofText(COLLADA, random));
        }

        private static function bytesOf(random:SeededRandom):Model
        {
            var isObj:Boolean = random.chance();
            var bytes:ByteArray = Mutations.ofBytes(encoded(isObj ? OBJ : COLLADA, random.pick(["utf-8", "unicode"])), random);
            return isObj ? ObjModel.fromBytes("mutation", bytes) : ColladaModel.fromBytes("mutation", bytes);
        }

        private static function mutate(what:String, count:int, seed:int, read:Function):void
        {
            var random:SeededRandom = new SeededRandom(seed);
            var longest:int = 0;
            var loaded:int = 0;
            count = Effort.choose(count / 2, count, count / 4);
            for (var i:int = 0; i < count; i++)
            {
                var start:int = getTimer();
                loaded += loads(read, random) ? 1 : 0;
                longest = Math.max(longest, getTimer() - start);
            }
            trace("  " + count + " mutations of " + what + ": " + loaded + " load, the longest takes " + longest + " ms");
            assertTrue("longest: " + longest + " ms", longest < LONGEST_MS);
            assertTrue("some load, some fail: " + loaded, loaded > count / 50 && loaded < count);
        }

        private static function loads(read:Function, random:SeededRandom):Boolean
        {
            try
            {
                return read(random).vertices.length > 0;
            }
            catch (error:ModelError)
            {
                return false;
            }
            return false;
        }
    }
}
