package starlogo.queries.motion
{
    import starlogo.agents.Agent;
    import starlogo.geometry.Placement;

    /**
     * Warns that an agent does not stop a motion, or pushes what moves out, because the motion begins deep inside of it. Such motions may come
     * in every frame. So in ActionScript this does nothing. The ES module has its own version, which warns once.
     *
     * @param agents by row: the agents that there are; null for a free row
     * @param row the row of the agent that the motion begins in
     * @param agent the agent that moves; null if a structure is cast
     * @param place where it begins
     * @param below how far its lowest point is below its place; 0 if it leans
     * @param depth how deep inside it is
     * @param isTree whether the agent collides as its tree or its triangles, which do not stop the motion
     * @private
     */
    public function warnOfInside(agents:Vector.<Agent>, row:int, agent:Agent, place:Placement, below:Number, depth:Number, isTree:Boolean):void
    {
    }
}
