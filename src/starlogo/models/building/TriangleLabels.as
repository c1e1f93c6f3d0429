package starlogo.models.building
{
    import starlogo.data.keyOf;
    import starlogo.data.lastAtMost;

    /**
     * The label of each triangle: the number of its material or of its mesh, which may have a name. A reader says where triangles with another label
     * begin.
     *
     * @private
     */
    public final class TriangleLabels
    {
        /** The name of each label, or null for a label without a name. Null if nothing gives names; set it before there are labels. */
        public var names:Vector.<String>;

        /**
         * Triangles that follow one another and have the same label are a run. This is the first triangle of each run. <code>seal()</code> adds the
         * number of triangles, so each run ends where the next entry begins. They are Numbers, as <code>lastAtMost()</code> takes them. Read only.
         */
        public var firstTriangles:Vector.<Number> = new <Number>[0];

        /** The label of each run. The first run has -1, for triangles without a label. Only the first run may have no triangle. Read only. */
        public var labelsOfRuns:Vector.<int> = new <int>[-1];

        // The label of each triangle, after it was first asked for.
        private var _labels:Vector.<int> = null;

        private var _labelsOfKeys:Object = {};

        /** Labels without triangles. @param names the name of each label so far; kept; null if nothing will give names */
        public function TriangleLabels(names:Vector.<String>)
        {
            this.names = names;
        }

        /** The label of a key. A new key gets the next label. @param name the label's name; null for none */
        public function labelWithKey(key:String, name:String):int
        {
            var entry:String = keyOf(key);
            if (!(entry in _labelsOfKeys))
            {
                _labelsOfKeys[entry] = addLabel(name);
            }
            return _labelsOfKeys[entry];
        }

        /** Adds the next label. @param name null for none */
        public function addLabel(name:String):int
        {
            return names.push(name) - 1;
        }

        /** The label of the last run. Triangles that come next have it. */
        public function get current():int
        {
            return labelsOfRuns[labelsOfRuns.length - 1];
        }

        /** Gives a label to all triangles from one on. It must not be before the last run. */
        public function beginRun(label:int, triangle:int):void
        {
            endRun(triangle);
            if (label != current)
            {
                firstTriangles.push(triangle);
                labelsOfRuns.push(label);
            }
        }

        /** Ends the last run. If then no triangle has a label, there are no names either. @param count the number of triangles */
        public function seal(count:int):void
        {
            endRun(count);
            firstTriangles.push(count);
            names = labelsOfRuns.length == 1 ? null : names;
        }

        /** The label of each triangle, -1 for none, after <code>seal()</code>. Always the same list. Null if no triangle has a label. */
        public function get labels():Vector.<int>
        {
            if (_labels == null && labelsOfRuns.length > 1)
            {
                _labels = new Vector.<int>(firstTriangles[labelsOfRuns.length], true);
                for (var run:int = 0; run < labelsOfRuns.length; run++)
                {
                    for (var i:int = firstTriangles[run]; i < firstTriangles[run + 1]; i++)
                    {
                        _labels[i] = labelsOfRuns[run];
                    }
                }
            }
            return _labels;
        }

        /** The label of a triangle, after <code>seal()</code>; -1 if it has none. */
        public function labelOf(triangle:int):int
        {
            return labelsOfRuns[lastAtMost(firstTriangles, triangle)];
        }

        /** The name of a label; null if it has none. */
        public function nameOf(label:int):String
        {
            return names == null || label < 0 || label >= names.length ? null : names[label];
        }

        // Ends the last run before a triangle. If it has no triangle, it is removed, unless it is the first.
        private function endRun(end:int):void
        {
            var last:int = labelsOfRuns.length - 1;
            if (last > 0 && firstTriangles[last] == end)
            {
                firstTriangles.length = labelsOfRuns.length = last;
            }
        }
    }
}
