package starlogo.models.gltf
{
    import flash.utils.ByteArray;
    import starlogo.steps.StepSequence;

    /**
     * Reads the numbers of an accessor, in steps. The accessor may have any kind of number, be normalised, have gaps between rows, or be
     * sparse.
     */
    internal final class GltfAccessor extends StepSequence
    {
        private static const NUMBERS_PER_STEP:int = 20000;

        private static const BYTE:int = 5120;
        private static const UNSIGNED_BYTE:int = 5121;
        private static const SHORT:int = 5122;
        private static const UNSIGNED_SHORT:int = 5123;
        private static const UNSIGNED_INT:int = 5125;

        private static const COMPONENT_SIZES:Object = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4};
        private static const COMPONENT_COUNTS:Object = {SCALAR: 1, VEC3: 3, VEC4: 4, MAT4: 16};
        private static const MAX_VALUES:Object = {5120: 127, 5121: 255, 5122: 32767, 5123: 65535};

        /** The numbers, when no step is left. */
        public var numbers:Vector.<Number>;

        /** The number of elements. Each has one or more numbers. */
        public var count:int;

        /** Its JSON: an accessor, or a part of a sparse one. */
        public var json:GltfJson;

        private var _componentCount:int;
        private var _componentType:int;

        // integers are divided by this; 0 for no division
        private var _divisor:Number = 0;

        /**
         * @param file the file; all its steps must be done
         * @param json an accessor, or the indices or values of a sparse one
         * @param count the number of elements
         * @param componentCount the numbers of each element
         * @param componentType the kind of its numbers: BYTE or another
         * @param isNormalised whether its numbers stand for fractions of the largest one
         */
        public function GltfAccessor(file:GltfFile, json:GltfJson, count:int, componentCount:int, componentType:int, isNormalised:Boolean)
        {
            this.json = json;
            this.count = count;
            _componentCount = componentCount;
            _componentType = componentType;
            json.refuseIf(!COMPONENT_SIZES.hasOwnProperty(componentType), "expected 5120 to 5123, 5125 or 5126, but found " + componentType, "componentType");
            _divisor = isNormalised && MAX_VALUES[componentType] > 0 ? MAX_VALUES[componentType] : 0;
            var view:int = json.indexOrNone("bufferView", "bufferViews");
            var offset:int = json.integer("byteOffset", int.MAX_VALUE, 0);
            if (view >= 0)
            {
                addRows(file, view, offset);
            }
            file.budget.spendNumbers(Number(count) * componentCount, json.place);
            numbers = new Vector.<Number>(count * componentCount);
        }

        /** The accessor that is an entry of the file. */
        public static function of(file:GltfFile, json:GltfJson):GltfAccessor
        {
            var accessor:GltfAccessor = new GltfAccessor(file, json, json.requiredInteger("count", int.MAX_VALUE), COMPONENT_COUNTS[json.raw.type],
                    json.requiredInteger("componentType", int.MAX_VALUE), json.raw.normalized === true);
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
            var size:int = COMPONENT_SIZES[_componentType] * _componentCount;
            var entry:GltfJson = file.json.rootEntry("bufferViews", view);
            var stride:int = entry.integer("byteStride", 252, size);
            entry.refuseIf(stride < size, "expected at least " + size + ", but found " + stride, "byteStride");
            // data that end early are refused before the numbers get their memory
            file.openView(view, offset, count == 0 ? 0 : Number(count - 1) * stride + size, json);
            slices(count, NUMBERS_PER_STEP / _componentCount, function(first:int, end:int):void
                {
                    if (first < end)
                    {
                        var length:Number = Number(end - first - 1) * stride + size;
                        readRows(file.openView(view, offset + Number(first) * stride, length, json), first, end, stride);
                    }
                });
        }

        private function readRows(bytes:ByteArray, first:int, end:int, stride:int):void
        {
            var start:int = bytes.position;
            for (var at:int = first * _componentCount; at < end * _componentCount; at += _componentCount)
            {
                bytes.position = start;
                for (var i:int = at; i < at + _componentCount; i++)
                {
                    var number:Number = readNumber(bytes);
                    numbers[i] = _divisor == 0 ? number : Math.max(-1, number / _divisor);
                }
                start += stride;
            }
        }

        private function readNumber(bytes:ByteArray):Number
        {
            switch (_componentType)
            {
                case BYTE:
                    return bytes.readByte();
                case UNSIGNED_BYTE:
                    return bytes.readUnsignedByte();
                case SHORT:
                    return bytes.readUnsignedShort() << 16 >> 16; // with its sign
                case UNSIGNED_SHORT:
                    return bytes.readUnsignedShort();
                case UNSIGNED_INT:
                    return bytes.readUnsignedInt();
                default:
                    return bytes.readFloat();
            }
        }

        // Adds the steps that replace some elements.
        private function addSparse(file:GltfFile, sparse:GltfJson):void
        {
            var replacedCount:int = sparse.requiredInteger("count", count);
            var indicesJson:GltfJson = sparse.object("indices");
            var valuesJson:GltfJson = sparse.object("values");
            sparse.refuseIf(indicesJson == null || valuesJson == null, "expected indices and values");
            sparse.refuseIf(!indicesJson.has("bufferView") || !valuesJson.has("bufferView"), "expected indices and values in bufferViews");
            var indices:GltfAccessor = new GltfAccessor(file, indicesJson, replacedCount, 1, indicesJson.requiredInteger("componentType", int.MAX_VALUE), false);
            var values:GltfAccessor = new GltfAccessor(file, valuesJson, replacedCount, _componentCount, _componentType, _divisor > 0);
            add(indices).add(values).slices(replacedCount, NUMBERS_PER_STEP / _componentCount, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        var index:Number = indices.numbers[i];
                        if (!(index >= 0 && index < count && int(index) == index))
                        {
                            throw indicesJson.error("element " + i + " is " + index + ", but there are only " + count + " to replace");
                        }
                        for (var k:int = 0; k < _componentCount; k++)
                        {
                            numbers[int(index) * _componentCount + k] = values.numbers[i * _componentCount + k];
                        }
                    }
                });
        }
    }
}
