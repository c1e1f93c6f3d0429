package starlogo.models.building
{
    /**
     * An animation of a model's file.
     *
     * @private
     */
    public interface FileAnimation
    {
        /** Its name; "" if it has none. */
        function get name():String;

        /** Its length, in seconds. 0 without keys. */
        function get duration():Number;

        /** The vertices of the file's model at a time in seconds, as <code>ModelAnimations.verticesAt()</code> gives them. */
        function verticesAt(time:Number):Vector.<Number>;
    }
}
