package starlogo.models
{
    /**
     * The largest models that can be loaded. Players can hold these sizes easily (docs/limits.md).
     *
     * @private
     */
    public final class ModelLimits
    {
        /** The most vertices of a file. A small file can place its meshes many times, so it can ask for any number. */
        public static const VERTICES:int = 1000000;

        /** The most triangles of a file. */
        public static const TRIANGLES:int = 2000000;

        /** The most bytes of a file. */
        public static const BYTES:int = 67108864;

        /** The message for a file that has more vertices or triangles. */
        public static const PROBLEM:String = "it has more than 1000000 vertices or 2000000 triangles";

        /** Has only static members. */
        public function ModelLimits()
        {
        }

        /** Whether there are too many vertices or triangles. */
        public static function areExceeded(vertexCount:int, triangleCount:int):Boolean
        {
            return vertexCount > VERTICES || triangleCount > TRIANGLES;
        }
    }
}
