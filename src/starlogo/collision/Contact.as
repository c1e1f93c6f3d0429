package starlogo.collision
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * How two agents touch: when in their motions, where, and how deep. A handler that takes a third argument gets one; the next call
     * overwrites it, so keep the numbers, or clone the vectors.
     *
     * <p>For spheres, capsules and boxes it is exact. For hierarchies it is the contact of the first two nodes that touch, which are leaves or at
     * the depth limit, or, where triangles decide, of the first two triangles; for a model that is inside of another without touching it, the
     * contact of the structures around both. Where the collision system is no ContactSystem, it is half way between the agents, with a depth of
     * 0.</p>
     */
    public final class Contact
    {
        /**
         * When they first touched in their motions since the last frame: from 0, at the beginning, to 1, at the end. Also 1 where neither sweeps,
         * or neither has moved.
         */
        public var time:Number = 1;

        /** A point where they touch, in the world, in the middle of the overlap. */
        public var point:Vector3D = new Vector3D();

        /** The direction in which the collider has to move to get free: from the collidee to the collider, a unit vector. */
        public var normal:Vector3D = new Vector3D(0, 0, 1);

        /**
         * How far they overlap along the normal at that time, in patches: 0 where their motions first made them touch. Moved by as much
         * along the normal, the collider just touches the collidee, without overlapping it.
         */
        public var depth:Number = 0;

        /** At the origin, upright. */
        public function Contact()
        {
        }

        /**
         * Sets this to the contact of two agents: the collision system's own, or, if it is no ContactSystem, half way between the agents along the
         * line from one to the other.
         *
         * @private
         */
        engine function readFrom(system:CollisionSystem, collider:Agent, collidee:Agent):void
        {
            var contactSystem:ContactSystem = system as ContactSystem;
            if (contactSystem != null)
            {
                contactSystem.contactOf(collider, collidee, this);
                return;
            }
            var x:Number = collider.x - collidee.x;
            var y:Number = collider.y - collidee.y;
            var z:Number = collider.z - collidee.z;
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            normal.setTo(0, 0, 1);
            if (length > 0)
            {
                normal.setTo(x / length, y / length, z / length);
            }
            point.setTo(collidee.x + x / 2, collidee.y + y / 2, collidee.z + z / 2);
            time = 1;
            depth = 0;
        }
    }
}
