package starlogo.libraries
{
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.libraries.cooked.TreeWriter;
    import starlogo.models.cooked.CookedFile;
    import starlogo.solid.SolidHierarchy;
    import starlogo.solid.Surface;

    use namespace engine;

    /**
     * The record of what was computed for a model: the smallest structures, how the hierarchy divides the triangles, and the surface. A cooked
     * file contains it and a FitStore keeps it, sealed by a checksum.
     */
    public final class ModelFits
    {
        /**
         * By the numbers of the kinds, the smallest of each, or null; null if there are none.
         *
         * @private
         */
        engine var structures:Vector.<BoundingStructure> = null;

        /**
         * The bytes that a TreeWriter wrote, from the position on; null if there is no hierarchy.
         *
         * @private
         */
        engine var tree:ByteArray = null;

        /**
         * What exact tests need to know of the surface; null if it was not prepared.
         *
         * @private
         */
        engine var surface:Surface = null;

        /** Empty. GreatLand and FitStore make them. */
        public function ModelFits()
        {
        }

        /** Whether there are structures. */
        public function get hasStructures():Boolean
        {
            return structures != null;
        }

        /** Whether there is a hierarchy. */
        public function get hasHierarchy():Boolean
        {
            return tree != null;
        }

        /** Whether there is what exact colliders need of the surface. */
        public function get hasSurface():Boolean
        {
            return surface != null;
        }

        /**
         * The fits that the libraries have.
         *
         * @param shape null if there are no structures
         * @param hierarchy null if there is none
         *
         * @private
         */
        engine static function of(shape:ShapeStructures, hierarchy:SolidHierarchy):ModelFits
        {
            var fits:ModelFits = new ModelFits();
            if (shape != null)
            {
                fits.structures = shape.smallest;
            }
            if (hierarchy != null)
            {
                fits.tree = CookedFile.newBytes();
                TreeWriter.write(hierarchy, fits.tree);
                fits.tree.position = 0;
                fits.surface = hierarchy.isPrepared ? hierarchy.surface : null;
            }
            return fits;
        }
    }
}
