package starlogo.libraries.cooked
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Fingerprint;
    import starlogo.libraries.FitSettings;
    import starlogo.libraries.ModelFits;

    use namespace engine;

    /**
     * Writes fits in the form that .fits files have (docs/stored-fits.md). All numbers have their lowest byte first.
     *
     * <pre>
     * at 0   "FITS"
     *    4   the version of the form
     *    8   the length of the whole in bytes, a multiple of 8
     *   12   0
     *   16   the fingerprint of the geometry
     *   24   three sections, structures, hierarchy and surface: the fingerprint of the settings each, its length, 0
     *   72   the sections, filled up to a multiple of 8 with zeros
     *   end  the fingerprint of all before
     * </pre>
     */
    public final class FitsWriter
    {
        /** The byte order. */
        public static const ENDIAN:String = Endian.LITTLE_ENDIAN;

        /** "FITS". */
        public static const MAGIC:int = 0x53544946;

        /** The version of the form. */
        public static const VERSION:int = 1;

        /** Where the sections begin. */
        public static const HEAD_LENGTH:int = 72;

        /** All is static. */
        public function FitsWriter()
        {
        }

        /**
         * A whole .fits file.
         *
         * @param fits what it keeps
         * @param geometry what it is of
         * @param settings what it was computed with
         */
        public static function write(fits:ModelFits, geometry:Fingerprint, settings:FitSettings):ByteArray
        {
            var structures:ByteArray = newBytes();
            var tree:ByteArray = newBytes();
            var surface:ByteArray = newBytes();
            if (fits.structures != null && settings.structures != null)
            {
                writeStructures(fits.structures, structures);
            }
            if (fits.tree != null && settings.hierarchy != null)
            {
                tree.writeBytes(fits.tree);
                if (fits.notes != null)
                {
                    fits.notes.writeTo(surface);
                }
            }
            var out:ByteArray = newBytes();
            out.writeInt(MAGIC);
            out.writeInt(VERSION);
            out.writeInt(HEAD_LENGTH + roundedUp(structures.length) + roundedUp(tree.length) + roundedUp(surface.length)
                    + Fingerprint.LENGTH);
            out.writeInt(0);
            geometry.writeTo(out);
            writeEntry(settings.structures, structures.length, out);
            writeEntry(settings.hierarchy, tree.length, out);
            writeEntry(settings.hierarchy, surface.length, out);
            writeSection(structures, out);
            writeSection(tree, out);
            writeSection(surface, out);
            var whole:Fingerprint = new Fingerprint();
            out.position = 0;
            whole.addBytes(out, out.length / Fingerprint.LENGTH);
            whole.writeTo(out);
            out.position = 0;
            return out;
        }

        /** A length filled up to a multiple of 8. */
        public static function roundedUp(length:int):int
        {
            return length + 7 & ~7;
        }

        private static function newBytes():ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.endian = ENDIAN;
            return bytes;
        }

        private static function writeEntry(settings:Fingerprint, length:int, out:ByteArray):void
        {
            (settings || new Fingerprint()).writeTo(out);
            out.writeInt(length);
            out.writeInt(0);
        }

        private static function writeSection(section:ByteArray, out:ByteArray):void
        {
            if (section.length > 0)
            {
                out.writeBytes(section);
            }
            while (out.length % Fingerprint.LENGTH != 0)
            {
                out.writeByte(0);
            }
        }

        // For each kind whether there is one, then their numbers.
        private static function writeStructures(structures:Vector.<BoundingStructure>, out:ByteArray):void
        {
            var sphere:Sphere = structures[BoundingStructure.SPHERE] as Sphere;
            var capsule:Capsule = structures[BoundingStructure.CAPSULE] as Capsule;
            var box:Box = structures[BoundingStructure.BOX] as Box;
            out.writeInt((sphere == null ? 0 : 1) | (capsule == null ? 0 : 2) | (box == null ? 0 : 4));
            if (sphere != null)
            {
                writeVector(sphere.center, out);
                out.writeDouble(sphere.radius);
            }
            if (capsule != null)
            {
                writeVector(capsule.start, out);
                writeVector(capsule.end, out);
                out.writeDouble(capsule.radius);
            }
            if (box != null)
            {
                writeVector(box.center, out);
                writeVector(box.axisX, out);
                writeVector(box.axisY, out);
                writeVector(box.axisZ, out);
                out.writeDouble(box.halfX);
                out.writeDouble(box.halfY);
                out.writeDouble(box.halfZ);
            }
        }

        private static function writeVector(vector:Vector3D, out:ByteArray):void
        {
            out.writeDouble(vector.x);
            out.writeDouble(vector.y);
            out.writeDouble(vector.z);
        }
    }
}
