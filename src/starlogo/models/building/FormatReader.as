package starlogo.models.building
{
    import starlogo.steps.StepSequence;

    /**
     * Reads what a model is made of, in steps: a reader for each format of files. A ModelBuilder makes the model of it.
     *
     * @private
     */
    public class FormatReader extends StepSequence
    {
        /** What is read. The reader makes it at once, and it is complete when no step is left. Read only. */
        public var data:ModelData;
    }
}
