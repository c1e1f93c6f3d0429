package support
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;

    /** Makes glTF files for tests. */
    public final class Gltf
    {
        public static const BYTE:int = 5120;
        public static const UNSIGNED_BYTE:int = 5121;
        public static const SHORT:int = 5122;
        public static const UNSIGNED_SHORT:int = 5123;
        public static const UNSIGNED_INT:int = 5125;
        public static const FLOAT:int = 5126;

        private static const DIGITS:String = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

        /** The JSON: a test may change all of it. */
        public var json:Object = {asset: {version: "2.0"}, accessors: [], bufferViews: [], meshes: [], nodes: [], buffers: [ {byteLength: 0}]};

        /** The buffer. */
        public var binary:ByteArray = littleEndian();

        /** A file of one mesh of one primitive in one node: a tetrahedron of three and four units, unless a test has others. */
        public static function tetrahedron():Gltf
        {
            var file:Gltf = new Gltf();
            file.addMesh({attributes: {POSITION: file.addNumbers([0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0, 2], "VEC3", FLOAT)},
                        indices: file.addNumbers([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3], "SCALAR", UNSIGNED_BYTE)});
            file.json.nodes.push({mesh: 0});
            return file;
        }

        /** Adds an accessor with its numbers; its index. */
        public function addNumbers(numbers:Array, type:String, kind:int, stride:int = 0):int
        {
            var width:int = {SCALAR: 1, VEC3: 3, VEC4: 4, MAT4: 16}[type];
            var accessor:Object = {componentType: kind, type: type, count: numbers.length / width, bufferView: addView(numbers, width, kind, stride)};
            json.accessors.push(accessor);
            return json.accessors.length - 1;
        }

        /** Adds a bufferView with numbers; its index. */
        public function addView(numbers:Array, width:int, kind:int, stride:int = 0):int
        {
            var start:int = binary.length;
            for (var i:int = 0; i < numbers.length; i += width)
            {
                var row:int = binary.length;
                for (var k:int = 0; k < width; k++)
                {
                    write(numbers[i + k], kind);
                }
                // what is between is no number
                while (binary.length < row + stride)
                {
                    binary.writeByte(0x7F);
                }
            }
            var view:Object = {buffer: 0, byteOffset: start, byteLength: binary.length - start};
            if (stride > 0)
            {
                view.byteStride = stride;
            }
            while (binary.length % 4 != 0)
            {
                binary.writeByte(0);
            }
            json.bufferViews.push(view);
            return json.bufferViews.length - 1;
        }

        /** Adds a mesh of primitives. */
        public function addMesh(...primitives):void
        {
            json.meshes.push({primitives: primitives});
        }

        /** A binary file. */
        public function toBinary():ByteArray
        {
            json.buffers[0].byteLength = binary.length;
            var text:ByteArray = new ByteArray();
            text.writeUTFBytes(JSON.stringify(json));
            while (text.length % 4 != 0)
            {
                text.writeByte(0x20);
            }
            var file:ByteArray = littleEndian();
            file.writeUnsignedInt(0x46546C67);
            file.writeUnsignedInt(2);
            file.writeUnsignedInt(28 + text.length + binary.length);
            file.writeUnsignedInt(text.length);
            file.writeUnsignedInt(0x4E4F534A);
            file.writeBytes(text);
            file.writeUnsignedInt(binary.length);
            file.writeUnsignedInt(0x004E4942);
            file.writeBytes(binary);
            return file;
        }

        /** JSON, with its buffer inside, or at an address. */
        public function toText(uri:String = null):String
        {
            json.buffers[0] = {byteLength: binary.length, uri: uri || "data:application/octet-stream;base64," + base64(binary)};
            return JSON.stringify(json);
        }

        /** The same as bytes. */
        public function toTextBytes(uri:String = null):ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.writeUTFBytes(toText(uri));
            return bytes;
        }

        private static function base64(bytes:ByteArray):String
        {
            var text:String = "";
            for (var i:int = 0; i < bytes.length; i += 3)
            {
                var group:int = bytes[i] << 16 | (i + 1 < bytes.length ? bytes[i + 1] << 8 : 0) | (i + 2 < bytes.length ? bytes[i + 2] : 0);
                text += DIGITS.charAt(group >> 18) + DIGITS.charAt(group >> 12 & 63);
                text += i + 1 < bytes.length ? DIGITS.charAt(group >> 6 & 63) : "=";
                text += i + 2 < bytes.length ? DIGITS.charAt(group & 63) : "=";
            }
            return text;
        }

        private static function littleEndian():ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.endian = Endian.LITTLE_ENDIAN;
            return bytes;
        }

        private function write(number:Number, kind:int):void
        {
            switch (kind)
            {
                case FLOAT:
                    binary.writeFloat(number);
                    break;
                case UNSIGNED_INT:
                    binary.writeUnsignedInt(number);
                    break;
                case BYTE:
                    binary.writeByte(number);
                    break;
                case UNSIGNED_BYTE:
                    binary.writeByte(number);
                    break;
                default:
                    binary.writeShort(number);
            }
        }
    }
}
