package soak
{
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import support.Collada;
    import support.Gltf;

    /** Files of large models: bumpy spheres of so many triangles. */
    public final class LargeFiles
    {
        /** The names of those that are measured: the format and the triangles. */
        public static function get names():Array
        {
            return ["OBJ 20000", "OBJ 200000", "COLLADA 200000", "OBJ 500000", "OBJ 1000000", "GLB 200000", "GLB 1000000", "STL 200000",
                    "STL 1000000"];
        }

        /**
         * Makes one.
         *
         * @param name "OBJ", "COLLADA", "GLB" or "STL", and about how many triangles
         * @return a String, or a ByteArray
         */
        public static function make(name:String):Object
        {
            var words:Array = name.split(" ");
            var rings:int = Math.round(Math.sqrt(words[1] / 4));
            switch (words[0])
            {
                case "OBJ":
                    return obj(rings);
                case "GLB":
                    return glb(rings);
                case "STL":
                    return stl(rings);
                default:
                    return collada(rings);
            }
        }

        private static function obj(rings:int):String
        {
            var parts:Array = ["v "];
            parts.push(points(rings, "\nv "), "\nf ", corners(rings, 1, "\nf "), "\n");
            return parts.join("");
        }

        private static function collada(rings:int):String
        {
            return Collada.document(Collada.geometry("a", points(rings, " "), '<triangles count="' + 4 * rings * rings + '">' +
                        Collada.INPUT + "<p>" + corners(rings, 0, " ") + "</p></triangles>"), "", Collada.Z_UP);
        }

        private static function glb(rings:int):ByteArray
        {
            var file:Gltf = new Gltf();
            file.addMesh({attributes: {POSITION: file.addNumbers(points(rings, " ").split(" "), "VEC3", Gltf.FLOAT)},
                        indices: file.addNumbers(corners(rings, 0, " ").split(" "), "SCALAR", Gltf.UNSIGNED_INT)});
            file.json.nodes.push({mesh: 0});
            return file.toBinary();
        }

        private static function stl(rings:int):ByteArray
        {
            var numbers:Array = points(rings, " ").split(" ");
            var bytes:ByteArray = new ByteArray();
            bytes.endian = Endian.LITTLE_ENDIAN;
            bytes.length = 80;
            bytes.position = 80;
            bytes.writeUnsignedInt(4 * rings * rings);
            var corner:int = 0;
            for each (var index:int in corners(rings, 0, " ").split(" "))
            {
                for (var i:int = corner % 3 == 0 ? -3 : 0; i < 3; i++)
                {
                    bytes.writeFloat(i < 0 ? 0 : numbers[3 * index + i]);
                }
                if (++corner % 3 == 0)
                {
                    bytes.writeShort(0);
                }
            }
            return bytes;
        }

        // 2 * rings points each, and the two poles
        private static function points(rings:int, end:String):String
        {
            var random:SeededRandom = new SeededRandom(7);
            var parts:Array = [];
            for (var ring:int = 1; ring <= rings; ring++)
            {
                var polar:Number = Math.PI * ring / (rings + 1);
                for (var side:int = 0; side < 2 * rings; side++)
                {
                    var around:Number = Math.PI * side / rings;
                    var radius:Number = 1 + 0.2 * Math.sin(5 * polar) * Math.cos(7 * around) + 0.001 * random.next();
                    parts.push((radius * Math.sin(polar) * Math.cos(around)).toFixed(6) + " " +
                            (radius * Math.sin(polar) * Math.sin(around)).toFixed(6) + " " + (radius * Math.cos(polar)).toFixed(6));
                }
            }
            parts.push("0 0 1", "0 0 -1");
            return parts.join(end);
        }

        private static function corners(rings:int, first:int, end:String):String
        {
            var parts:Array = [];
            var sides:int = 2 * rings;
            var pole:int = rings * sides + first;
            for (var side:int = 0; side < sides; side++)
            {
                var next:int = (side + 1) % sides;
                parts.push(pole + " " + (side + first) + " " + (next + first));
                for (var ring:int = 1; ring < rings; ring++)
                {
                    var above:int = (ring - 1) * sides + first;
                    var below:int = ring * sides + first;
                    parts.push((above + side) + " " + (below + side) + " " + (below + next),
                            (above + side) + " " + (below + next) + " " + (above + next));
                }
                parts.push((pole + 1) + " " + ((rings - 1) * sides + next + first) + " " + ((rings - 1) * sides + side + first));
            }
            return parts.join(end);
        }
    }
}
