package starlogo.models.building
{
    import starlogo.data.keyOf;

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

        /** The label of each triangle, -1 for none, after <code>seal()</code>. Null if no triangle has one. Read only. */
        public var labels:Vector.<int> = new Vector.<int>();

        /** The label of the triangles that come next; -1 for none. Read only. */
        public var current:int = -1;

        // The labels of keys.
        private var _known:Object = {};

        /** Labels without triangles. @param names the name of each label so far; kept; null if nothing will give names */
        public function TriangleLabels(names:Vector.<String>)
        {
            this.names = names;
        }

        /** The label of a key. A new key gets the next label. @param name the label's name; null for none */
        public function labelWithKey(key:String, name:String):int
        {
            var known:String = keyOf(key);
            if (_known[known] === undefined)
            {
                _known[known] = addLabel(name);
            }
            return _known[known];
        }

        /** Adds the next label. @param name null for none */
        public function addLabel(name:String):int
        {
            return names.push(name) - 1;
        }

        /** Gives a label to all triangles from one on. It must not be before the last one for which this was called. */
        public function beginRun(label:int, triangle:int):void
        {
            if (label != current)
            {
                fill(triangle);
                current = label;
            }
        }

        /** Ends the labels. If no triangle has one, there are no names either. @param count the number of triangles */
        public function seal(count:int):void
        {
            if (current >= 0 || labels.length > 0)
            {
                fill(count);
            }
            if (!labels.some(isLabel))
            {
                labels = null;
                names = null;
            }
        }

        /** The label of a triangle, after <code>seal()</code>; -1 if it has none. */
        public function labelOf(triangle:int):int
        {
            return labels == null ? -1 : labels[triangle];
        }

        /** The name of a label; null if it has none. */
        public function nameOf(label:int):String
        {
            return names == null || label < 0 || label >= names.length ? null : names[label];
        }

        // Gives the current label to the triangles up to one.
        private function fill(end:int):void
        {
            while (labels.length < end)
            {
                labels.push(current);
            }
        }

        private static function isLabel(label:int, triangle:int, all:Vector.<int>):Boolean
        {
            return label >= 0;
        }
    }
}
