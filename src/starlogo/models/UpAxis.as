package starlogo.models
{
    /**
     * The axis that points up in a file. Gives the transform that turns x or y up to z up.
     *
     * @private
     */
    public final class UpAxis
    {
        /** The names of the axes. */
        public static const X:String = "x";

        /** @copy #X */
        public static const Y:String = "y";

        /** @copy #X */
        public static const Z:String = "z";

        /**
         * The name of an up axis.
         *
         * @param upAxis a name, or a ModelTransform, which stands for "z"
         * @param name the model's name
         * @throws ModelError if it is neither
         */
        public static function of(upAxis:Object, name:String):String
        {
            if (upAxis is ModelTransform)
            {
                return Z;
            }
            refuseIf(upAxis != X && upAxis != Y && upAxis != Z, name, "the up axis must be \"x\", \"y\" or \"z\", or a ModelTransform, not " +
                    (upAxis is String ? "\"" + upAxis + "\"" : upAxis));
            return String(upAxis);
        }

        /**
         * The turn to z up. If y is up, the file's -z becomes y. If x is up, -y becomes x and -z becomes y. (The COLLADA specification's
         * table for up_axis gives the right and inward axes.)
         */
        public static function transform(axis:String):AffineTransform
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
