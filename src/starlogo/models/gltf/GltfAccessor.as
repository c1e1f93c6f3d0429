package starlogo.models.gltf
{
    import flash.utils.ByteArray;
    import starlogo.models.ModelBudget;
    import starlogo.models.ModelError;
    import starlogo.models.refuseIf;
    import starlogo.steps.StepSequence;

    /**
     * Reads the numbers of an accessor, in steps. The accessor may have any kind of number, be normalised, have gaps between rows, or be
     * sparse.
     *
     * <p>The loops are written out for each kind of number, because they take most of the time of reading a large file.</p>
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
        private static const WIDTHS:Object = {SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16};
        private static const LARGEST:Object = {5120: 127, 5121: 255, 5122: 32767, 5123: 65535};

        /** The numbers, when no step is left. */
        public var numbers:Vector.<Number>;

        /** The number of elements. Each has one or more numbers. */
        public var count:int;

        /** Its place in the file, for errors. */
        public var place:String;

        private var _file:GltfFile;
        private var _accessor:Object;
        private var _width:int;
        private var _kind:int;

        // integers are divided by this; 0 for no division
        private var _divisor:Number = 0;

        // the rows: their bufferView, the offset of the first, and the distance between two
        private var _view:int;
        private var _offset:int;
        private var _stride:int;

        // for a sparse accessor: the elements that replace others
        private var _sparse:Object;
        private var _replaced:Vector.<Number>;

        /**
         * @param file the file; all its steps must be done
         * @param index the accessor's index
         */
        public function GltfAccessor(file:GltfFile, index:int)
        {
            var json:GltfJson = file.json;
            place = "accessors[" + index + "]";
            _file = file;
            _accessor = json.entry("accessors", index);
            count = json.whole(_accessor, "count", place, int.MAX_VALUE, -1);
            _width = WIDTHS[_accessor.type];
            _kind = kindOf(_accessor, place);
            _divisor = _accessor.normalized === true && LARGEST[_kind] > 0 ? LARGEST[_kind] : 0;
            _view = json.reference(_accessor, "bufferView", place, "bufferViews");
            _offset = json.whole(_accessor, "byteOffset", place, int.MAX_VALUE, 0);
            if (_view >= 0)
            {
                var size:int = SIZES[_kind] * _width;
                _stride = json.whole(json.entry("bufferViews", _view), "byteStride", "bufferViews[" + _view + "]", 252, size);
                refuseIf(_stride < size, json.name, "expected at least " + size + ", but found " + _stride, "bufferViews[" + _view + "].byteStride");
                file.openView(_view, _offset, count == 0 ? 0 : Number(count - 1) * _stride + size, place);
                slices(count, NUMBERS_PER_STEP / _width, readRows);
            }
            file.budget.take(_view < 0 ? ModelBudget.ZEROS : ModelBudget.NUMBERS, Number(count) * _width, place);
            numbers = new Vector.<Number>(count * _width);
            _sparse = json.objectIn(_accessor, "sparse", place);
            if (_sparse != null)
            {
                readSparse(json);
            }
        }

        /** Whether its numbers are unsigned integers, as a list of indices requires. */
        public function get areIndices():Boolean
        {
            return _divisor == 0 && (_kind == UNSIGNED_BYTE || _kind == UNSIGNED_SHORT || _kind == UNSIGNED_INT);
        }

        private function kindOf(owner:Object, where:String):int
        {
            var kind:int = _file.json.whole(owner, "componentType", where, int.MAX_VALUE, -1);
            refuseIf(!SIZES.hasOwnProperty(kind), _file.json.name, "expected 5120 to 5123, 5125 or 5126, but found " + kind, where + ".componentType");
            return kind;
        }

        private function readRows(first:int, end:int):void
        {
            if (first < end)
            {
                read(_view, _offset + Number(first) * _stride, _stride, _kind, _width, numbers, first, end);
            }
        }

        private function readSparse(json:GltfJson):void
        {
            var where:String = place + ".sparse";
            var sparseCount:int = json.whole(_sparse, "count", where, count, -1);
            var indices:Object = json.objectIn(_sparse, "indices", where);
            var values:Object = json.objectIn(_sparse, "values", where);
            refuseIf(indices == null || values == null, json.name, "expected indices and values", where);
            var indexKind:int = kindOf(indices, where + ".indices");
            var indexView:int = json.reference(indices, "bufferView", where + ".indices", "bufferViews");
            var valueView:int = json.reference(values, "bufferView", where + ".values", "bufferViews");
            refuseIf(indexView < 0 || valueView < 0, json.name, "expected indices and values in bufferViews", where);
            var indexOffset:int = json.whole(indices, "byteOffset", where + ".indices", int.MAX_VALUE, 0);
            var valueOffset:int = json.whole(values, "byteOffset", where + ".values", int.MAX_VALUE, 0);
            var size:int = SIZES[_kind] * _width;
            _file.openView(indexView, indexOffset, Number(sparseCount) * SIZES[indexKind], where + ".indices");
            _file.openView(valueView, valueOffset, Number(sparseCount) * size, where + ".values");
            _file.budget.take(ModelBudget.NUMBERS, Number(sparseCount) * (1 + _width), where);
            _replaced = new Vector.<Number>(sparseCount);
            var row:Vector.<Number> = new Vector.<Number>(sparseCount * _width);
            slices(sparseCount, NUMBERS_PER_STEP / _width, function(first:int, end:int):void
                {
                    if (first < end)
                    {
                        read(indexView, indexOffset + first * SIZES[indexKind], SIZES[indexKind], indexKind, 1, _replaced, first, end);
                        read(valueView, valueOffset + first * size, size, _kind, _width, row, first, end);
                        replace(row, first, end);
                    }
                });
        }

        private function replace(row:Vector.<Number>, first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                var index:Number = _replaced[i];
                if (!(index >= 0 && index < count && int(index) == index))
                {
                    throw new ModelError(_file.json.name, place + ".sparse.indices", "element " + i + " is " + index + ", but there are only " + count + " to replace");
                }
                for (var k:int = 0; k < _width; k++)
                {
                    numbers[int(index) * _width + k] = row[i * _width + k];
                }
            }
        }

        private function read(view:int, offset:Number, stride:int, kind:int, width:int, out:Vector.<Number>, first:int, end:int):void
        {
            var bytes:ByteArray = _file.openView(view, offset, Number(end - first - 1) * stride + SIZES[kind] * width, place);
            var isDense:Boolean = stride == SIZES[kind] * width;
            var at:int = first * width;
            var last:int = end * width;
            // data without gaps is read as one long row
            var rowLength:int = isDense ? last - at : width;
            var start:int = bytes.position;
            while (at < last)
            {
                bytes.position = start;
                readRow(bytes, kind, out, at, at + rowLength);
                at += rowLength;
                start += stride;
            }
            if (_divisor > 0 && out != _replaced)
            {
                normalise(out, first * width, last);
            }
        }

        private static function readRow(bytes:ByteArray, kind:int, out:Vector.<Number>, at:int, last:int):void
        {
            // the sign bit; 0 for a kind without negative numbers
            var sign:int = kind == SHORT ? 0x8000 : (kind == BYTE ? 0x80 : 0);
            var number:int;
            if (kind == FLOAT)
            {
                while (at < last)
                {
                    out[at++] = bytes.readFloat();
                }
            }
            else if (kind == UNSIGNED_INT)
            {
                while (at < last)
                {
                    out[at++] = bytes.readUnsignedInt();
                }
            }
            else if (SIZES[kind] == 2)
            {
                while (at < last)
                {
                    number = bytes.readUnsignedShort();
                    out[at++] = number - ((number & sign) << 1);
                }
            }
            else
            {
                while (at < last)
                {
                    number = bytes.readUnsignedByte();
                    out[at++] = number - ((number & sign) << 1);
                }
            }
        }

        private function normalise(out:Vector.<Number>, at:int, last:int):void
        {
            for (var i:int = at; i < last; i++)
            {
                var value:Number = out[i] / _divisor;
                out[i] = value < -1 ? -1 : value;
            }
        }
    }
}
