package starlogo.libraries.cooked
{
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Fingerprint;
    import starlogo.libraries.FitSettings;
    import starlogo.libraries.ModelFits;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.CookedNumbers;

    use namespace engine;

    /**
     * Writes fits into the sections of a cooked file (docs/cooked.md).
     *
     * @private
     */
    public final class FitsWriter
    {
        /**
         * Makes the bytes of a cooked file.
         *
         * @param fits the fits
         * @param settings the settings with which they were computed
         * @param wanted the fingerprint of the model's arguments
         * @param shape the section of the model; null if the model is read from elsewhere
         */
        public static function write(fits:ModelFits, settings:FitSettings, wanted:Fingerprint, shape:ByteArray = null):ByteArray
        {
            var structures:ByteArray = CookedFile.newBytes();
            var tree:ByteArray = CookedFile.newBytes();
            var surface:ByteArray = CookedFile.newBytes();
            if (fits.structures != null && settings.structures != null)
            {
                writeStructures(fits.structures, structures);
            }
            if (fits.tree != null && settings.hierarchy != null)
            {
                tree.writeBytes(fits.tree);
                if (fits.surface != null)
                {
                    fits.surface.writeTo(surface);
                }
            }
            return CookedFile.write(new <Fingerprint>[wanted, settings.structures, settings.hierarchy, settings.hierarchy],
                    new <ByteArray>[shape == null ? CookedFile.newBytes() : shape, structures, tree, surface]);
        }

        // First a flag for each kind: whether there is a structure. Then the numbers of the structures.
        private static function writeStructures(structures:Vector.<BoundingStructure>, out:ByteArray):void
        {
            var sphere:Sphere = structures[BoundingStructure.SPHERE] as Sphere;
            var capsule:Capsule = structures[BoundingStructure.CAPSULE] as Capsule;
            var box:Box = structures[BoundingStructure.BOX] as Box;
            out.writeInt((sphere == null ? 0 : 1) | (capsule == null ? 0 : 2) | (box == null ? 0 : 4));
            if (sphere != null)
            {
                CookedNumbers.writeVector(sphere.center, out);
                out.writeDouble(sphere.radius);
            }
            if (capsule != null)
            {
                CookedNumbers.writeVector(capsule.start, out);
                CookedNumbers.writeVector(capsule.end, out);
                out.writeDouble(capsule.radius);
            }
            if (box != null)
            {
                CookedNumbers.writeVector(box.center, out);
                CookedNumbers.writeVector(box.axisX, out);
                CookedNumbers.writeVector(box.axisY, out);
                CookedNumbers.writeVector(box.axisZ, out);
                out.writeDouble(box.halfX);
                out.writeDouble(box.halfY);
                out.writeDouble(box.halfZ);
            }
        }
    }
}
