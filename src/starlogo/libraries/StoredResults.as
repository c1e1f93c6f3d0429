package starlogo.libraries
{
    import starlogo.engine;
    import starlogo.models.cooked.CookedFile;

    use namespace engine;

    /** The results for a model that a FitStore has kept: a cooked file without the model. */
    public final class StoredResults
    {
        /** @private The file, which is whole. */
        engine var file:CookedFile;

        /** A FitStore makes them. */
        public function StoredResults()
        {
        }

        /** Whether they have structures. */
        public function get hasStructures():Boolean
        {
            return file.has(CookedFile.STRUCTURES);
        }

        /** Whether they have a hull, or the sphere in its place. */
        public function get hasHull():Boolean
        {
            return file.has(CookedFile.HULL);
        }

        /** Whether they have a hierarchy. */
        public function get hasHierarchy():Boolean
        {
            return file.has(CookedFile.HIERARCHY);
        }

        /** Whether they have the surface for exact colliders. */
        public function get hasSurface():Boolean
        {
            return file.has(CookedFile.SURFACE);
        }
    }
}
