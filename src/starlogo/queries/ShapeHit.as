package starlogo.queries
{
    /**
     * The place where a cast first touches an agent. A cast moves a structure or an agent along a straight way.
     * <code>AgentQueries.castShape()</code> returns a ShapeHit. Its normal points from the agent to what is cast.
     */
    public final class ShapeHit extends CastHit
    {
        /** The free part of the way, from 0 to 1. It is 0 if the two touch at the beginning and the way goes into the agent. */
        public var time:Number = 0;

        /** An empty hit. Pass it to <code>AgentQueries.castShape()</code>, which fills it. */
        public function ShapeHit()
        {
        }

        /** Its values, as text. */
        public function toString():String
        {
            return "hit of " + agent + " at " + point + ", normal " + normal + ", time " + time;
        }
    }
}
