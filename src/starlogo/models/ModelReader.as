package starlogo.models
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    /**
     * Reads a model's file; a step takes about a millisecond, and throws a ModelError if the file is wrong. Each format has one.
     *
     * @private
     */
    public class ModelReader extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 4000;

        /** When all is read: x, y, z, ... as placed in the file, turned to z up. */
        public var vertices:Vector.<Number> = new Vector.<Number>();

        /** When all is read: three vertex indices per triangle; none if the file has no surfaces. */
        public var triangles:Vector.<uint> = new Vector.<uint>();

        /** The model's name. */
        public var name:String;

        /** Points without a surface. They are the model's vertices if there are no others. */
        protected var loosePoints:Vector.<Number> = new Vector.<Number>();

        /** The axis that points up in the file; null if the file says it. */
        protected var upAxis:String;

        /**
         * @param name the model's name
         * @param upAxis the axis that points up in the file; null if the file says it
         */
        public function ModelReader(name:String, upAxis:String = null)
        {
            this.name = name;
            this.upAxis = upAxis;
        }

        /** Does all steps; what is read, turned and scaled. */
        internal final function readShape(scaling:String, transform:ModelTransform):NormalisedShape
        {
            finish(this);
            var shape:NormalisedShape = new NormalisedShape(name, vertices, triangles, scaling, transform);
            finish(shape);
            return shape;
        }

        /** How much is read, from 0 to 1. */
        public function get progress():Number
        {
            return 0;
        }

        /** Takes the loose points if there are no vertices. @param expected what the file has to have, for the error if there are none either */
        protected final function takeVertices(expected:String):void
        {
            vertices = vertices.length == 0 ? loosePoints : vertices;
            refuseIf(vertices.length == 0, name, "no vertices: expected " + expected);
        }

        /** The work that turns the vertices to z up. */
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
