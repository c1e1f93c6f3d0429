package starlogo.models.building
{
    import starlogo.models.ModelTransform;
    import starlogo.steps.StepSequence;

    /**
     * The work that reads a file, or another source, into a ModelData. Each format has a subclass, which adds its steps in the constructor.
     *
     * @private
     */
    public class ModelReader extends StepSequence
    {
        /** What is read, complete when no step is left. Read only. */
        public var data:ModelData;

        /** The share that is read so far, from 0 to 1. The subclass sets it, and never makes it less. */
        public var progress:Number = 0;

        /**
         * @param name the model's name
         * @param upAxis "x", "y", "z" or a ModelTransform; null for formatAxis
         * @param scaling as for Model's constructor; null if the vertices are not normalised, or the file says it
         * @param formatAxis the axis that points up by the rules of the format; null if it has no such rule
         * @throws ModelError if the up axis is none of these
         */
        public function ModelReader(name:String, upAxis:Object = "z", scaling:String = null, formatAxis:String = null)
        {
            upAxis = upAxis == null ? formatAxis : upAxis;
            ModelData.requireUpAxis(name, upAxis);
            data = new ModelData(name);
            data.scaling = scaling;
            data.transform = upAxis as ModelTransform;
            data.upAxis = data.transform == null ? String(upAxis) : "z";
        }

        /** The work that makes the model: this work comes first. Call it once. */
        public function building():ModelBuilder
        {
            return new ModelBuilder(data, this);
        }
    }
}
