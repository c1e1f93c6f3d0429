package starlogo.fitting
{
    import starlogo.bounding.BoundingStructure;

    /** Finds the smallest box with axes along x, y and z (thesis §3.4.2), in three passes over the vertices. */
    public final class AxisAlignedBoxFitter extends Fitter
    {
        /** Creates a fitter of axis-aligned boxes. */
        public function AxisAlignedBoxFitter()
        {
            super("axis-aligned box");
        }

        /** @inheritDoc */
        override protected function findStructure(session:FitSession):BoundingStructure
        {
            return EnclosingStructures.box(session.vertices, new <Number>[1, 0, 0, 0, 1, 0, 0, 0, 1]);
        }
    }
}
