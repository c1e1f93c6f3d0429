package evaluation.literal
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;

    /** The client's first collision system (§2.2) in one bin: compares the distance of two agents with their sizes. */
    public final class LiteralBinCollider
    {
        /** Whether two agents collide. */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            var distance:Number = Vector3D.distance(new Vector3D(a.x, a.y, a.z), new Vector3D(b.x, b.y, b.z));
            return distance <= (a.size + b.size) / 2;
        }
    }
}
