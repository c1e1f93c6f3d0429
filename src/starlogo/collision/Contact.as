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
     * <p>The depth separates, in every one of the engine's systems: moved by it and 1e-9 of the larger extent along the normal, the collider does not
     * touch the collidee any more, as that system sees them; by 1e-9 less it still does. Far away from the origin, where coordinates are
     * rounded more coarsely than that (from about a million times the extent on), it separates to the rounding of the coordinates.</p>
     *
     * <p>For spheres, capsules and boxes the normal is the shortest way out. For hierarchies and triangles it is a short one: where the two overlap by
     * less than 1/256 of the larger extent, the normal of the first two nodes or triangles that touch; else what is found from that, from the shortest
     * way out of the structures around both, and from the surfaces where these ways end. The way ends at the first place that is free, which
     * may be a hollow. This takes as long as 30 to 135 tests of whether the two touch. A collision system of a game's own that tells no
     * contacts has them half way between the agents, with a depth of 0.</p>
     */
    public final class Contact
    {
        /**
         * When they first touched in their motions since the last frame: from 0, at the beginning, to 1, at the end. Also 1 where neither sweeps,
         * or neither has moved.
         */
        public var time:Number = 1;

        /**
         * A point where they touch, in the world, in the middle of the overlap: for hierarchies, of the first two nodes or triangles that touch; for a
         * model that is inside of another without touching its surface, of the structures around both.
         */
        public var point:Vector3D = new Vector3D();

        /** The direction in which the collider has to move to get free: from the collidee to the collider, a unit vector. */
        public var normal:Vector3D = new Vector3D(0, 0, 1);

        /**
         * How far they overlap along the normal at that time, in patches: 0, but for rounding, where their motions first made them touch. Moved by
         * as much along the normal, the collider just touches the collidee, without overlapping it.
         */
        public var depth:Number = 0;

        /**
         * How fast the collider came to the collidee along the normal, in patches a frame, as their motions since the last frame say: not negative; 0 where
         * neither sweeps, and where they do not come nearer. For <code>moveUntilTouch()</code> it is how far the motion goes against the normal.
         */
        public var approachSpeed:Number = 0;

        /** At the origin, upright. */
        public function Contact()
        {
        }

        /** @private Half way between two agents, along the line from one to the other. */
        engine function setBetween(collider:Agent, collidee:Agent):void
        {
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
            depth = approachSpeed = 0;
        }
    }
}
