package starlogo.models
{
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
        private static const VERTICES_PER_STEP:int = 4000;

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

        /** The axis that points up in the file; null if the file says it itself. */
        protected var upAxis:String;

        /**
         * @param name the model's name
         * @param budget what reading the file may cost
         * @param upAxis the axis that points up in the file; null if the file says it itself
         */
        public function ModelReader(name:String, budget:ModelBudget, upAxis:String = null)
        {
            this.budget = budget;
            this.name = name;
            this.upAxis = upAxis;
        }

        /** Does all steps. Returns the shape, turned and scaled. */
        internal final function readShape(scaling:String, transform:ModelTransform):NormalisedShape
        {
            finish(this);
            var shape:NormalisedShape = new NormalisedShape(name, vertices, triangles, scaling, transform, unit);
            finish(shape);
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
            var turn:AffineTransform = UpAxis.transform(upAxis);
            return new StepSequence().slices(upAxis == UpAxis.Z ? 0 : vertices.length / 3, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    turn.place(vertices, first, end, vertices, first);
                });
        }
    }
}
