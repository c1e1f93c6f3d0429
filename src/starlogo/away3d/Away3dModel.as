package starlogo.away3d
{
    import flash.geom.Vector3D;
    import starlogo.models.Model;
    import starlogo.steps.finish;

    /**
     * A model of what Away3D draws. Away3D's (x, y, z), y up, is the engine's (x, z, y).
     *
     * <p>The source is an ObjectContainer3D (a Mesh is one), a Geometry, an ISubGeometry, or an Array or Vector of such, which are
     * taken together: the geometries of an animated mesh's frames make one model that encloses them all. The transforms of a
     * container's children count, mirrors and those in shared geometry too; the source's own does not: it says where the object
     * is in the world, which is the concern of an Away3dAgentBinding. All meshes count, visible or not.</p>
     *
     * <p>Vertices at equal positions are one, since Away3D's parsers and primitives repeat them for their normals; those that no
     * triangle uses are left out. Triangles are counter-clockwise seen from where Away3D shows them.</p>
     *
     * <p>20,000 vertices with their triangles take about a quarter of a second in Ruffle: an Away3dModelReader reads them while a game runs.</p>
     */
    public final class Away3dModel extends Model
    {
        private var _origin:Vector3D;

        /**
         * Reads a model at once.
         *
         * @param name what agents call the shape, not empty
         * @param source the object or geometry; left as it is
         * @throws ModelError if the source is none of the above or has no vertices, its data end early, or a coordinate is not
         *     finite; if the name is empty
         */
        public function Away3dModel(name:String, source:Object)
        {
            var reader:SourceReader = source as SourceReader;
            if (reader == null)
            {
                reader = new SourceReader(name, source);
                finish(reader);
            }
            super(name, reader.vertices, reader.triangles);
            var offset:Vector3D = this.source.offset;
            _origin = new Vector3D(offset.x, offset.z, offset.y);
        }

        /**
         * The point of the source's own space, in Away3D's axes, that is the model's origin. The model's own: do not change
         * it.
         */
        public function get origin():Vector3D
        {
            return _origin;
        }

        /** How wide the source is, in its own units: what a unit of the model is there. */
        public function get width():Number
        {
            return this.source.unit;
        }
    }
}
