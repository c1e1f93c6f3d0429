package starlogo.models
{
    /**
     * What callers pass as the up axis of a file: an axis, or a ModelTransform.
     *
     * @private
     */
    public final class UpAxis
    {
        /** The names of the axes. */
        public static const X:String = "x";
        public static const Y:String = "y";
        public static const Z:String = "z";

        /** The axis that points up. "z" for a ModelTransform, which leaves the file as it is. Null if the file says it itself. */
        public var axis:String;

        /** The ModelTransform; null if there is none. */
        public var transform:ModelTransform;

        /**
         * @param upAxis "x", "y", "z" or a ModelTransform
         * @param name the model's name
         * @param mayBeNull whether the file can say it itself
         * @throws ModelError if it is none of these
         */
        public function UpAxis(upAxis:Object, name:String, mayBeNull:Boolean)
        {
            transform = upAxis as ModelTransform;
            axis = transform != null ? Z : (upAxis == null ? null : String(upAxis));
            refuseIf(axis == null ? !mayBeNull : axis != X && axis != Y && axis != Z, name,
                    "the up axis must be \"x\", \"y\" or \"z\", or a ModelTransform, not " + (upAxis is String ? "\"" + upAxis + "\"" : upAxis));
        }

        /**
         * The turn to z up. If y is up, the file's -z becomes y. If x is up, -y becomes x and -z becomes y. (The COLLADA specification's
         * table for up_axis gives the right and inward axes.)
         */
        public function get turn():AffineTransform
        {
            switch (axis)
            {
                case X:
                    return new AffineTransform(new <Number>[0, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0]);
                case Y:
                    return new AffineTransform(new <Number>[1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0]);
                default:
                    return new AffineTransform();
            }
        }
    }
}
