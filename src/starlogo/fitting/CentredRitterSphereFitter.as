package starlogo.fitting
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.geometry.vertices.VertexBounds;

    /**
     * Finds a bounding sphere whose centre is on the model's z axis, where x and y are 0 (thesis §7.6). It is meant for models that are
     * centred in x and y. For other models it is loose.
     *
     * <p>It is Ritter's algorithm with a fixed axis. The sphere starts between the lowest and the highest vertex. For each vertex outside,
     * it grows just enough to enclose the vertex and the sphere so far, and its centre moves only up or down. It takes two passes over the
     * hull's vertices, and one over all vertices.</p>
     */
    public final class CentredRitterSphereFitter extends Fitter
    {
        /** Creates a fitter of spheres that are centred on the z axis. */
        public function CentredRitterSphereFitter()
        {
            super("centred Ritter sphere");
        }

        /** @inheritDoc */
        override protected function findStructure(session:FitSession):BoundingStructure
        {
            var points:Vector.<Number> = session.hull.points;
            var bounds:VertexBounds = VertexBounds.of(points);
            var z:Number = (bounds.minZ + bounds.maxZ) / 2;
            var radius:Number = (bounds.maxZ - bounds.minZ) / 2;
            for (var i:int = 0; i < points.length; i += 3)
            {
                var across:Number = points[i] * points[i] + points[i + 1] * points[i + 1];
                var up:Number = points[i + 2] - z;
                var height:Number = up < 0 ? -up : up;
                if (across + up * up > radius * radius)
                {
                    // With this shift, the sphere touches the vertex and encloses the old sphere. Moving beyond the vertex's height gains
                    // nothing.
                    var shift:Number = Math.min((across + up * up - radius * radius) / (2 * (radius + height)), height);
                    z += up < 0 ? -shift : shift;
                    radius = Math.sqrt(across + (height - shift) * (height - shift));
                }
            }
            return EnclosingStructures.sphere(session.vertices, new Vector3D(0, 0, z), radius);
        }
    }
}
