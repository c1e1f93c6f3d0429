package starlogo.models
{
    /**
     * How large models may be: sizes that players can hold with room to spare (docs/limits.md).
     *
     * @private
     */
    public final class ModelLimits
    {
        /** How many vertices a file may have; instances may make any number of a small file's. */
        public static const VERTICES:int = 1000000;

        /** How many triangles. */
        public static const TRIANGLES:int = 2000000;

        /** How many bytes. */
        public static const BYTES:int = 67108864;

        /** What is wrong with a file that has more. */
        public static const PROBLEM:String = "it has more than 1000000 vertices or 2000000 triangles";

        /** All is static. */
        public function ModelLimits()
        {
        }

        /** Whether a model has too much of something. */
        public static function areExceeded(vertexCount:int, triangleCount:int):Boolean
        {
            return vertexCount > VERTICES || triangleCount > TRIANGLES;
        }
    }
}
