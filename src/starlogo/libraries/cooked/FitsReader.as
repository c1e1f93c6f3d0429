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
     * Reads what FitsWriter wrote. Sections of other settings, or that hold impossible numbers, are left out. Whether the geometry is that of the
     * model is not checked: the file's seal stands for it.
     *
     * @private
     */
    public final class FitsReader
    {
        private static const KINDS:int = 7;

        // The numbers of a structure are at most the coordinates of the model times this, or 1.
        private static const LARGEST_FACTOR:Number = 10;

        /** All is static. */
        public function FitsReader()
        {
        }

        /**
         * Reads what is for some settings.
         *
         * @param file all steps of which are done
         * @param model the model
         * @param settings what is wanted
         * @param fits gets what is read; what it has already stays
         */
        public static function read(file:CookedFile, model:Model, settings:FitSettings, fits:ModelFits):void
        {
            var bounds:VertexBounds = new VertexBounds();
            bounds.add(model.vertices, 0, model.vertices.length / 3);
            if (bounds.largest > VertexBounds.LARGEST_COORDINATE)
            {
                // no fitter takes such a model, so this is no true record
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
                // the constructors refuse what is no structure
            }
            return null;
        }

        // The constructor straightens the axes once more, which may change their last bits.
        private static function readBox(bytes:ByteArray):Box
        {
            var center:Vector3D = CookedNumbers.readVector(bytes);
            var axisX:Vector3D = CookedNumbers.readVector(bytes);
            var axisY:Vector3D = CookedNumbers.readVector(bytes);
            var axisZ:Vector3D = CookedNumbers.readVector(bytes);
            var box:Box = new Box(center, axisX, axisY, axisZ, bytes.readDouble(), bytes.readDouble(), bytes.readDouble());
            if (areApart(box.axisX, axisX) || areApart(box.axisY, axisY) || areApart(box.axisZ, axisZ))
            {
                throw new ArgumentError("axes that were written are straight: " + [axisX, axisY, axisZ]);
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
