package starlogo.models.animation
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

        /**
         * The numbers of a target at a time: a thing in the file that an animation may move. Null if it does not move.
         *
         * @param target names the thing, as the class that reads the format's animations says
         * @param time seconds in the animation's own time, which need not begin at 0
         */
        function numbersAt(target:Object, time:Number):Vector.<Number>;

        /** The vertices of the file's model at a time in seconds, as <code>ModelAnimations.verticesAt()</code> gives them. */
        function verticesAt(time:Number):Vector.<Number>;
    }
}
