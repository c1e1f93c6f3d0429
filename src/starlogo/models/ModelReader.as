package starlogo.models
{
    import starlogo.models.cooked.CookedFile;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    /**
     * Reads a model's file. Each format has a subclass. A step takes about a millisecond, and throws a ModelError if the file is wrong.
     *
     * @private
     */
    public class ModelReader extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 20000;

        /** When all is read: x, y, z, ... as placed in the file, turned to z up. */
        public var vertices:Vector.<Number> = new Vector.<Number>();

        /** When all is read: the length of the file's unit in patches, for Model.AS_GIVEN. */
        public var unit:Number = 1;

        /** When all is read: three vertex indices per triangle. Empty if the file has no surfaces. */
        public var triangles:Vector.<uint> = new Vector.<uint>();

        /** When all is read: the material of each triangle. */
        public var materials:TriangleRuns = new TriangleRuns();

        /** When all is read: the mesh of each triangle. */
        public var meshes:TriangleRuns = new TriangleRuns();

        /** The model's name. */
        public var name:String;

        /** The share that is read, from 0 to 1. */
        public var progress:Number = 0;

        // Points without a surface. They become the model's vertices if there are no others.
        private var _loosePoints:Vector.<Number> = new Vector.<Number>();

        // The axis that points up in the file: "x", "y" or "z". "z" with a transform, which leaves the file as it is.
        private var _upAxis:String;

        // null if there is none
        private var _transform:ModelTransform;

        // as for Model's constructor
        private var _scaling:String = null;

        // Of a cooked file: its results, and the model's place in its source if the vertices are in that place.
        private var _cooked:CookedFile = null;
        private var _frame:SourceFrame = null;

        private var _shape:NormalisedShape = null;

        /**
         * @param name the model's name
         * @param upAxis "x", "y", "z" or a ModelTransform
         * @throws ModelError if the up axis is none of these
         */
        public function ModelReader(name:String, upAxis:Object = "z")
        {
            this.name = name;
            _transform = upAxis as ModelTransform;
            _upAxis = _transform == null ? String(upAxis) : "z";
            refuseIf(_upAxis != "x" && _upAxis != "y" && _upAxis != "z", name,
                    "the up axis must be \"x\", \"y\" or \"z\", or a ModelTransform, not " + (upAxis is String ? "\"" + upAxis + "\"" : upAxis));
        }

        /** Adds the steps that turn and scale what is read, and returns the reader. @param scaling as for Model's constructor */
        public final function shaped(scaling:String):ModelReader
        {
            _scaling = scaling;
            begin(normalising).begin(labelling);
            return this;
        }

        /** When no step is left: the shape that <code>shaped()</code> asked for, for Model's constructor. */
        public final function get shape():Steps
        {
            _shape.cooked = _cooked;
            _shape.frame = _frame || _shape.frame;
            return _shape;
        }

        /** Does all steps. Returns the shape for Model's constructor. @param scaling as for Model's constructor */
        public final function readShape(scaling:String):Steps
        {
            finish(shaped(scaling));
            return shape;
        }

        /**
         * Takes what a cooked file says about its source, instead of what the caller has asked for.
         *
         * @param cooked the file
         * @param scaling as for Model's constructor
         * @param transform null if there is none
         * @param frame the model's place in its source; null if the vertices are the source's
         */
        protected final function takeCooked(cooked:CookedFile, scaling:String, transform:ModelTransform, frame:SourceFrame):void
        {
            _cooked = cooked;
            _scaling = scaling;
            _transform = transform;
            _frame = frame;
        }

        /** The list for a mesh's vertices: the model's vertices, or the points that have no surface. */
        protected final function verticesFor(hasSurface:Boolean):Vector.<Number>
        {
            return hasSurface ? vertices : _loosePoints;
        }

        /**
         * Takes the loose points if there are no vertices. Throws if there are no loose points either. @param expected for the error: what
         * the file must have
         */
        protected final function takeVertices(expected:String):void
        {
            vertices = vertices.length == 0 ? _loosePoints : vertices;
            refuseIf(vertices.length == 0, name, "no vertices: expected " + expected);
        }

        /** The steps that turn the vertices to z up. */
        protected final function turningUp():Steps
        {
            return _upAxis == "z" ? null : turnUp.placing(vertices);
        }

        /** The turn to z up, from the axis that the caller has named. */
        protected final function get turnUp():AffineTransform
        {
            return turnFrom(_upAxis);
        }

        /**
         * The turn to z up. If y is up, the file's -z becomes y. If x is up, -y becomes x and -z becomes y. (The COLLADA specification's
         * table for up_axis gives the right and inward axes.)
         */
        protected static function turnFrom(upAxis:String):AffineTransform
        {
            switch (upAxis)
            {
                case "x":
                    return new AffineTransform(new <Number>[0, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0]);
                case "y":
                    return new AffineTransform(new <Number>[1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0]);
                default:
                    return new AffineTransform();
            }
        }

        private function normalising():Steps
        {
            _shape = new NormalisedShape(name, vertices, triangles, _frame == null ? _scaling : Model.AS_GIVEN, _transform, unit);
            return _shape;
        }

        // Lists the material and the mesh of each triangle, if the file says any.
        private function labelling():Steps
        {
            var work:StepSequence = new StepSequence();
            _shape.materials = labelsOf(materials, work);
            _shape.meshes = labelsOf(meshes, work);
            return work;
        }

        private function labelsOf(runs:TriangleRuns, work:StepSequence):TriangleLabels
        {
            var count:int = triangles.length / 3;
            if (runs.isEmpty(count))
            {
                return null;
            }
            var numbers:Vector.<int> = new Vector.<int>(count);
            work.slices(count, TRIANGLES_PER_STEP, function(first:int, end:int):void
                {
                    runs.write(first, end, numbers);
                });
            if (_shape.isTurnedRound)
            {
                work.call(function():void
                    {
                        numbers.reverse();
                    });
            }
            return new TriangleLabels(numbers, runs.names);
        }
    }
}
