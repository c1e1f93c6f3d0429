package starlogo.models
{
    /** The axis that points up in a file: turns what has x or y up to z up. */
    internal final class UpAxis
    {
        /** The axes that there are. */
        internal static const X:String = "x";

        /** @copy #X */
        internal static const Y:String = "y";

        /** @copy #X */
        internal static const Z:String = "z";

        /** All is static. */
        public function UpAxis()
        {
        }

        /** Whether a text names an axis. */
        internal static function isValid(axis:String):Boolean
        {
            return axis == X || axis == Y || axis == Z;
        }

        /**
         * Turns vertices in place. With y up, -z of the file becomes y; with x up, -y becomes x and -z becomes y (the
         * right and inward axes of the COLLADA specification's table for up_axis).
         */
        internal static function turn(vertices:Vector.<Number>, axis:String):void
        {
            if (axis == Z)
            {
                return;
            }
            var isX:Boolean = axis == X;
            var length:int = vertices.length;
            for (var i:int = 0; i < length; i += 3)
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
