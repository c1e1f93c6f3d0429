package starlogo.models
{
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import support.Gltf;
    import support.assertClose;
    import support.assertThrows;

    /** The animations of a glTF file: the numbers of their keys, and what is refused. What three.js makes of them is in test/adapters. */
    public class GltfAnimationsTest
    {
        [Test]
        public function nodesMove():void
        {
            var file:Gltf = animated("translation", [0, 0, 0, 4, 0, 0, 4, 8, 0], "VEC3", "LINEAR");
            assertCorner(file, -1, 0, 0, 0);
            assertCorner(file, 0.5, 2, 0, 0);
            assertCorner(file, 1, 4, 0, 0);
            assertCorner(file, 1.5, 4, 4, 0);
            assertCorner(file, 7, 4, 8, 0);
            assertCorner(animated("translation", [0, 0, 0, 4, 0, 0, 4, 8, 0], "VEC3", "STEP"), 1.9, 4, 0, 0);
            assertCorner(animated("translation", [0, 0, 0, 4, 0, 0, 4, 8, 0], "VEC3", "STEP"), 1, 4, 0, 0);
        }

        [Test]
        public function theyTurnTheShortWay():void
        {
            // from none to 90 degrees about z, whose quaternion is negative
            var half:Number = Math.SQRT1_2;
            var file:Gltf = animated("rotation", [0, 0, 0, 1, 0, 0, -half, -half, 0, 0, 0, 1], "VEC4", "LINEAR");
            var vertices:Vector.<Number> = new GltfAnimations("a", file.toBinary(), "z").verticesAt(0, 0.5);
            assertClose(3 * half, vertices[3], 1e-6);
            assertClose(3 * half, vertices[4], 1e-6);
        }

        /** Keys of integers are not quite as long as 1. The longer of two must not draw the turn to itself. */
        [Test]
        public function theLengthsOfTurnsDoNotCount():void
        {
            var longer:Number = 1.01 * Math.SQRT1_2;
            var file:Gltf = animated("rotation", [0, 0, 0, 0.99, 0, 0, longer, longer, 0, 0, 0, 1], "VEC4", "LINEAR");
            var vertices:Vector.<Number> = new GltfAnimations("a", file.toBinary(), "z").verticesAt(0, 0.5);
            assertClose(3 * Math.SQRT1_2, vertices[3], 1e-6);
            assertClose(3 * Math.SQRT1_2, vertices[4], 1e-6);
        }

        /** A node's turn that is not quite as long as 1 is the same turn at rest and as a key. */
        [Test]
        public function theRestIsAsAKeyOfIt():void
        {
            var file:Gltf = animated("rotation", [0.5, 0, 0, 0.5, 0.5, 0, 0, 0.5, 0.5, 0, 0, 0.5], "VEC4", "STEP");
            file.json.nodes[0].rotation = [0.5, 0, 0, 0.5];
            var model:GltfModel = new GltfModel("a", file.toBinary(), "z", Model.AS_GIVEN);
            assertEquals(model.vertices.join(), new GltfAnimations("a", file.toBinary(), "z").verticesAt(0, 0).join());
        }

        [Test]
        public function splinesHaveTangents():void
        {
            var keys:Array = [];
            for each (var x:Number in [0, 4, 4])
            {
                keys.push(0, 0, 0, x, 0, 0, 0, 0, 0);
            }
            var file:Gltf = animated("translation", keys, "VEC3", "CUBICSPLINE");
            assertCorner(file, 0.5, 2, 0, 0);
            assertCorner(file, 0.25, 4 * (3 / 16 - 2 / 64), 0, 0);
        }

        /** What is not finite is refused when it is needed, turns too. */
        [Test]
        public function keysAreFinite():void
        {
            var file:Gltf = animated("rotation", [0, 0, 0, 1, 0, NaN, 0, 1, 0, 0, 0, Infinity], "VEC4", "STEP");
            var turns:GltfAnimations = new GltfAnimations("a", file.toBinary());
            assertEquals(12, turns.verticesAt(0, 0.5).length);
            assertThrows(ModelError, /samplers\[0\]: its numbers at 1 seconds are not finite/, turns.verticesAt, 0, 1);
            assertThrows(ModelError, /samplers\[0\]: its numbers at 2 seconds are not finite/, turns.verticesAt, 0, 2);
            file = animated("translation", [0, 0, 0, NaN, 0, 0, 0, 0, 0], "VEC3", "LINEAR");
            var moves:GltfAnimations = new GltfAnimations("a", file.toBinary());
            assertThrows(ModelError, /samplers\[0\]: its numbers at 0.5 seconds are not finite/, moves.verticesAt, 0, 0.5);
        }

        [Test]
        public function timesDoNotGoBack():void
        {
            for each (var times:Array in [[0, 2, 1], [0, 2, -Infinity], [0, 1, NaN], [NaN, 1, 2], [0, 1, Infinity]])
            {
                assertThrows(ModelError, /samplers\[0\]: its times must be finite and not go back, but found (1|NaN|-?Infinity)$/, read, timed(times));
            }
            assertEquals(1, new GltfAnimations("a", timed([0, 1, 1]).toBinary()).durationOf(0));
        }

        /** The times are looked at once for each channel, which costs more than the file if many share them. */
        [Test]
        public function timesCountForEachChannel():void
        {
            var file:Gltf = timed([0, 1, 2]);
            var keys:int = 20000;
            var start:int = file.binary.length;
            file.json.accessors[2].count = file.json.accessors[3].count = keys;
            for (var i:int = 0; i < 2; i++)
            {
                file.json.accessors[2 + i].bufferView = file.json.bufferViews.length;
                file.json.bufferViews.push({buffer: 0, byteOffset: start, byteLength: 12 * keys});
            }
            file.binary.length = start + 12 * keys;
            var channels:Array = file.json.animations[0].channels;
            for (i = 0; i < 1000; i++)
            {
                channels.push(channels[0]);
            }
            assertThrows(ModelError, /samplers\[0\]: it has more than \d+ numbers, each counted as often as it is used/, read, file);
        }

        /** Targets that move nothing are looked at in each pose, which costs more than the file if many nodes share them. */
        [Test]
        public function targetsCountForEachWeight():void
        {
            var weights:Array = [];
            var targets:Array = [];
            for (var i:int = 0; i < 300; i++)
            {
                weights.push(0);
                targets.push({});
            }
            var file:Gltf = animated("weights", weights, "SCALAR", "STEP", [0]);
            var primitive:Object = file.json.meshes[0].primitives[0];
            primitive.targets = targets;
            for (i = 1; i < 100; i++)
            {
                file.json.nodes.push({mesh: 0});
                file.json.animations[0].channels.push({sampler: 0, target: {node: i, path: "weights"}});
            }
            assertEquals(100 * 12, new GltfAnimations("a", file.toBinary()).verticesAt(0, 0).length);
            for (i = 1; i < 20; i++)
            {
                file.json.meshes[0].primitives.push(primitive);
            }
            assertThrows(ModelError, /primitives\[\d+\]: it has more than \d+ elements/, read, file);
        }

        /** Only poses are placed. So what is wrong at rest alone is no error. */
        [Test]
        public function theRestIsNotPlaced():void
        {
            var file:Gltf = animated("scale", [1, 1, 1], "VEC3", "STEP", [0]);
            file.json.nodes[0].scale = [1e308, 1e308, 1e308];
            assertThrows(ModelError, /nodes\[0\]: its vertices are not finite/, GltfModel.fromBytes, "a", file.toBinary());
            assertCorner(file, 0, 0, 0, 0);
        }

        /** Of as many poses as a game has: none of them takes from what reading the file may cost. */
        [Test]
        public function posesAreManyAndFitTheModel():void
        {
            var file:Gltf = animated("translation", [0, 0, 0, 4, 0, 0, 4, 8, 0], "VEC3", "LINEAR");
            var bytes:ByteArray = file.toBinary();
            var model:GltfModel = GltfModel.fromBytes("a", bytes);
            var animations:GltfAnimations = new GltfAnimations("a", bytes);
            var first:Vector.<Number> = model.vertices.slice();
            for (var i:int = 0; i < 3000; i++)
            {
                model.pose(animations.verticesAt(0, animations.durationOf(0)));
            }
            // 4 to the east, 8 up; the model is four units wide
            assertClose(first[0] + 4 / model.source.unit, model.vertices[0], 1e-12);
            assertClose(first[2] + 8 / model.source.unit, model.vertices[2], 1e-12);
            model.pose(animations.verticesAt(0, 0));
            for (i = 0; i < first.length; i++)
            {
                assertClose(first[i], model.vertices[i], 1e-12);
            }
        }

        [Test]
        public function whatIsWrongIsNamed():void
        {
            var file:Gltf = animated("translation", [0, 0, 0, 4, 0, 0, 4, 8, 0], "VEC3", "LINEAR");
            var animations:GltfAnimations = new GltfAnimations("a", file.toBinary());
            assertEquals(1, animations.count);
            assertEquals(2, animations.durationOf(0));
            assertEquals(0, new GltfAnimations("a", Gltf.tetrahedron().toBinary()).count);
            assertThrows(RangeError, /animations 0 to 0, not 1/, animations.verticesAt, 1, 0);
            assertThrows(RangeError, /finite/, animations.verticesAt, 0, NaN);
            assertThrows(ModelError, /samplers\[0\].interpolation.*CUBICSPLINE/, read, animated("translation", [0, 0, 0], "VEC3", "SMOOTH"));
            assertThrows(ModelError, /1 elements for 3 keys/, read, animated("translation", [0, 0, 0], "VEC3", "LINEAR"));
            file.json.nodes[0].matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
            assertThrows(ModelError, /a node with a matrix/, read, file);
            delete file.json.nodes[0].matrix;
            file.json.animations[0].channels[0].sampler = 1;
            assertThrows(ModelError, /channels\[0\].sampler/, read, file);
            // a target of an extension
            file.json.animations[0].channels[0].target = {path: "pointer"};
            assertEquals(0, new GltfAnimations("a", file.toBinary()).durationOf(0));
        }

        [Test]
        public function wrongMeshesAreRefused():void
        {
            var file:Gltf = animated("translation", [0, 0, 0, 4, 0, 0, 4, 8, 0], "VEC3", "LINEAR");
            var position:int = file.json.meshes[0].primitives[0].attributes.POSITION;
            file.json.accessors[position].sparse = {count: 1, indices: {bufferView: file.addView([9], 1, Gltf.UNSIGNED_SHORT), componentType: Gltf.UNSIGNED_SHORT},
                    values: {bufferView: file.addView([1, 1, 1], 3, Gltf.FLOAT)}};
            assertThrows(ModelError, /element 0 is 9/, read, file);
        }

        private static function read(file:Gltf):void
        {
            new GltfAnimations("a", file.toBinary());
        }

        private static function assertCorner(file:Gltf, time:Number, x:Number, y:Number, z:Number):void
        {
            var vertices:Vector.<Number> = new GltfAnimations("a", file.toBinary(), "z").verticesAt(0, time);
            assertClose(x, vertices[0], 1e-6);
            assertClose(y, vertices[1], 1e-6);
            assertClose(z, vertices[2], 1e-6);
        }

        private static function timed(times:Array):Gltf
        {
            return animated("translation", [0, 0, 0, 4, 0, 0, 4, 8, 0], "VEC3", "LINEAR", times);
        }

        // A tetrahedron whose node has an animation with keys at three times, in seconds; null for 0, 1 and 2.
        private static function animated(path:String, values:Array, type:String, interpolation:String, times:Array = null):Gltf
        {
            var file:Gltf = Gltf.tetrahedron();
            var sampler:Object = {input: file.addNumbers(times || [0, 1, 2], "SCALAR", Gltf.FLOAT), output: file.addNumbers(values, type, Gltf.FLOAT), interpolation: interpolation};
            file.json.animations = [ {samplers: [sampler], channels: [ {sampler: 0, target: {node: 0, path: path}}]}];
            return file;
        }
    }
}
