package soak
{
    import flash.utils.ByteArray;
    import support.Gltf;

    /** glTF files that are made to cost time, memory or requests, of about any size. */
    internal final class HostileGltf
    {
        private static const POINTS:Array = [0, 0, 0, 1, 0, 0, 0, 1, 0];

        /** The names of all of them. */
        internal static function get names():Array
        {
            return ["glTF: declared points without data", "glTF: declared sets without data", "glTF: declared targets without data",
                    "glTF: declared matrices without data", "glTF: declared sparse points", "glTF: sets of joints", "glTF: sets of one accessor",
                    "glTF: skinned primitives of one accessor", "glTF: skinned nodes of one mesh", "glTF: targets of one accessor", "glTF: accessors of one view",
                    "glTF: indices of one view", "glTF: joints", "glTF: nodes in a chain", "glTF: children", "glTF: buffers", "glTF: long numbers",
                    "glTF: strings", "glTF: extensions", "glTF: base64"];
        }

        /** Makes one, as HostileFiles does. */
        internal static function make(name:String, size:int):Object
        {
            switch (name)
            {
                case "glTF: declared points without data":
                    return declared(size, [ {attributes: {POSITION: 0}}]);
                case "glTF: declared sets without data":
                    return declared(size, [ {attributes: sets(30)}]);
                case "glTF: declared targets without data":
                    return declared(size, [ {attributes: {POSITION: 0}, targets: [ {POSITION: 0}, {POSITION: 0}]}]);
                case "glTF: declared matrices without data":
                    return matrices(size);
                case "glTF: declared sparse points":
                    return sparse(size);
                case "glTF: sets of joints":
                    return skinned(size / 40, 1, 1, true);
                case "glTF: sets of one accessor":
                    return skinned(size / 40, size / 40, 1, false);
                case "glTF: skinned primitives of one accessor":
                    return skinned(1, size / 60, size / 120, false);
                case "glTF: skinned nodes of one mesh":
                    return nodesOfOneMesh(size);
                case "glTF: targets of one accessor":
                    return targets(size);
                case "glTF: accessors of one view":
                    return accessors(size, false);
                case "glTF: indices of one view":
                    return accessors(size, true);
                case "glTF: joints":
                    return joints(size);
                case "glTF: nodes in a chain":
                    return chain(size);
                case "glTF: children":
                    return children(size);
                default:
                    return plain(name, size);
            }
        }

        private static function plain(name:String, size:int):Object
        {
            var head:String = '{"asset":{"version":"2.0"},';
            switch (name)
            {
                case "glTF: buffers":
                    return head + '"buffers":[' + repeated('{"byteLength":1,"uri":"#.bin"}', size / 32) + ']}';
                case "glTF: long numbers":
                    return head + '"extras":[' + repeated("1." + times("0", 50), size / 53) + ']}';
                case "glTF: strings":
                    return head + '"extras":["' + times("\\\\", size / 2) + '"]}';
                case "glTF: extensions":
                    return head + '"extensionsRequired":[' + repeated('"KHR_materials_#"', size / 20) + ']}';
                case "glTF: base64":
                    return head + '"buffers":[{"byteLength":1,"uri":"data:application/octet-stream;base64,' + times("AAAA", size / 4) + '"}]}';
                default:
                    throw new ArgumentError("there is no hostile file \"" + name + "\"");
            }
        }

        private static function times(text:String, count:int):String
        {
            return new Array(Math.max(1, count) + 1).join(text);
        }

        // With commas between, and with numbers in place of "#".
        private static function repeated(text:String, count:int):String
        {
            var parts:Array = [];
            for (var i:int = 0; i < Math.max(1, count); i++)
            {
                parts.push(text.replace("#", i));
            }
            return parts.join(",");
        }

        private static function sets(count:int):Object
        {
            var attributes:Object = {POSITION: 0};
            for (var i:int = 0; i < count; i++)
            {
                attributes["JOINTS_" + i] = 1;
                attributes["WEIGHTS_" + i] = 1;
            }
            return attributes;
        }

        // Accessors without data, of so many points.
        private static function declared(count:int, primitives:Array):String
        {
            var most:int = Math.min(count, 1000000);
            return JSON.stringify({asset: {version: "2.0"}, accessors: [ {componentType: 5126, type: "VEC3", count: most},
                            {componentType: 5121, type: "VEC4", count: most}],
                        meshes: [ {primitives: primitives, weights: [1, 1]}], nodes: [ {mesh: 0, skin: 0}], skins: [ {joints: [0]}]});
        }

        private static function matrices(count:int):String
        {
            return JSON.stringify({asset: {version: "2.0"}, accessors: [ {componentType: 5126, type: "VEC3", count: 3},
                            {componentType: 5121, type: "VEC4", count: 3}, {componentType: 5126, type: "MAT4", count: Math.min(count, 50000)}],
                        meshes: [ {primitives: [ {attributes: sets(1)}]}], nodes: [ {mesh: 0, skin: 0}],
                        skins: [ {joints: [0], inverseBindMatrices: 2}]});
        }

        private static function sparse(count:int):Object
        {
            var file:Gltf = new Gltf();
            file.json.accessors.push({componentType: 5126, type: "VEC3", count: Math.min(count, 1000000), sparse: {count: 3,
                            indices: {componentType: 5121, bufferView: file.addView([0, 1, 2], 1, Gltf.UNSIGNED_BYTE)},
                            values: {bufferView: file.addView(POINTS, 3, Gltf.FLOAT)}}});
            file.addMesh({attributes: {POSITION: 0}});
            file.json.nodes.push({mesh: 0});
            return file.toBinary();
        }

        // Primitives of one set of points, which have sets of joints.
        private static function skinned(setCount:int, pointCount:int, primitiveCount:int, areOwn:Boolean):ByteArray
        {
            var file:Gltf = new Gltf();
            var points:Array = [];
            var numbers:Array = [];
            for (var i:int = 0; i < Math.max(3, pointCount); i++)
            {
                points.push(i % 7, i % 5, i % 3);
                numbers.push(0, 0, 0, 0);
            }
            var attributes:Object = {POSITION: file.addNumbers(points, "VEC3", Gltf.UNSIGNED_BYTE)};
            var set :int = file.addNumbers(numbers, "VEC4", Gltf.UNSIGNED_BYTE);
            for (i = 0; i < Math.max(1, setCount); i++)
            {
                attributes["JOINTS_" + i] = attributes["WEIGHTS_" + i] = set;
                if (areOwn)
                {
                    set = file.json.accessors.length;
                    file.json.accessors.push(file.json.accessors[1]);
                }
            }
            var primitives:Array = [];
            for (i = 0; i < Math.max(1, primitiveCount); i++)
            {
                primitives.push({attributes: attributes});
            }
            file.json.meshes.push({primitives: primitives});
            file.json.nodes.push({mesh: 0, skin: 0});
            file.json.skins = [ {joints: [0]}];
            return file.toBinary();
        }

        // What a node places counts as what the file has, so the mesh stays small.
        private static function nodesOfOneMesh(size:int):ByteArray
        {
            var file:Gltf = new Gltf();
            var points:Array = [];
            var numbers:Array = [];
            for (var i:int = 0; i < 20; i++)
            {
                points.push(i % 7, i % 5, i % 3);
                numbers.push(0, 0, 0, 0);
            }
            for (i = 0; i < size / 20; i++)
            {
                file.json.nodes.push({mesh: 0, skin: 0});
            }
            file.addMesh({attributes: {POSITION: file.addNumbers(points, "VEC3", Gltf.UNSIGNED_BYTE),
                            JOINTS_0: file.addNumbers(numbers, "VEC4", Gltf.UNSIGNED_BYTE), WEIGHTS_0: 1}});
            file.json.skins = [ {joints: [0]}];
            return file.toBinary();
        }

        private static function targets(size:int):ByteArray
        {
            var file:Gltf = new Gltf();
            var points:Array = [];
            var all:Array = [];
            var weights:Array = [];
            for (var i:int = 0; i < size / 60; i++)
            {
                points.push(i % 7, i % 5, i % 3);
                all.push({POSITION: 0});
                weights.push(0.1);
            }
            file.addMesh({attributes: {POSITION: file.addNumbers(points, "VEC3", Gltf.UNSIGNED_BYTE)}, targets: all});
            file.json.meshes[0].weights = weights;
            file.json.nodes.push({mesh: 0});
            return file.toBinary();
        }

        // Meshes with accessors of their own, all of the same bytes.
        private static function accessors(size:int, areIndices:Boolean):ByteArray
        {
            var file:Gltf = new Gltf();
            var points:Array = [];
            var indices:Array = [];
            for (var i:int = 0; i < size / 60; i++)
            {
                points.push(i % 7, i % 5, i % 3);
                indices.push(0, 0, 0);
            }
            file.addNumbers(points, "VEC3", Gltf.UNSIGNED_BYTE);
            file.addNumbers(indices, "SCALAR", Gltf.UNSIGNED_BYTE);
            var primitives:Array = [];
            for (i = 0; i < size / 120; i++)
            {
                file.json.accessors.push(file.json.accessors[areIndices ? 1 : 0]);
                primitives.push(areIndices ? {attributes : {POSITION: 0}, indices: 2 + i}: {attributes: {POSITION: 2 + i}});
            }
            file.json.meshes.push({primitives: primitives});
            file.json.nodes.push({mesh: 0});
            return file.toBinary();
        }

        // A skin of many joints, which many nodes have.
        private static function joints(size:int):ByteArray
        {
            var file:Gltf = new Gltf();
            var all:Array = [];
            for (var i:int = 0; i < size / 40; i++)
            {
                file.json.nodes.push({mesh: 0, skin: 0});
                all.push(i);
            }
            file.addMesh({attributes: {POSITION: file.addNumbers(POINTS, "VEC3", Gltf.FLOAT),
                            JOINTS_0: file.addNumbers([0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0], "VEC4", Gltf.UNSIGNED_BYTE), WEIGHTS_0: 1}});
            file.json.skins = [ {joints: all}];
            return file.toBinary();
        }

        private static function chain(size:int):ByteArray
        {
            var file:Gltf = new Gltf();
            var count:int = Math.max(1, size / 30);
            for (var i:int = 0; i < count; i++)
            {
                file.json.nodes.push(i + 1 < count ? {mesh : 0, children: [i + 1]}: {mesh: 0});
            }
            file.addMesh({attributes: {POSITION: file.addNumbers(POINTS, "VEC3", Gltf.FLOAT)}});
            return file.toBinary();
        }

        private static function children(size:int):ByteArray
        {
            var file:Gltf = new Gltf();
            var all:Array = [];
            file.json.nodes.push({children: all});
            for (var i:int = 1; i < Math.max(2, size / 15); i++)
            {
                file.json.nodes.push({mesh: 0});
                all.push(i);
            }
            file.addMesh({attributes: {POSITION: file.addNumbers(POINTS, "VEC3", Gltf.FLOAT)}});
            return file.toBinary();
        }
    }
}
