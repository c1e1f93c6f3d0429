package starlogo.models.gltf
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.models.files.FileBudget;
    import starlogo.models.files.FileUrl;
    import starlogo.models.files.ModelFile;
    import starlogo.models.files.refuseModelIf;
    import starlogo.models.files.shortened;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    /**
     * A glTF 2.0 file, binary or JSON. Its steps read the JSON, and the buffers inside the file and in other files.
     *
     * @private
     */
    public final class GltfFile extends StepSequence
    {
        private static const JSON_CHUNK:uint = 0x4E4F534A;
        private static const BINARY_CHUNK:uint = 0x004E4942;
        private static const HEADER_LENGTH:int = 12;
        private static const CHUNK_HEADER_LENGTH:int = 8;

        // the most files beside this one
        private static const MAX_FILES:int = 100;

        private static const READ_VERSION:RegExp = /^2\.0/;
        private static const VERSIONS:RegExp = /^2\.\d/;

        // the beginning of the address of data inside the file, and the end of what is before the data; the case does not matter (RFC 2397)
        private static const DATA:RegExp = /^data:/i;
        private static const BASE64:RegExp = /;base64$/i;

        // extensions that are read (quantization), or that do not change shapes: an invisible node counts too
        private static const SUPPORTED:RegExp = /^(KHR_mesh_quantization|KHR_(materials|techniques?|texture|lights|xmp|node)_|EXT_(texture|lights)_|MSFT_texture_|KHR_animation_pointer)/;
        internal static const DRACO:String = "KHR_draco_mesh_compression";
        private static const MESHOPT:RegExp = /^(EXT|KHR)_meshopt_compression$/;
        internal static const DRACO_PROBLEM:String = "compressed with Draco (" + DRACO +
            "), which is not read: save the model without compression, or decompress it (\"gltf-transform copy\")";
        private static const MESHOPT_PROBLEM:String = "compressed with meshopt, which is not read: " +
            "save the model without compression (gltfpack without -c, or \"gltf-transform copy\")";

        /** The JSON, when no step is left. */
        internal var json:GltfJson = null;

        /** What the file may have and cost. It grows with the buffers in other files. */
        internal var budget:FileBudget;

        // the addresses of the other files
        private var _uris:Vector.<String> = new Vector.<String>();

        // The bytes of each buffer; null if it is missing. The binary chunk of a .glb file is in the first one's place from the beginning on.
        private var _buffers:Vector.<ByteArray> = new Vector.<ByteArray>();

        private var _accessors:Array = []; // those so far, by index

        /**
         * @param file the file; the endianness of its bytes is set
         * @param fetch <code>function(uri:String):Object</code>; is asked once for each other file. In the next step the object has its
         * <code>bytes</code>, whose endianness is set. If the file is missing they are null, and the <code>problem</code> says why
         * @throws ModelError if there is no JSON
         */
        public function GltfFile(file:ModelFile, fetch:Function)
        {
            var hasChunks:Boolean = file.bytes != null && isBinary(file.bytes);
            var text:String = hasChunks ? openChunks(file) : file.requireText("glTF file");
            budget = new FileBudget(file.name, hasChunks ? file.bytes.length : text.length);
            var reader:JsonReader = new JsonReader(text, budget);
            add(reader).call(function():void
                {
                    json = new GltfJson(file.name, reader.root);
                    checkNeeds();
                    beginEach(json.count("buffers"), readingBuffer).begin(function():Steps
                        {
                            return fetchingOthers(fetch);
                        });
                });
        }

        /** Reads a file at once. @param buffers the content of each other file, by its address; null if there are none */
        public static function read(name:String, bytes:ByteArray, buffers:Object):GltfFile
        {
            var file:GltfFile = new GltfFile(new ModelFile(name, bytes), function(uri:String):Object
                {
                    return {bytes: buffers != null && uri in buffers ? buffers[uri] as ByteArray : null,
                            problem: "\"" + shortened(uri) + "\" is another file and was not given: a ModelLoader's load() fetches it"};
                });
            finish(file);
            return file;
        }

        /** Whether bytes begin like a binary glTF file. */
        public static function isBinary(bytes:ByteArray):Boolean
        {
            return bytes.length >= 4 && bytes[0] == 0x67 && bytes[1] == 0x6C && bytes[2] == 0x54 && bytes[3] == 0x46;
        }

        /** Whether the text is JSON with the marks of glTF. */
        public static function isText(text:String):Boolean
        {
            return /^\s*\{/.test(text.substr(0, ModelFile.HEAD_LENGTH)) && text.indexOf("\"asset\"") > 0;
        }

        /**
         * The accessor to which a property refers; null if there is none. It is the same for all that use it, so its numbers are read once.
         *
         * @param user has the property
         * @param type the type that it must have: "SCALAR", "VEC3" or another
         */
        internal function accessorOf(user:GltfJson, key:String, type:String):GltfAccessor
        {
            var index:int = user.indexOrNone(key, "accessors");
            if (index < 0)
            {
                return null;
            }
            var found:GltfJson = json.rootEntry("accessors", index);
            found.refuseIf(found.raw.type !== type, "expected \"" + type + "\", but found " + GltfJson.shown(found.raw.type), "type");
            return _accessors[index] ||= GltfAccessor.of(this, found);
        }

        /**
         * Checks that a bufferView has some bytes. Returns its whole buffer, whose position is the first of them; the next call moves it.
         *
         * @param offset the first of them, in the view
         * @param user needs the bytes, for errors
         */
        internal function openView(index:int, offset:Number, length:Number, user:GltfJson):ByteArray
        {
            var view:GltfJson = json.rootEntry("bufferViews", index);
            var buffer:int = view.indexOrNone("buffer", "buffers");
            view.refuseIf(buffer < 0, "it names no buffer");
            var start:int = view.integer("byteOffset", int.MAX_VALUE, 0);
            var size:int = view.requiredInteger("byteLength", int.MAX_VALUE);
            user.refuseIf(offset + length > size, "it needs " + (offset + length) + " bytes of " + view.place + ", which has " + size);
            if (_buffers[buffer] == null)
            {
                view.refuseIf(view.hasExtension("EXT_meshopt_compression") || view.hasExtension("KHR_meshopt_compression"), "its data are " + MESHOPT_PROBLEM);
                throw json.rootEntry("buffers", buffer).error("its data are missing");
            }
            view.refuseIf(Number(start) + size > _buffers[buffer].length, "it ends at byte " + (Number(start) + size) + " of buffers[" + buffer +
                    "], which has " + _buffers[buffer].length);
            _buffers[buffer].position = start + offset;
            return _buffers[buffer];
        }

        // Keeps the binary chunk of a .glb file. Returns its JSON.
        private function openChunks(file:ModelFile):String
        {
            var name:String = file.name;
            var bytes:ByteArray = file.bytes;
            var text:String = null;
            var length:int = bytes.length;
            file.checkSize();
            refuseModelIf(length < HEADER_LENGTH + CHUNK_HEADER_LENGTH, name, "the file is cut off: it has " + length + " bytes");
            bytes.endian = Endian.LITTLE_ENDIAN;
            var version:uint = wordAt(bytes, 4);
            refuseModelIf(version != 2, name, "expected binary glTF of version 2, but found " + version, "byte 4");
            var end:uint = wordAt(bytes, 8);
            refuseModelIf(end > length, name, "the file is cut off: it should have " + end + " bytes, but has " + length, "byte 8");
            for (var at:int = HEADER_LENGTH; at + CHUNK_HEADER_LENGTH <= end; at += CHUNK_HEADER_LENGTH + chunkLength)
            {
                var chunkLength:uint = wordAt(bytes, at);
                var type:uint = wordAt(bytes, at + 4);
                var start:int = at + CHUNK_HEADER_LENGTH;
                refuseModelIf(chunkLength > end - start, name, "a chunk should have " + chunkLength + " bytes, but " + (end - start) + " are left", "byte " + at);
                refuseModelIf((text == null) != (type == JSON_CHUNK), name, "the first chunk, and no other, must be JSON", "byte " + at);
                if (text == null)
                {
                    bytes.position = start;
                    text = ModelFile.withoutByteOrderMark(bytes.readUTFBytes(chunkLength));
                }
                else if (type == BINARY_CHUNK && _buffers.length == 0)
                {
                    _buffers.push(new ByteArray());
                    if (chunkLength > 0)
                    {
                        _buffers[0].writeBytes(bytes, start, chunkLength);
                    }
                }
            }
            refuseModelIf(text == null, name, "there is no JSON in it");
            return text;
        }

        private static function wordAt(bytes:ByteArray, at:int):uint
        {
            bytes.position = at;
            return bytes.readUnsignedInt();
        }

        private function checkNeeds():void
        {
            var asset:GltfJson = json.object("asset");
            // a file of a later 2.x can be read, unless it says that it needs one
            var least:String = asset == null ? null : asset.textOrNull("minVersion");
            var version:* = asset == null ? undefined : least || asset.raw.version;
            var readable:RegExp = least == null ? VERSIONS : READ_VERSION;
            json.refuseIf(!(version is String && readable.test(version)),
                    "expected glTF 2.0, but found " + GltfJson.shown(version) + ": save the model as 2.0", "asset.version");
            for each (var extension:* in json.list("extensionsRequired"))
            {
                var required:String = extension is String ? extension : GltfJson.shown(extension);
                json.refuseIf(required == DRACO, "its meshes are " + DRACO_PROBLEM, "extensionsRequired");
                json.refuseIf(MESHOPT.test(required), "its data are " + MESHOPT_PROBLEM, "extensionsRequired");
                json.refuseIf(!SUPPORTED.test(required), "it needs the extension \"" + shortened(required) +
                        "\", which is not known: save the model without it", "extensionsRequired");
            }
        }

        // Starts to fetch the other files. In the next step all buffers are there that are not missing, and they are checked.
        private function fetchingOthers(fetch:Function):Steps
        {
            var files:Array = [];
            for each (var uri:String in _uris)
            {
                files.push(fetch(uri));
            }
            return new StepSequence().call(function():void
                {
                    for (var index:int = 0; index < json.count("buffers"); index++)
                    {
                        var buffer:GltfJson = json.rootEntry("buffers", index);
                        var file:int = _uris.indexOf(buffer.raw.uri);
                        if (file >= 0)
                        {
                            buffer.refuseIf(files[file].bytes == null, files[file].problem, "uri");
                            _buffers[index] = files[file].bytes;
                        }
                        var bytes:ByteArray = _buffers[index];
                        if (bytes != null)
                        {
                            buffer.refuseIf(bytes.length < buffer.raw.byteLength, "it should have " + buffer.raw.byteLength + " bytes, but has " + bytes.length);
                            bytes.endian = Endian.LITTLE_ENDIAN;
                        }
                    }
                    for each (var fetched:Object in files)
                    {
                        budget.addBytes(fetched.bytes.length);
                    }
                });
        }

        // The steps that decode a buffer. Null if it is in the binary chunk, in another file, or missing.
        private function readingBuffer(index:int):Steps
        {
            var buffer:GltfJson = json.rootEntry("buffers", index);
            var uri:* = buffer.raw.uri;
            // a wrong length is refused before the buffer is fetched or decoded
            buffer.requiredInteger("byteLength", FileBudget.MAX_BYTES);
            buffer.refuseIf(uri !== undefined && !(uri is String), "expected an address", "uri");
            _buffers[index] = uri === undefined && index < _buffers.length ? _buffers[index] : null;
            if (uri !== undefined && DATA.test(uri))
            {
                var comma:int = uri.indexOf(",");
                buffer.refuseIf(!BASE64.test(uri.substring(0, comma)), "expected data in base64", "uri");
                if (uri.indexOf("%", comma) >= 0)
                {
                    uri = uri.substring(0, comma + 1) + unescape(uri.substring(comma + 1));
                }
                _buffers[index] = new ByteArray();
                return decodingBase64(budget.modelName, uri, comma + 1, buffer.place + ".uri", _buffers[index]);
            }
            if (uri !== undefined)
            {
                buffer.refuseIf(!FileUrl.isWithin(uri), "expected data, or a path from the file's folder on, but found " + GltfJson.shown(uri), "uri");
                if (_uris.indexOf(uri) < 0)
                {
                    buffer.refuseIf(_uris.length == MAX_FILES, "its buffers are in more than " + MAX_FILES + " other files", "uri");
                    _uris.push(uri);
                }
            }
            return null;
        }
    }
}
