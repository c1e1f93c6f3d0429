package starlogo.models.building
{
    import starlogo.steps.Steps;

    /**
     * Reads what a model is made of, in steps: a reader for each format of files. A ModelBuilder makes the model of it.
     *
     * @private
     */
    public interface FormatReader extends Steps
    {
        /** What is read. It is complete when no step is left. */
        function get data():ModelData;
    }
}
