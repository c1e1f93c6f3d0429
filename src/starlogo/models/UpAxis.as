package starlogo.models
{
    import starlogo.steps.Slices;
    import starlogo.steps.Steps;

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

        private static const VERTICES_PER_STEP:int = 4000;

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

        /** The turn, as a transform: see turning(). */
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

        /**
         * The work that turns vertices in place. With y up, -z of the file becomes y; with x up, -y becomes x and -z becomes y (the
         * right and inward axes of the COLLADA specification's table for up_axis).
         *
         * @return null if z is up
         */
        public static function turning(vertices:Vector.<Number>, axis:String):Steps
        {
            if (axis == Z)
            {
                return null;
            }
            var isX:Boolean = axis == X;
            return new Slices(vertices.length / 3, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    turn(vertices, isX, first, end);
                });
        }

        private static function turn(vertices:Vector.<Number>, isX:Boolean, first:int, end:int):void
        {
            var last:int = 3 * end;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var j:int = i + 1;
                var k:int = i + 2;
                var x:Number = vertices[i];
                var y:Number = vertices[j];
                vertices[i] = isX ? -y : x;
                vertices[j] = -vertices[k];
                vertices[k] = isX ? x : y;
            }
        }
    }
}
