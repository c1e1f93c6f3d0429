// This room joins the engine to Away3D, and is the only one that names it. Away3dModel makes models of what is drawn (SourceReader), and
// Away3dAgentBinding keeps an agent and its object in the same place; Away3dWireframe and Away3dTerrain draw what collides. Read this file first.
package starlogo.away3d
{
    import flash.geom.Vector3D;
    import starlogo.models.Model;
    import starlogo.models.building.ModelBuilder;

    /**
     * A model made from Away3D's own objects or geometry. A point (x, y, z) of Away3D, with y up, becomes (x, z, y) in the engine.
     *
     * <p>The source is an ObjectContainer3D (a Mesh is one), a Geometry, an ISubGeometry, or an Array or Vector of these. A list makes one
     * model. For example, the geometries of an animated mesh's frames make one model that encloses all frames. The transforms of a
     * container's children count, including mirrors and shared geometry. The source's own transform does not count, because it places the
     * object in the world, as an Away3dAgentBinding does. All meshes count, visible or not.</p>
     *
     * <p>Vertices at equal positions become one, because Away3D's parsers and primitives repeat vertices for their normals. Vertices that
     * no triangle uses are left out. Triangles are counter-clockwise seen from the side that Away3D shows.</p>
     *
     * <p>20,000 vertices with their triangles take about a quarter of a second in Ruffle. To read while a game runs, use an
     * Away3dModelReader.</p>
     */
    public final class Away3dModel extends Model
    {
        /**
         * Reads a model at once.
         *
         * @param name what agents call the shape, not empty
         * @param object the source, which is not changed; or, for the engine alone, the ModelBuilder of its model
         * @throws ModelError if the object is no such source or has no vertices, if its data end early, if a coordinate is not finite,
         * or if the name is empty
         */
        public function Away3dModel(name:String, object:Object)
        {
            super(name, null, null, null, (object as ModelBuilder || new SourceReader(name, object).building()).build());
        }

        /**
         * The point of the source's own space, in Away3D's axes, that becomes the model's origin.
         */
        public function get origin():Vector3D
        {
            var offset:Vector3D = source.offset;
            return new Vector3D(offset.x, offset.z, offset.y);
        }

        /** The width of the source in its own units. It is the length of the model's unit. */
        public function get width():Number
        {
            return source.unit;
        }
    }
}
