package starlogo.models
{
    /**
     * Has results that were computed from a model's vertices.
     *
     * @private
     */
    public interface PoseListener
    {
        /** Is called after each <code>Model.pose()</code>. The model's vertices are at their new places. Must not throw. */
        function onPose():void;
    }
}
