package away3d.core.base
{
    /** Vertices and triangles, each kind of data in a list of its own. */
    public class SubGeometry implements ISubGeometry
    {
        public function SubGeometry()
        {
        }

        /** How many vertices there are. */
        public function get numVertices():uint
        {
            return 0;
        }

        /** How many triangles there are. */
        public function get numTriangles():uint
        {
            return 0;
        }

        /** How many numbers there are from one vertex to the next. */
        public function get vertexStride():uint
        {
            return 0;
        }

        /** The index of the first vertex's x. */
        public function get vertexOffset():int
        {
            return 0;
        }

        /** The vertices' numbers. */
        public function get vertexData():Vector.<Number>
        {
            return null;
        }

        /** Three vertices a triangle. */
        public function get indexData():Vector.<uint>
        {
            return null;
        }

        /** Sets the vertices: x, y and z of each. */
        public function updateVertexData(vertices:Vector.<Number>):void
        {
        }

        /** Sets the normals: x, y and z for each vertex. */
        public function updateVertexNormalData(vertexNormals:Vector.<Number>):void
        {
        }

        /** Sets the places in a texture: u and v for each vertex. */
        public function updateUVData(uvs:Vector.<Number>):void
        {
        }

        /** Sets the triangles: three vertices each. */
        public function updateIndexData(indices:Vector.<uint>):void
        {
        }
    }
}
