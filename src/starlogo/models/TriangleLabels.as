package starlogo.models
{
    /**
     * The material or the mesh of each triangle of a model, as a record: a number for each triangle, and a name for each number.
     *
     * @private
     */
    public final class TriangleLabels
    {
        /** The number of each triangle; -1 for none. */
        public var numbers:Vector.<int>;

        /** The name of each number, or null for a number without a name. Null if nothing gave names. */
        public var names:Vector.<String>;

        public function TriangleLabels(numbers:Vector.<int>, names:Vector.<String>)
        {
            this.numbers = numbers;
            this.names = names;
        }

        /** The number of a triangle; -1 if there are no labels or no such triangle. */
        public static function numberOf(labels:TriangleLabels, triangle:int):int
        {
            return labels == null || triangle < 0 || triangle >= labels.numbers.length ? -1 : labels.numbers[triangle];
        }

        /** The name of a number; null if it has none. */
        public static function nameOf(labels:TriangleLabels, number:int):String
        {
            return labels == null || labels.names == null || number < 0 || number >= labels.names.length ? null : labels.names[number];
        }
    }
}
