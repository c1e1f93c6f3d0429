package starlogo.libraries.cooked
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Fingerprint;
    import starlogo.geometry.Tolerances;
    import starlogo.solid.SurfaceNotes;
    import starlogo.libraries.FitSettings;
    import starlogo.libraries.ModelFits;
    import starlogo.models.Model;
    import starlogo.steps.Slices;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Reads what FitsWriter wrote, in steps, and believes nothing: bytes that are no fits of this geometry, that are cut off or
     * have changed, or that hold impossible numbers are no fits, and sections of other settings are left out. Whether what a section
     * says is true of the model is checked where it is used.
     *
     * @private
     */
    public final class FitsReader implements Steps
    {
        private static const WORDS_PER_STEP:int = 4000;
        private static const LARGEST_LENGTH:int = 0x10000000;
        private static const KINDS:int = 7;

        private var _bytes:ByteArray;
        private var _model:Model;
        private var _geometry:Fingerprint;
        private var _settings:FitSettings;
        private var _fits:ModelFits;
        private var _whole:Fingerprint = new Fingerprint();
        private var _work:StepSequence = new StepSequence();
        private var _areFits:Boolean = false;

        /**
         * @param bytes what may be fits; changed in nothing but position and byte order
         * @param model the model
         * @param geometry its fingerprint
         * @param settings what is wanted
         * @param fits gets what is read; what it has already stays
         */
        public function FitsReader(bytes:ByteArray, model:Model, geometry:Fingerprint, settings:FitSettings, fits:ModelFits)
        {
            _bytes = bytes;
            _model = model;
            _geometry = geometry;
            _settings = settings;
            _fits = fits;
            if (hasHead())
            {
                _work.add(new Slices(bytes.length / Fingerprint.LENGTH - 1, WORDS_PER_STEP, addWords)).call(readSections);
            }
        }

        /** Whether the bytes were fits of this model, when no step is left. */
        public function get areFits():Boolean
        {
            return _areFits;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            return _work.step();
        }

        private function hasHead():Boolean
        {
            var bytes:ByteArray = _bytes;
            var length:int = bytes.length;
            if (length < FitsWriter.HEAD_LENGTH + Fingerprint.LENGTH || length > LARGEST_LENGTH || length % Fingerprint.LENGTH != 0)
            {
                return false;
            }
            bytes.endian = FitsWriter.ENDIAN;
            bytes.position = 0;
            if (bytes.readInt() != FitsWriter.MAGIC || bytes.readInt() != FitsWriter.VERSION || bytes.readInt() != length
                    || bytes.readInt() != 0 || !_geometry.isNextOf(bytes))
            {
                return false;
            }
            bytes.position = 0;
            return true;
        }

        private function addWords(first:int, end:int):void
        {
            _whole.addBytes(_bytes, end - first);
        }

        private function readSections():void
        {
            if (!_whole.isNextOf(_bytes))
            {
                return;
            }
            var sections:Vector.<ByteArray> = new Vector.<ByteArray>();
            var start:int = FitsWriter.HEAD_LENGTH;
            var end:int = _bytes.length - Fingerprint.LENGTH;
            for (var i:int = 0; i < FitsWriter.SECTIONS; i++)
            {
                _bytes.position = FitsWriter.HEAD_LENGTH - FitsWriter.ENTRY_LENGTH * (FitsWriter.SECTIONS - i);
                var wanted:Fingerprint = _settings.ofSection(i) || new Fingerprint();
                var isWanted:Boolean = wanted.isNextOf(_bytes) && _settings.ofSection(i) != null;
                var length:int = _bytes.readInt();
                if (length < 0 || length > end - start)
                {
                    return;
                }
                sections.push(isWanted && length > 0 ? sectionAt(start, length) : null);
                start += FitsWriter.roundedUp(length);
            }
            _areFits = true;
            addToFits(readStructures(sections[0]), sections[1], sections[2]);
        }

        private function addToFits(structures:Vector.<BoundingStructure>, tree:ByteArray, surface:ByteArray):void
        {
            var triangleCount:int = _model.triangles == null ? 0 : _model.triangles.length / 3;
            var notes:SurfaceNotes = surface == null ? null : SurfaceNotes.read(surface, triangleCount);
            _fits.structures ||= structures;
            if (_fits.tree == null || _fits.notes == null && notes != null)
            {
                _fits.tree = tree;
                _fits.notes = notes;
            }
        }

        private function sectionAt(start:int, length:int):ByteArray
        {
            var section:ByteArray = FitsWriter.newBytes();
            section.writeBytes(_bytes, start, length);
            section.position = 0;
            return section;
        }

        private static function readStructures(bytes:ByteArray):Vector.<BoundingStructure>
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
            try
            {
                var sphere:Sphere = hasSphere ? new Sphere(readVector(bytes), bytes.readDouble()) : null;
                var capsule:Capsule = hasCapsule ? new Capsule(readVector(bytes), readVector(bytes), bytes.readDouble()) : null;
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
            var center:Vector3D = readVector(bytes);
            var axisX:Vector3D = readVector(bytes);
            var axisY:Vector3D = readVector(bytes);
            var axisZ:Vector3D = readVector(bytes);
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

        private static function readVector(bytes:ByteArray):Vector3D
        {
            return new Vector3D(bytes.readDouble(), bytes.readDouble(), bytes.readDouble());
        }
    }
}
