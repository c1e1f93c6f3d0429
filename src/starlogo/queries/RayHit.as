package starlogo.queries
{
    /** The point where a ray first meets an agent, with the distance and the normal there. <code>AgentQueries.cast()</code> returns it. */
    public final class RayHit extends CastHit
    {
        /** The distance from the ray's origin to the point, in patches. It is 0 if the origin is inside the agent. */
        public var distance:Number = 0;

        /** An empty hit. Pass it to <code>AgentQueries.cast()</code>, which fills it. */
        public function RayHit()
        {
        }

        /** Its values, as text. */
        public function toString():String
        {
            return "ray hit of " + agent + " at " + point + ", normal " + normal + ", distance " + distance;
        }
    }
}
