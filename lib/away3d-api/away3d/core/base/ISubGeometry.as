package away3d.core.base
{
    /** Vertices and triangles. */
    public interface ISubGeometry
    {
        /** How many vertices there are. */
        function get numVertices():uint;

        /** How many triangles there are. */
        function get numTriangles():uint;

        /** How many numbers there are from one vertex to the next. */
        function get vertexStride():uint;

        /** The index of the first vertex's x. */
        function get vertexOffset():int;

        /** The vertices' numbers. */
        function get vertexData():Vector.<Number>;

        /** Three vertices a triangle. */
        function get indexData():Vector.<uint>;
    }
}
