package starlogo.models.collada
{
    import starlogo.models.text.Decimal;
    import starlogo.models.text.TextWords;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** Reads the points of a COLLADA source, in small steps. The source's accessor says which numbers of its array they are. */
    internal final class ColladaSource extends StepSequence
    {
        private static const POINTS_PER_STEP:int = 2000;

        /** The index of its first point, when no step is left. */
        public var first:int;

        /** The number of its points, when no step is left. */
        public var count:int;

        private var _points:Vector.<Number>;

        /**
         * @param source the source's element
         * @param points takes its points after those already present: x, y, z, ...
         */
        public function ColladaSource(source:ColladaElement, points:Vector.<Number>)
        {
            _points = points;
            var accessor:ColladaElement = source.requiredChild("technique_common").requiredChild("accessor");
            var array:ColladaElement = accessor.target("source", ["float_array", "int_array"], source);
            var text:String = array.text;
            accessor.limits.countNumbers(text.length / 2, accessor);
            accessor.limits.countElements(accessor.children.length, accessor);
            add(TextWords.splitting(text, function(words:Array):Steps
                    {
                        return readingPoints(accessor, array, words);
                    }));
        }

        private function readingPoints(accessor:ColladaElement, array:ColladaElement, words:Array):Steps
        {
            array.checkCount(words.length, "numbers");
            var stride:Number = accessor.integer("stride", 1);
            var offset:Number = accessor.integer("offset", 0);
            var columns:Vector.<int> = columnsOf(accessor, stride);
            var wanted:Number = accessor.integer("count", Math.max(0, Math.floor((words.length - offset) / stride)));
            var last:Number = offset + stride * (wanted - 1) + Math.max(columns[0], columns[1], columns[2]);
            accessor.refuseIf(wanted > 0 && last >= words.length, "its count of " + wanted + " with a stride of " + stride +
                    " reaches beyond the " + words.length + " numbers of its array");
            accessor.limits.countNumbers(3 * wanted, accessor);
            count = wanted;
            first = _points.length / 3;
            return new StepSequence().slices(count, POINTS_PER_STEP, function(from:int, end:int):void
                {
                    for (var i:int = from; i < end; i++)
                    {
                        readPoint(array, words, offset + i * stride, columns, first + i);
                    }
                });
        }

        // Reads the point whose numbers begin at a word.
        private function readPoint(array:ColladaElement, words:Array, at:int, columns:Vector.<int>, index:int):void
        {
            for (var k:int = 0; k < 3; k++)
            {
                var word:String = words[int(at + columns[k])];
                var number:Number = Decimal.of(word);
                _points[3 * index + k] = number - number == 0 ? number : array.toNumber(word);
            }
        }

        // The indices of an accessor's parameters x, y and z: found by name, otherwise the first three.
        private function columnsOf(accessor:ColladaElement, stride:Number):Vector.<int>
        {
            var names:Array = [];
            for each (var param:ColladaElement in accessor.childrenNamed("param"))
            {
                names.push(param.attribute("name"));
            }
            var columns:Vector.<int> = new <int>[names.indexOf("X"), names.indexOf("Y"), names.indexOf("Z")];
            if (columns.indexOf(-1) >= 0)
            {
                columns = new <int>[0, 1, 2];
            }
            accessor.refuseIf(names.length < 3 && names.length > 0 || Math.max(columns[0], columns[1], columns[2]) >= stride,
                    "expected the parameters X, Y and Z of points, within its stride of " + stride);
            return columns;
        }
    }
}
