package starlogo.fitting
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.geometry.vertices.VertexBounds;

    /**
     * Finds the bounding sphere around the middle of the axis-aligned box (thesis §3.4.1, the naive algorithm), in a pass over the
     * vertices and one over their extreme points. Its radius is at most 1.73 times the smallest, and usually much closer.
     */
    public final class NaiveSphereFitter extends Fitter
    {
        /** Creates a fitter of naive spheres. */
        public function NaiveSphereFitter()
        {
            super("naive sphere");
        }

        /** @inheritDoc */
        override protected function findStructure(session:FitSession):BoundingStructure
        {
            var bounds:VertexBounds = VertexBounds.of(session.hull.points);
            var center:Vector3D = new Vector3D((bounds.minX + bounds.maxX) / 2, (bounds.minY + bounds.maxY) / 2, (bounds.minZ + bounds.maxZ) / 2);
            return EnclosingStructures.sphere(session.vertices, center);
        }
    }
}
