package starlogo.models.gltf
{
    import flash.utils.ByteArray;
    import starlogo.steps.StepSequence;

    /**
     * Reads the numbers of an accessor, in steps. The accessor may have any kind of number, be normalised, have gaps between rows, or be
     * sparse.
     *
     * <p>Floats, 32-bit integers and all other numbers have a loop each, because the loops take most of the time of reading a large file.</p>
     */
    internal final class GltfAccessor extends StepSequence
    {
        private static const NUMBERS_PER_STEP:int = 20000;

        private static const BYTE:int = 5120;
        private static const UNSIGNED_BYTE:int = 5121;
        private static const SHORT:int = 5122;
        private static const UNSIGNED_SHORT:int = 5123;
        private static const UNSIGNED_INT:int = 5125;
        private static const FLOAT:int = 5126;

        private static const SIZES:Object = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4};
        private static const WIDTHS:Object = {SCALAR: 1, VEC3: 3, VEC4: 4, MAT4: 16};
        private static const LARGEST:Object = {5120: 127, 5121: 255, 5122: 32767, 5123: 65535};

        /** The numbers, when no step is left. */
        public var numbers:Vector.<Number>;

        /** The number of elements. Each has one or more numbers. */
        public var count:int;

        /** Where the JSON says where its numbers are. */
        public var json:GltfJson;

        private var _width:int;
        private var _componentType:int;

        // integers are divided by this; 0 for no division
        private var _divisor:Number = 0;

        /**
         * @param file the file; all its steps must be done
         * @param json says where its numbers are: an accessor, or a part of a sparse one
         * @param count the number of elements
         * @param width the numbers of each element
         * @param componentType the kind of its numbers: BYTE or another
         * @param isNormalised whether its numbers stand for fractions of the largest one
         */
        public function GltfAccessor(file:GltfFile, json:GltfJson, count:int, width:int, componentType:int, isNormalised:Boolean)
        {
            this.json = json;
            this.count = count;
            _width = width;
            _componentType = componentType;
            json.refuseIf(!SIZES.hasOwnProperty(componentType), "expected 5120 to 5123, 5125 or 5126, but found " + componentType, "componentType");
            _divisor = isNormalised && LARGEST[componentType] > 0 ? LARGEST[componentType] : 0;
            var view:int = json.reference("bufferView", "bufferViews");
            var offset:int = json.whole("byteOffset", int.MAX_VALUE, 0);
            if (view < 0)
            {
                file.limits.countZeros(Number(count) * width, json.place);
            }
            else
            {
                addRows(file, view, offset);
                file.limits.countNumbers(Number(count) * width, json.place);
            }
            numbers = new Vector.<Number>(count * width);
        }

        /** The accessor that is an entry of the file. */
        public static function of(file:GltfFile, json:GltfJson):GltfAccessor
        {
            var accessor:GltfAccessor = new GltfAccessor(file, json, json.requiredWhole("count", int.MAX_VALUE), WIDTHS[json.value.type],
                    json.requiredWhole("componentType", int.MAX_VALUE), json.value.normalized === true);
            var sparse:GltfJson = json.object("sparse");
            if (sparse != null)
            {
                accessor.addSparse(file, sparse);
            }
            return accessor;
        }

        /** Whether its numbers are unsigned integers, as a list of indices requires. */
        public function get areIndices():Boolean
        {
            return _divisor == 0 && (_componentType == UNSIGNED_BYTE || _componentType == UNSIGNED_SHORT || _componentType == UNSIGNED_INT);
        }

        /** Checks that it has an element for each vertex of a primitive. */
        public function requireCount(vertexCount:int):void
        {
            json.refuseIf(count != vertexCount, "it has " + count + " elements, but there are " + vertexCount + " vertices");
        }

        // Adds the steps that read the rows: from an offset in a bufferView on, at the view's distance from one another.
        private function addRows(file:GltfFile, view:int, offset:int):void
        {
            var size:int = SIZES[_componentType] * _width;
            var entry:GltfJson = file.json.fileEntry("bufferViews", view);
            var stride:int = entry.whole("byteStride", 252, size);
            entry.refuseIf(stride < size, "expected at least " + size + ", but found " + stride, "byteStride");
            // data that end early are refused before the numbers get their memory
            file.openView(view, offset, count == 0 ? 0 : Number(count - 1) * stride + size, json);
            slices(count, NUMBERS_PER_STEP / _width, function(first:int, end:int):void
                {
                    if (first < end)
                    {
                        var length:Number = Number(end - first - 1) * stride + size;
                        readRows(file.openView(view, offset + Number(first) * stride, length, json), first, end, stride, stride == size);
                    }
                });
        }

        private function readRows(bytes:ByteArray, first:int, end:int, stride:int, areJoined:Boolean):void
        {
            var at:int = first * _width;
            var last:int = end * _width;
            // data without gaps is read as one long row
            var rowLength:int = areJoined ? last - at : _width;
            var start:int = bytes.position;
            while (at < last)
            {
                bytes.position = start;
                readRow(bytes, _componentType, numbers, at, at + rowLength);
                at += rowLength;
                start += stride;
            }
            for (at = first * _width; at < last && _divisor > 0; at++)
            {
                var value:Number = numbers[at] / _divisor;
                numbers[at] = value < -1 ? -1 : value;
            }
        }

        // Adds the steps that replace some elements.
        private function addSparse(file:GltfFile, sparse:GltfJson):void
        {
            var some:int = sparse.requiredWhole("count", count);
            var indices:GltfJson = sparse.object("indices");
            var values:GltfJson = sparse.object("values");
            sparse.refuseIf(indices == null || values == null, "expected indices and values");
            sparse.refuseIf(!indices.has("bufferView") || !values.has("bufferView"), "expected indices and values in bufferViews");
            var at:GltfAccessor = new GltfAccessor(file, indices, some, 1, indices.requiredWhole("componentType", int.MAX_VALUE), false);
            var by:GltfAccessor = new GltfAccessor(file, values, some, _width, _componentType, _divisor > 0);
            add(at).add(by).slices(some, NUMBERS_PER_STEP / _width, function(first:int, end:int):void
                {
                    replace(at, by.numbers, first, end);
                });
        }

        private function replace(indices:GltfAccessor, values:Vector.<Number>, first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                var index:Number = indices.numbers[i];
                if (!(index >= 0 && index < count && int(index) == index))
                {
                    throw indices.json.error("element " + i + " is " + index + ", but there are only " + count + " to replace");
                }
                for (var k:int = 0; k < _width; k++)
                {
                    numbers[int(index) * _width + k] = values[i * _width + k];
                }
            }
        }

        private static function readRow(bytes:ByteArray, componentType:int, out:Vector.<Number>, at:int, last:int):void
        {
            // the sign bit; 0 for a type without negative numbers
            var sign:int = componentType == SHORT ? 0x8000 : (componentType == BYTE ? 0x80 : 0);
            var number:int;
            if (componentType == FLOAT)
            {
                while (at < last)
                {
                    out[at++] = bytes.readFloat();
                }
            }
            else if (componentType == UNSIGNED_INT)
            {
                while (at < last)
                {
                    out[at++] = bytes.readUnsignedInt();
                }
            }
            else
            {
                var isShort:Boolean = SIZES[componentType] == 2;
                while (at < last)
                {
                    number = isShort ? bytes.readUnsignedShort() : bytes.readUnsignedByte();
                    out[at++] = number - ((number & sign) << 1);
                }
            }
        }
    }
}
