package starlogo.models.cooked
{
    import flash.errors.EOFError;
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.models.Model;
    import starlogo.models.ModelLimits;
    import starlogo.models.ModelReader;
    import starlogo.models.ModelTransform;
    import starlogo.models.SourceFrame;
    import starlogo.models.refuseIf;

    use namespace engine;

    /**
     * Reads the model of a cooked file: the vertices and triangles that its source had, and how they were turned and scaled; that is done anew, as
     * for any source, so that a model is never other than normalised, and bit for bit what the source gives.
     *
     * @private
     */
    public final class CookedReader extends ModelReader
    {
        private static const VERTICES_PER_STEP:int = 1500;
        private static const CORNERS_PER_STEP:int = 4500;

        /** How it was scaled, when all is read. */
        public var scaling:String = null;

        /** What turned it, when all is read; null for nothing. */
        public var transform:ModelTransform = null;

        /** Where it was in its source, when all is read; null if that follows from the vertices, which are to be scaled then. */
        public var frame:SourceFrame = null;

        private var _file:CookedFile;
        private var _bytes:ByteArray;
        private var _form:int;
        private var _divisor:Number = 1;
        private var _x:int = 0;
        private var _y:int = 0;
        private var _z:int = 0;
        private var _index:int = 0;

        /**
         * @param name the model's name
         * @param file all steps of which are done
         */
        public function CookedReader(name:String, file:CookedFile)
        {
            super(name);
            _file = file;
            call(readHead);
        }

        /** @inheritDoc */
        override public function step():Boolean
        {
            try
            {
                return super.step();
            }
            catch (error:EOFError)
            {
                refuseIf(true, name, "the cooked file has fewer numbers than it says");
            }
            return false;
        }

        private function readHead():void
        {
            _bytes = _file.section(CookedFile.MODEL, null);
            refuseIf(_bytes == null, name, "the cooked file is damaged, or of another version: cook it again");
            scaling = Model.SCALINGS[readCount(Model.SCALINGS.length - 1)];
            _form = readCount(CookedShape.DOUBLE);
            _divisor = CookedShape.divisorOf(_form);
            var hasTransform:Boolean = readCount(1) == 1;
            var vertexCount:int = readCount(ModelLimits.VERTICES);
            var triangleCount:int = readCount(ModelLimits.TRIANGLES);
            if (hasTransform)
            {
                transform = readTransform();
            }
            if (_form == CookedShape.DOUBLE)
            {
                frame = SourceFrame.read(_bytes, scaling);
                refuseIf(frame == null, name, "the cooked file says no place in its source");
            }
            refuseIf(vertexCount == 0, name, "the cooked file has no vertices");
            // a byte each at least: what is said to be there is not made room for otherwise
            refuseIf(_bytes.bytesAvailable < 3 * (vertexCount + triangleCount), name, "the cooked file has fewer bytes than it says");
            vertices.length = 3 * vertexCount;
            triangles.length = 3 * triangleCount;
            slices(vertexCount, VERTICES_PER_STEP, _form < CookedShape.SINGLE ? readMultiples : readNumbers).slices(3 * triangleCount, CORNERS_PER_STEP, readCorners);
        }

        private function readCount(most:int):int
        {
            var count:int = CookedNumbers.read(_bytes);
            refuseIf(count < 0 || count > most, name, "the cooked file has a wrong number: " + count);
            return count;
        }

        private function readTransform():ModelTransform
        {
            try
            {
                return new ModelTransform(CookedNumbers.readVector(_bytes), CookedNumbers.readVector(_bytes), CookedNumbers.readVector(_bytes));
            }
            catch (error:RangeError)
            {
                refuseIf(true, name, error.message);
            }
            return null;
        }

        // each as its difference from the one before
        private function readMultiples(first:int, end:int):void
        {
            var bytes:ByteArray = _bytes;
            var all:Vector.<Number> = vertices;
            var divisor:Number = _divisor;
            var x:int = _x;
            var y:int = _y;
            var z:int = _z;
            var last:int = 3 * end;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                x += CookedNumbers.read(bytes);
                y += CookedNumbers.read(bytes);
                z += CookedNumbers.read(bytes);
                all[i] = x / divisor;
                all[int(i + 1)] = y / divisor;
                all[int(i + 2)] = z / divisor;
            }
            _x = x;
            _y = y;
            _z = z;
        }

        private function readNumbers(first:int, end:int):void
        {
            var isDouble:Boolean = _form == CookedShape.DOUBLE;
            for (var i:int = 3 * first; i < 3 * end; i++)
            {
                vertices[i] = isDouble ? _bytes.readDouble() : _bytes.readFloat();
            }
        }

        // The shape that is made of them checks whether there are such vertices.
        private function readCorners(first:int, end:int):void
        {
            var bytes:ByteArray = _bytes;
            var all:Vector.<uint> = triangles;
            var index:int = _index;
            for (var i:int = first; i < end; i++)
            {
                var byte:int = bytes.readUnsignedByte();
                // nearly all have but one, and a call is what takes longest
                if (byte > 0x7F)
                {
                    index += CookedNumbers.rest(bytes, byte);
                }
                else
                {
                    index += byte >>> 1 ^ -(byte & 1);
                }
                all[i] = index;
            }
            _index = index;
        }
    }
}
