package starlogo.models
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.finish;

    /**
     * Reads a model's file; a step takes about a millisecond, and throws a ModelError if the file is wrong. Each format has one.
     *
     * @private
     */
    public class ModelReader extends StepSequence
    {
        /** When all is read: x, y, z, ... as placed in the file, turned to z up. */
        public var vertices:Vector.<Number> = new Vector.<Number>();

        /** When all is read: three vertex indices per triangle; none if the file has no surfaces. */
        public var triangles:Vector.<uint> = new Vector.<uint>();

        /** The model's name. */
        public var name:String;

        /**
         * @param name the model's name
         */
        public function ModelReader(name:String)
        {
            this.name = name;
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
    }
}
