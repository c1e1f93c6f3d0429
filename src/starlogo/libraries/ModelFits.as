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
     * The results that were computed for a model: the smallest structures, the division of the triangles in the hierarchy, and the surface.
     * A cooked file contains it and a FitStore keeps it. A checksum protects both.
     */
    public final class ModelFits
    {
        /**
         * The smallest structure of each kind, or null. The index is the kind's number. The list is null if there are no structures.
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
         * The surface for exact tests; null if it was not prepared.
         *
         * @private
         */
        engine var surface:Surface = null;

        /** Empty. GreatLand and FitStore make them. */
        public function ModelFits()
        {
        }

        /** Whether it has structures. */
        public function get hasStructures():Boolean
        {
            return structures != null;
        }

        /** Whether it has a hierarchy. */
        public function get hasHierarchy():Boolean
        {
            return tree != null;
        }

        /** Whether it has the surface for exact colliders. */
        public function get hasSurface():Boolean
        {
            return surface != null;
        }

        /**
         * The results that the libraries have for a model.
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
