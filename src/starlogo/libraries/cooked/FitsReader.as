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
    import starlogo.libraries.FitSettings;
    import starlogo.libraries.ModelFits;
    import starlogo.solid.SurfaceNotes;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Reads what FitsWriter wrote, in steps, and believes nothing: bytes that are no fits of this geometry, that are cut off or
     * have changed, or that hold impossible numbers are no fits, and sections of other settings are left out. What a section
     * says of the model is checked by whoever uses it.
     */
    public final class FitsReader implements Steps
    {
        private static const WORDS_A_STEP:int = 4000;
        private static const LARGEST_LENGTH:int = 0x10000000;
        private static const KINDS:int = 7;

        private var _bytes:ByteArray;
        private var _geometry:Fingerprint;
        private var _settings:FitSettings;
        private var _triangleCount:int;
        private var _whole:Fingerprint = null;
        private var _wordsLeft:int;
        private var _fits:ModelFits = null;

        /**
         * @param bytes what may be fits; changed in nothing but position and byte order
         * @param geometry the model's
         * @param settings what is wanted
         * @param triangleCount how many triangles the model has
         */
        public function FitsReader(bytes:ByteArray, geometry:Fingerprint, settings:FitSettings, triangleCount:int)
        {
            _bytes = bytes;
            _geometry = geometry;
            _settings = settings;
            _triangleCount = triangleCount;
        }

        /** What was read, when no step is left; null if they are no fits of this model. */
        public function get fits():ModelFits
        {
            return _fits;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            if (_whole == null)
            {
                return beginsWell();
            }
            var words:int = Math.min(WORDS_A_STEP, _wordsLeft);
            _whole.addBytes(_bytes, words);
            _wordsLeft -= words;
            if (_wordsLeft == 0 && _whole.isNextOf(_bytes))
            {
                readSections();
            }
            return _wordsLeft > 0;
        }

        private function beginsWell():Boolean
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
            _whole = new Fingerprint();
            _wordsLeft = length / Fingerprint.LENGTH - 1;
            return true;
        }

        private function readSections():void
        {
            var bytes:ByteArray = _bytes;
            var begin:int = FitsWriter.HEAD_LENGTH;
            var end:int = bytes.length - Fingerprint.LENGTH;
            var sections:Vector.<ByteArray> = new Vector.<ByteArray>();
            for (var i:int = 0; i < 3; i++)
            {
                bytes.position = FitsWriter.HEAD_LENGTH - 16 * (3 - i);
                var wanted:Fingerprint = i == 0 ? _settings.structures : _settings.hierarchy;
                var isWanted:Boolean = wanted != null && wanted.isNextOf(bytes);
                bytes.position = FitsWriter.HEAD_LENGTH - 16 * (3 - i) + Fingerprint.LENGTH;
                var length:int = bytes.readInt();
                if (length < 0 || length > end - begin)
                {
                    return;
                }
                sections.push(isWanted && length > 0 ? sectionAt(begin, length) : null);
                begin += FitsWriter.roundedUp(length);
            }
            _fits = new ModelFits();
            _fits.structures = readStructures(sections[0]);
            _fits.tree = sections[1];
            _fits.notes = sections[2] == null ? null : SurfaceNotes.read(sections[2], _triangleCount);
        }

        private function sectionAt(begin:int, length:int):ByteArray
        {
            var section:ByteArray = new ByteArray();
            section.endian = FitsWriter.ENDIAN;
            section.writeBytes(_bytes, begin, length);
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
            var numbers:int = ((kinds & 1) != 0 ? 4 : 0) + ((kinds & 2) != 0 ? 7 : 0) + ((kinds & 4) != 0 ? 15 : 0);
            if (kinds <= 0 || kinds > KINDS || bytes.bytesAvailable != 8 * numbers)
            {
                return null;
            }
            var structures:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3, true);
            try
            {
                structures[BoundingStructure.SPHERE] = (kinds & 1) != 0 ? readSphere(bytes) : null;
                structures[BoundingStructure.CAPSULE] = (kinds & 2) != 0 ? readCapsule(bytes) : null;
                structures[BoundingStructure.BOX] = (kinds & 4) != 0 ? readBox(bytes) : null;
            }
            catch (error:Error)
            {
                // the constructors refuse what is no structure
                return null;
            }
            return structures;
        }

        private static function readSphere(bytes:ByteArray):Sphere
        {
            var center:Vector3D = readVector(bytes);
            return new Sphere(center, bytes.readDouble());
        }

        private static function readCapsule(bytes:ByteArray):Capsule
        {
            var start:Vector3D = readVector(bytes);
            var end:Vector3D = readVector(bytes);
            return new Capsule(start, end, bytes.readDouble());
        }

        // The constructor straightens the axes once more, which may change their last bits.
        private static function readBox(bytes:ByteArray):Box
        {
            var center:Vector3D = readVector(bytes);
            var axisX:Vector3D = readVector(bytes);
            var axisY:Vector3D = readVector(bytes);
            var axisZ:Vector3D = readVector(bytes);
            var halfX:Number = bytes.readDouble();
            var halfY:Number = bytes.readDouble();
            var box:Box = new Box(center, axisX, axisY, axisZ, halfX, halfY, bytes.readDouble());
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
            var x:Number = bytes.readDouble();
            var y:Number = bytes.readDouble();
            return new Vector3D(x, y, bytes.readDouble());
        }
    }
}
