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
        /** When all is read: x, y, z, ... as placed in the file, turned to z up. */
        public var vertices:Vector.<Number> = new Vector.<Number>();

        /** When all is read: the length of the file's unit in patches, for Model.AS_GIVEN. */
        public var unit:Number = 1;

        /** When all is read: three vertex indices per triangle. Empty if the file has no surfaces. */
        public var triangles:Vector.<uint> = new Vector.<uint>();

        /** The model's name. */
        public var name:String;

        /** Points without a surface. They become the model's vertices if there are no others. */
        protected var loosePoints:Vector.<Number> = new Vector.<Number>();

        /** What reading the file may cost. */
        protected var budget:ModelBudget;

        /** The axis that points up in the file, or the model's transform; null if the vertices come with z up. */
        protected var up:UpAxis;

        /** How the model is scaled, as for Model's constructor. */
        protected var scaling:String = null;

        /** When all is read: the file's cooked results and the model's place in its source, of a file that has them. */
        protected var cooked:CookedFile = null;
        protected var frame:SourceFrame = null;

        private var _shape:NormalisedShape = null;

        /**
         * @param name the model's name
         * @param budget what reading the file may cost
         * @param up the axis that points up in the file; null if the vertices come with z up
         */
        public function ModelReader(name:String, budget:ModelBudget, up:UpAxis = null)
        {
            this.budget = budget;
            this.name = name;
            this.up = up;
        }

        /** Adds the steps that turn and scale what is read, and returns the reader. @param scaling as for Model's constructor */
        public final function shaped(scaling:String):ModelReader
        {
            this.scaling = scaling;
            begin(normalising);
            return this;
        }

        /** When no step is left: the shape that <code>shaped()</code> asked for, for Model's constructor. */
        public final function get shape():Steps
        {
            _shape.cooked = cooked;
            _shape.frame = frame || _shape.frame;
            return _shape;
        }

        /** Does all steps. Returns the shape for Model's constructor. @param scaling as for Model's constructor */
        public final function readShape(scaling:String):Steps
        {
            finish(shaped(scaling));
            return shape;
        }

        /** The share that is read, from 0 to 1. */
        public function get progress():Number
        {
            return 0;
        }

        /**
         * Takes the loose points if there are no vertices. Throws if there are no loose points either. @param expected for the error: what
         * the file must have
         */
        protected final function takeVertices(expected:String):void
        {
            vertices = vertices.length == 0 ? loosePoints : vertices;
            refuseIf(vertices.length == 0, name, "no vertices: expected " + expected);
        }

        /** The steps that turn the vertices to z up. */
        protected final function turningUp():Steps
        {
            return up.axis == UpAxis.Z ? null : up.turn.placing(vertices);
        }

        private function normalising():Steps
        {
            _shape = new NormalisedShape(name, vertices, triangles, frame == null ? scaling : Model.AS_GIVEN, up == null ? null : up.transform,
                    unit);
            return _shape;
        }
    }
}
