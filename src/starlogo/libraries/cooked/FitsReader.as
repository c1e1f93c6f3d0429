package starlogo.libraries.cooked
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.VertexBounds;
    import starlogo.libraries.FitSettings;
    import starlogo.libraries.ModelFits;
    import starlogo.models.Model;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.CookedNumbers;
    import starlogo.solid.Surface;

    use namespace engine;

    /**
     * Reads fits that FitsWriter wrote. It ignores sections of other settings and sections with impossible numbers. It does not check
     * whether the geometry is the model's, because the file's checksum guarantees that.
     *
     * @private
     */
    public final class FitsReader
    {
        private static const KINDS:int = 7;

        // A structure's numbers are at most this factor times the model's largest coordinate. Numbers up to 1 are always allowed.
        private static const LARGEST_FACTOR:Number = 10;

        /**
         * Reads the fits for certain settings.
         *
         * @param file all its steps must be done
         * @param model the model
         * @param settings the settings of the wanted fits
         * @param fits takes the results; it keeps what it already has
         */
        public static function read(file:CookedFile, model:Model, settings:FitSettings, fits:ModelFits):void
        {
            var bounds:VertexBounds = new VertexBounds();
            bounds.add(model.vertices, 0, model.vertices.length / 3);
            if (bounds.largest > VertexBounds.LARGEST_COORDINATE)
            {
                // no fitter accepts such a model, so the record is wrong
                return;
            }
            var triangleCount:int = model.triangles == null ? 0 : model.triangles.length / 3;
            var structures:ByteArray = settings.structures == null ? null : file.section(CookedFile.STRUCTURES, settings.structures);
            fits.structures ||= readStructures(structures, Math.max(1, LARGEST_FACTOR * bounds.largest));
            if (settings.hierarchy == null)
            {
                return;
            }
            var surface:ByteArray = file.section(CookedFile.SURFACE, settings.hierarchy);
            var read:Surface = surface == null ? null : Surface.read(surface, triangleCount);
            if (fits.tree == null || fits.surface == null && read != null)
            {
                fits.tree = file.section(CookedFile.HIERARCHY, settings.hierarchy);
                fits.surface = read;
            }
        }

        private static function readStructures(bytes:ByteArray, limit:Number):Vector.<BoundingStructure>
        {
            if (bytes == null || bytes.length < 4)
            {
                return null;
            }
            var kinds:int = bytes.readInt();
            var hasSphere:Boolean = (kinds & 1) != 0;
            var hasCapsule:Boolean = (kinds & 2) != 0;
            var hasBox:Boolean = (kinds & 4) != 0;
            var numbers:int = (hasSphere ? 4 : 0) + (hasCapsule ? 7 : 0) + (hasBox ? 15 : 0);
            if (kinds <= 0 || kinds > KINDS || bytes.bytesAvailable != 8 * numbers)
            {
                return null;
            }
            for (var i:int = 0; i < numbers; i++)
            {
                if (!(Math.abs(bytes.readDouble()) <= limit))
                {
                    return null;
                }
            }
            bytes.position = 4;
            try
            {
                var sphere:Sphere = hasSphere ? new Sphere(CookedNumbers.readVector(bytes), bytes.readDouble()) : null;
                var capsule:Capsule = hasCapsule ? new Capsule(CookedNumbers.readVector(bytes), CookedNumbers.readVector(bytes), bytes.readDouble()) : null;
                return new <BoundingStructure>[sphere, capsule, hasBox ? readBox(bytes) : null];
            }
            catch (error:Error)
            {
                // the constructors refuse numbers that make no structure
            }
            return null;
        }

        // The constructor orthonormalises the axes again, which may change their last bits. So they are set as they were written.
        private static function readBox(bytes:ByteArray):Box
        {
            var center:Vector3D = CookedNumbers.readVector(bytes);
            var axisX:Vector3D = CookedNumbers.readVector(bytes);
            var axisY:Vector3D = CookedNumbers.readVector(bytes);
            var axisZ:Vector3D = CookedNumbers.readVector(bytes);
            var box:Box = new Box(center, axisX, axisY, axisZ, bytes.readDouble(), bytes.readDouble(), bytes.readDouble());
            if (areApart(box.axisX, axisX) || areApart(box.axisY, axisY) || areApart(box.axisZ, axisZ))
            {
                throw new ArgumentError("the axes of a written box are orthonormal, not " + [axisX, axisY, axisZ]);
            }
            box.axisX = axisX;
            box.axisY = axisY;
            box.axisZ = axisZ;
            return box;
        }

        private static function areApart(a:Vector3D, b:Vector3D):Boolean
        {
            return !(Vector3D.distance(a, b) <= 100 * Tolerances.ROUNDING);
        }
    }
}
