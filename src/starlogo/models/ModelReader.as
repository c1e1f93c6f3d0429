package starlogo.models
{
    import starlogo.steps.Steps;

    /** Reads a model's file; a step takes about a millisecond, and throws a ModelError if the file is wrong. */
    internal interface ModelReader extends Steps
    {
        /** How much is read, from 0 to 1. */
        function get progress():Number;

        /** When all is read: x, y, z, ... as placed in the file, turned to z up. */
        function get vertices():Vector.<Number>;

        /** When all is read: three vertex indices per triangle; none if the file has no surfaces. */
        function get triangles():Vector.<uint>;
    }
}
