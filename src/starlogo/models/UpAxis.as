package starlogo.models
{
    /**
     * The axis that points up in a file: turns what has x or y up to z up.
     *
     * @private
     */
    public final class UpAxis
    {
        /** The axes that there are. */
        public static const X:String = "x";

        /** @copy #X */
        public static const Y:String = "y";

        /** @copy #X */
        public static const Z:String = "z";

        /** All is static. */
        public function UpAxis()
        {
        }

        /**
         * The name of the axis that an argument of a model asks for.
         *
         * @param upAxis a name, or a ModelTransform, which takes the file as it is
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
         * The turn to z up. With y up, -z of the file becomes y; with x up, -y becomes x and -z becomes y (the right and inward axes of the
         * COLLADA specification's table for up_axis).
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
