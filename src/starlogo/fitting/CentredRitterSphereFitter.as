package starlogo.fitting
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.geometry.VertexBounds;

    /**
     * Ritter's sphere with its centre kept on the model's z axis, where x and y are 0 (thesis §7.6): starts between the lowest
     * and the highest vertex, and grows for each vertex outside just enough to hold it and the sphere so far, its centre moving
     * up or down only. Meant for models centred in x and y; around others it is loose. Two passes over the hull's vertices.
     */
    public final class CentredRitterSphereFitter extends Fitter
    {
        /** A fitter of spheres centred on the z axis. */
        public function CentredRitterSphereFitter()
        {
            super("centred Ritter sphere");
        }

        /** @inheritDoc */
        override protected function findStructure(session:FitSession):BoundingStructure
        {
            var points:Vector.<Number> = session.hull.points;
            var bounds:VertexBounds = new VertexBounds();
            bounds.add(points, 0, points.length / 3);
            var z:Number = (bounds.minZ + bounds.maxZ) / 2;
            var radius:Number = (bounds.maxZ - bounds.minZ) / 2;
            for (var i:int = 0; i < points.length; i += 3)
            {
                var across:Number = points[i] * points[i] + points[i + 1] * points[i + 1];
                var up:Number = points[i + 2] - z;
                var height:Number = up < 0 ? -up : up;
                if (across + up * up > radius * radius)
                {
                    // where the sphere that holds the old one touches the vertex too; moving past its height gains nothing
                    var shift:Number = Math.min((across + up * up - radius * radius) / (2 * (radius + height)), height);
                    z += up < 0 ? -shift : shift;
                    radius = Math.sqrt(across + (height - shift) * (height - shift));
                }
            }
            return EnclosingStructures.sphere(session.vertices, 0, 0, z, radius);
        }
    }
}
