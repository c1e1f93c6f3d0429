package starlogo.models
{
    /** Reads a model's file in small steps, so that a game may go on between them. */
    internal interface IModelReader
    {
        /**
         * Reads on for about a millisecond.
         *
         * @return whether there is more to read
         * @throws ModelError if the file is wrong
         */
        function step():Boolean;

        /** How much is read, from 0 to 1. */
        function get progress():Number;

        /** When all is read: x, y, z, ... as placed in the file, turned to z up. */
        function get vertices():Vector.<Number>;

        /** When all is read: three vertex indices per triangle; none if the file has no surfaces. */
        function get triangles():Vector.<uint>;
    }
}
