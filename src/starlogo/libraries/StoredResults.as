package starlogo.libraries
{
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.data.Fingerprint;
    import starlogo.engine;
    import starlogo.geometry.VertexBounds;
    import starlogo.libraries.cooked.CookedStructures;
    import starlogo.libraries.cooked.CookedTree;
    import starlogo.models.Model;
    import starlogo.models.cooked.CookedFile;
    import starlogo.solid.ModelTree;
    import starlogo.solid.SurfaceTopology;

    use namespace engine;

    /**
     * The results for a model that are stored in a file, as far as some settings want them.
     *
     * @private
     */
    public final class StoredResults
    {
        /** The structures; null if they are not wanted, or if the file does not have all that are. */
        public var structures:ModelStructures = null;

        /** The bytes that say how the tree is divided: see CookedTree. Null if they are not wanted, or not there. */
        public var division:ByteArray = null;

        /** The surface; null if there is no division, or no surface in the file. */
        public var surface:SurfaceTopology = null;

        /**
         * Reads the results of a file.
         *
         * @param file must be the model's: a cooked model brought it, or its geometry was compared
         */
        public static function read(file:CookedFile, settings:FitSettings, model:Model):StoredResults
        {
            var stored:StoredResults = new StoredResults();
            var size:Number = VertexBounds.of(model.vertices).largest;
            // no fitter accepts a larger model, so its file is wrong
            if (size <= VertexBounds.LARGEST_VERTEX)
            {
                stored.structures = readStructures(file, settings, size);
                stored.division = settings.sectionOf(file, CookedFile.HIERARCHY);
                var bytes:ByteArray = stored.division == null || model.triangles == null ? null : settings.sectionOf(file, CookedFile.SURFACE);
                stored.surface = bytes == null ? null : SurfaceTopology.read(bytes, model.triangles.length / 3);
            }
            return stored;
        }

        private static function readStructures(file:CookedFile, settings:FitSettings, size:Number):ModelStructures
        {
            var found:Vector.<BoundingStructure> = CookedStructures.read(settings.sectionOf(file, CookedFile.STRUCTURES), BoundingStructure.BOX, size);
            // The smallest sphere may be in the hull's place.
            var hulls:Vector.<BoundingStructure> = CookedStructures.read(settings.sectionOf(file, CookedFile.HULL), BoundingStructure.HULL, size);
            var hull:BoundingStructure = hulls == null ? null : hulls[BoundingStructure.HULL] || hulls[BoundingStructure.SPHERE];
            return found == null || hulls == null && settings.wantsHull ? null : new ModelStructures(found, hull, settings.keepsAll);
        }

        /**
         * Makes the bytes of a file with results.
         *
         * @param structures null for none
         * @param tree built; null for none. If its surface is prepared, the file has that too
         * @param settings the settings of the results
         * @param modelKey see <code>CookedFile.MODEL</code>
         * @param model the bytes of the model; null for none
         */
        public static function write(structures:ModelStructures, tree:ModelTree, settings:FitSettings, modelKey:Fingerprint, model:ByteArray):ByteArray
        {
            var contents:Vector.<ByteArray> = new Vector.<ByteArray>(CookedFile.SECTIONS, true);
            contents[CookedFile.MODEL] = model;
            if (structures != null)
            {
                contents[CookedFile.STRUCTURES] = CookedStructures.write(structures.smallest);
                var hull:BoundingStructure = structures.hullOrSphere;
                contents[CookedFile.HULL] = hull == null ? null : CookedStructures.write(new <BoundingStructure>[hull]);
            }
            if (tree != null)
            {
                contents[CookedFile.HIERARCHY] = CookedTree.write(tree.boxTree);
                if (tree.hasInterior)
                {
                    contents[CookedFile.SURFACE] = CookedFile.newBytes();
                    tree.surface.writeTo(contents[CookedFile.SURFACE]);
                }
            }
            return settings.bytesOfFile(modelKey, contents);
        }
    }
}
