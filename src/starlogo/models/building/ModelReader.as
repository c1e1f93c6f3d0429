package starlogo.models.building
{
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

        /** @param data takes what is read */
        public function ModelReader(data:ModelData)
        {
            this.data = data;
        }

        /** The work that makes the model: this work comes first. Call it once. */
        public function building():ModelBuilder
        {
            return new ModelBuilder(data, this);
        }
    }
}
