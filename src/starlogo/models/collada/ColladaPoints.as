package starlogo.models.collada
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /** The points of a COLLADA source in the list of its geometry. Its steps add them. All primitives of the geometry with this source share them. */
    internal final class ColladaPoints extends StepSequence
    {
        private static const POINTS_PER_STEP:int = 2000;

        /** When all is read: the index in the list of the first point. */
        public var first:int;

        /** When all is read: the number of points. */
        public var count:int;

        /**
         * @param source the source's element
         * @param points takes the points, after those already present: x, y, z, ...
         */
        public function ColladaPoints(source:ColladaElement, points:Vector.<Number>)
        {
            var entries:ColladaAccessor = new ColladaAccessor(source, ColladaAccessor.NUMBERS, true);
            add(entries).begin(function():Steps
                {
                    first = points.length / 3;
                    count = entries.count;
                    entries.array.budget.spendNumbers(3 * count, entries.element);
                    return new StepSequence().slices(count, POINTS_PER_STEP, function(from:int, end:int):void
                        {
                            for (var i:int = from; i < end; i++)
                            {
                                for (var k:int = 0; k < 3; k++)
                                {
                                    points.push(entries.array.toNumber(entries.words[i * entries.stride + entries.columns[k]]));
                                }
                            }
                        });
                });
        }
    }
}
