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
     *
     * @private
     */
    public final class FitsWriter
    {
        /** The byte order. */
        public static const ENDIAN:String = Endian.LITTLE_ENDIAN;

        /** "FITS". */
        public static const MAGIC:int = 0x53544946;

        /** The version of the form. */
        public static const VERSION:int = 1;

        /** Where the sections start. */
        public static const HEAD_LENGTH:int = 72;

        /** How many sections there are. */
        public static const SECTIONS:int = 3;

        /** How many bytes of the head tell of each. */
        public static const ENTRY_LENGTH:int = 16;

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
            var sections:Vector.<ByteArray> = new <ByteArray>[newBytes(), newBytes(), newBytes()];
            if (fits.structures != null && settings.structures != null)
            {
                writeStructures(fits.structures, sections[0]);
            }
            if (fits.tree != null && settings.hierarchy != null)
            {
                sections[1].writeBytes(fits.tree);
                if (fits.notes != null)
                {
                    fits.notes.writeTo(sections[2]);
                }
            }
            var length:int = HEAD_LENGTH + Fingerprint.LENGTH;
            for each (var section:ByteArray in sections)
            {
                length += roundedUp(section.length);
            }
            var out:ByteArray = newBytes();
            out.writeInt(MAGIC);
            out.writeInt(VERSION);
            out.writeInt(length);
            out.writeInt(0);
            geometry.writeTo(out);
            for (var i:int = 0; i < SECTIONS; i++)
            {
                var computedWith:Fingerprint = settings.ofSection(i) || new Fingerprint();
                computedWith.writeTo(out);
                out.writeInt(sections[i].length);
                out.writeInt(0);
            }
            for each (section in sections)
            {
                out.writeBytes(section);
                while (out.length % Fingerprint.LENGTH != 0)
                {
                    out.writeByte(0);
                }
            }
            seal(out);
            return out;
        }

        /** Writes the fingerprint of bytes, a multiple of 8, behind them; the position is their first then. */
        public static function seal(bytes:ByteArray):void
        {
            var whole:Fingerprint = new Fingerprint();
            bytes.position = 0;
            whole.addBytes(bytes, bytes.length / Fingerprint.LENGTH);
            whole.writeTo(bytes);
            bytes.position = 0;
        }

        /** No bytes, in the byte order that fits have. */
        public static function newBytes():ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.endian = ENDIAN;
            return bytes;
        }

        /** A length filled up to a multiple of 8. */
        public static function roundedUp(length:int):int
        {
            return length + 7 & ~7;
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
