package starlogo.models.cooked
{
    import flash.errors.EOFError;
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.data.Fingerprint;
    import starlogo.engine;
    import starlogo.models.Model;
    import starlogo.models.ModelError;
    import starlogo.models.ModelTransform;
    import starlogo.models.SourceFrame;
    import starlogo.models.building.ModelReader;
    import starlogo.models.building.TriangleLabels;
    import starlogo.models.files.FileBudget;
    import starlogo.models.files.refuseModelIf;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Reads the model of a cooked file. In most encodings the file has the vertices of the source, the transform and the scaling. These vertices
     * are normalised again, as for any source. With the encoding NORMALISED_DOUBLE it has the vertices of the model, and the model's place in its
     * source. In both cases the model equals the source's model to the last bit.
     *
     * @private
     */
    public final class CookedReader extends ModelReader
    {
        /** An encoding up to this one, from 0, is the number of decimals of the source's coordinates. */
        internal static const MOST_DECIMALS:int = 8;

        /** The encoding of the source's coordinates as floats of 32 bits. */
        internal static const SOURCE_FLOAT:int = 9;

        /** The encoding of the model's own coordinates as doubles of 64 bits. */
        internal static const NORMALISED_DOUBLE:int = 10;

        private static const VERTICES_PER_STEP:int = 1500;
        private static const CORNERS_PER_STEP:int = 4500;
        private static const LABELS_PER_STEP:int = 1500;

        private var _bytes:ByteArray;

        /**
         * @param name the model's name
         * @param bytes the bytes of a possible cooked file
         * @param modelKey the key that the model must have: see <code>CookedFile.MODEL</code>. Null for any
         */
        public function CookedReader(name:String, bytes:ByteArray, modelKey:Fingerprint = null)
        {
            super(name);
            var file:CookedFile = new CookedFile(bytes);
            add(file).begin(function():Steps
                {
                    return reading(file, modelKey);
                });
        }

        /** The divisor for the numbers of an encoding. */
        internal static function divisorOf(encoding:int):Number
        {
            return encoding <= MOST_DECIMALS ? Number("1e" + encoding) : 1;
        }

        /** @inheritDoc */
        override public function step():Boolean
        {
            var hasMore:Boolean = false;
            try
            {
                hasMore = super.step();
                progress = _bytes == null ? 0 : _bytes.position / _bytes.length;
            }
            catch (error:Error)
            {
                // the transform's own error, or that of the end of the bytes
                refuseModelIf(error is RangeError, data.name, error.message);
                refuseModelIf(error is EOFError, data.name, "the cooked file has fewer numbers than it says");
                throw error;
            }
            return hasMore;
        }

        // Reads the head. The work that it returns reads the numbers.
        private function reading(file:CookedFile, modelKey:Fingerprint):Steps
        {
            refuseModelIf(file.isOfOtherVersion, data.name, "the cooked file is of another version of the engine: cook it again");
            _bytes = file.section(CookedFile.MODEL, null);
            refuseModelIf(_bytes == null, data.name, "the cooked file is damaged: cook it again");
            refuseModelIf(modelKey != null && !file.hasKey(CookedFile.MODEL, modelKey), data.name, "the cooked file is for another up axis, transform or scaling");
            data.cooked = file;
            data.scaling = Model.SCALINGS[readInteger(0, Model.SCALINGS.length - 1)];
            var encoding:int = readInteger(0, NORMALISED_DOUBLE);
            // the model's own vertices are transformed already
            var hasTransform:Boolean = readInteger(0, encoding == NORMALISED_DOUBLE ? 0 : 1) == 1;
            var vertexCount:int = readInteger(0, int.MAX_VALUE);
            var triangleCount:int = readInteger(0, int.MAX_VALUE);
            new FileBudget(data.name, _bytes.length).checkMeshSize(vertexCount, triangleCount);
            data.transform = hasTransform ? new ModelTransform(readVector(), readVector(), readVector()) : null;
            if (encoding == NORMALISED_DOUBLE)
            {
                data.source = readSource();
                data.isInModelSpace = true;
                refuseModelIf(!data.source.isValid, data.name, "the cooked file does not have the model's place in its source");
            }
            // Each number takes at least one byte. A declared count is not trusted: memory is reserved only for data that is present.
            refuseModelIf(_bytes.bytesAvailable < 3 * (vertexCount + triangleCount), data.name, "the cooked file has fewer bytes than it says");
            data.vertices.length = 3 * vertexCount;
            data.triangles.length = 3 * triangleCount;
            return new StepSequence().slices(vertexCount, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    readNumbers(first, end, encoding);
                }).slices(3 * triangleCount, CORNERS_PER_STEP, readCorners).begin(function():Steps
                {
                    // a model without labels ends before them
                    return new StepSequence().beginEach(_bytes.bytesAvailable > 0 ? 2 : 0, readingLabels);
                });
        }

        // The steps that read the labels of the materials, or of the meshes: their names, and then the runs.
        private function readingLabels(index:int):Steps
        {
            var labels:TriangleLabels = index == 0 ? data.materials : data.meshes;
            var nameCount:int = VarInt.read(_bytes);
            var mostLabel:int = nameCount < 0 ? int.MAX_VALUE : nameCount - 1;
            var triangle:Number = 0;
            labels.names = nameCount < 0 ? null : new Vector.<String>();
            return new StepSequence().slices(Math.max(0, nameCount), LABELS_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        var length:int = VarInt.read(_bytes);
                        labels.addLabel(length < 0 ? null : _bytes.readUTFBytes(length));
                    }
                }).begin(function():Steps
                {
                    return new StepSequence().slices(readInteger(0, int.MAX_VALUE), LABELS_PER_STEP, function(first:int, end:int):void
                        {
                            for (var i:int = first; i < end; i++)
                            {
                                triangle = Math.min(triangle + readInteger(0, int.MAX_VALUE), data.triangles.length / 3);
                                labels.beginRun(readInteger(-1, mostLabel), triangle);
                            }
                        });
                });
        }

        private function readInteger(least:int, most:int):int
        {
            var integer:int = VarInt.read(_bytes);
            if (integer < least || integer > most)
            {
                throw new ModelError(data.name, "", "the cooked file has a wrong number: " + integer);
            }
            return integer;
        }

        private function readSource():SourceFrame
        {
            var numbers:Vector.<Number> = data.source.toNumbers();
            for (var i:int = 0; i < numbers.length; i++)
            {
                numbers[i] = _bytes.readDouble();
            }
            return SourceFrame.ofNumbers(numbers);
        }

        private function readVector():Vector3D
        {
            return new Vector3D(_bytes.readDouble(), _bytes.readDouble(), _bytes.readDouble());
        }

        private function readNumbers(first:int, end:int, encoding:int):void
        {
            var all:Vector.<Number> = data.vertices;
            var divisor:Number = divisorOf(encoding);
            for (var i:int = 3 * first; i < 3 * end; i++)
            {
                if (encoding <= MOST_DECIMALS)
                {
                    // each number is stored as the difference from the one of the vertex before, in multiples of 1 / divisor
                    var multiple:int = i < 3 ? 0 : Math.round(all[int(i - 3)] * divisor);
                    multiple += VarInt.read(_bytes);
                    all[i] = multiple / divisor;
                }
                else
                {
                    all[i] = encoding == NORMALISED_DOUBLE ? _bytes.readDouble() : _bytes.readFloat();
                }
            }
        }

        // The ModelBuilder checks whether the vertices exist.
        private function readCorners(first:int, end:int):void
        {
            var triangles:Vector.<uint> = data.triangles;
            var index:int = first == 0 ? 0 : triangles[int(first - 1)];
            for (var i:int = first; i < end; i++)
            {
                index += VarInt.read(_bytes);
                triangles[i] = index;
            }
        }
    }
}
