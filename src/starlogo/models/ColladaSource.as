package starlogo.models
{
    /** The points of a COLLADA source: its array, seen through its accessor. */
    internal final class ColladaSource
    {
        /** All is static. */
        public function ColladaSource()
        {
        }

        /**
         * Reads a source.
         *
         * @return x, y, z, ...
         */
        internal static function points(document:ColladaDocument, source:XML):Vector.<Number>
        {
            var technique:XML = document.requiredChild(source, "technique_common");
            var accessor:XML = document.requiredChild(technique, "accessor");
            var array:XML = document.target(accessor, "source", ["float_array", "int_array"], source);
            var numbers:Vector.<Number> = document.numbers(array);
            document.checkCount(array, numbers.length, "numbers");

            var stride:Number = document.integer(accessor, "stride", 1);
            var columns:Vector.<int> = columnsOf(document, accessor, stride);
            var offset:Number = document.integer(accessor, "offset", 0);
            var count:Number = document.integer(accessor, "count", Math.max(0, Math.floor((numbers.length - offset) / stride)));
            var last:Number = offset + stride * (count - 1) + Math.max(columns[0], columns[1], columns[2]);
            if (count > 0 && last >= numbers.length)
            {
                throw document.error(accessor, "its count of " + count + " with a stride of " + stride + " reaches beyond the " +
                        numbers.length + " numbers of its array");
            }
            return isPlain(columns, stride, offset, 3 * count == numbers.length) ? numbers : pick(numbers, columns, stride, offset, count);
        }

        private static function isPlain(columns:Vector.<int>, stride:int, offset:int, isWhole:Boolean):Boolean
        {
            return isWhole && stride == 3 && offset == 0 && columns[0] == 0 && columns[1] == 1 && columns[2] == 2;
        }

        private static function pick(numbers:Vector.<Number>, columns:Vector.<int>, stride:int, offset:int, count:int):Vector.<Number>
        {
            var points:Vector.<Number> = new Vector.<Number>(3 * count);
            for (var i:int = 0; i < points.length; i += 3)
            {
                points[i] = numbers[offset + columns[0]];
                points[i + 1] = numbers[offset + columns[1]];
                points[i + 2] = numbers[offset + columns[2]];
                offset += stride;
            }
            return points;
        }

        /** Which of an accessor's parameters are x, y and z: by their names, else the first three. */
        private static function columnsOf(document:ColladaDocument, accessor:XML, stride:Number):Vector.<int>
        {
            var names:Array = [];
            for each (var param:XML in ColladaDocument.children(accessor, "param"))
            {
                names.push(param.@name.toString());
            }
            var columns:Vector.<int> = new <int>[names.indexOf("X"), names.indexOf("Y"), names.indexOf("Z")];
            if (columns.indexOf(-1) >= 0)
            {
                columns = new <int>[0, 1, 2];
            }
            if (names.length < 3 && names.length > 0 || Math.max(columns[0], columns[1], columns[2]) >= stride)
            {
                throw document.error(accessor, "expected the parameters X, Y and Z of points, within its stride of " + stride);
            }
            return columns;
        }
    }
}
