package starlogo.agents
{
    import starlogo.geometry.Placement;

    /**
     * Warns that an agent does not stop a motion, because the motion begins deep inside of it. Such motions may come in every frame. So in
     * ActionScript this does nothing. The ES module has its own version, which warns once.
     *
     * @param agents the agents that there are; null for a free row
     * @param index the index of the agent that does not stop the motion; it collides as its tree or its triangles
     * @param shape the name of the shape that moves
     * @param place where it begins
     * @param below how far its lowest point is below its place; 0 if it leans
     * @param depth how deep inside it is
     * @private
     */
    public function warnOfInside(agents:Vector.<Agent>, index:int, shape:String, place:Placement, below:Number, depth:Number):void
    {
    }
}
