package starlogo.collision
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.convex.ContactPoint;
    import starlogo.engine;

    use namespace engine;

    /**
     * Tells when, where and how deep two agents touch. A handler with a third argument gets a Contact. The next call overwrites it, so keep the
     * numbers, or clone the vectors.
     *
     * <p>The depth separates the two, in each of the engine's systems. Move the collider along the normal by the depth and 1e-9 of the
     * larger extent more, and the two no longer touch, as that system sees them. Move it by 1e-9 less, and they still do. If the origin is
     * farther away than about a million times the extent, the rounding of the coordinates is coarser than that, and takes the place of
     * 1e-9.</p>
     *
     * <p>For spheres, capsules, boxes and hulls the normal is the shortest way out. For hierarchies and triangles it is a short way. If they
     * overlap by less than 1/256 of the larger extent, it is the normal of the first two nodes or triangles that touch. If several triangles
     * touch at the same time, it is the normal of the one that the motion meets most squarely. Otherwise the engine improves this normal: it
     * also tries the shortest way out of the structures around both, and the surfaces at the ends of these ways. The way ends at the first
     * free place, which may be a hollow. This takes the time of 30 to 135 tests of whether the two touch.</p>
     *
     * <p>Two hierarchies may have several ways out that are about as short. Which one is found depends on which of the two is first in the list of
     * the last search, because that one is tested against the other. Agents that are not in the list come after it, the older ones first. It does not
     * depend on which of the two is the collider, nor on earlier searches.</p>
     *
     * <p>If a collision system of your own computes no contacts, the point is half way between the agents, and the depth is 0.</p>
     */
    public final class Contact
    {
        /**
         * The time of the first touch in their motions since the last frame: 0 is the beginning, 1 is the end. It is also 1 if neither agent sweeps
         * or neither has moved.
         */
        public var time:Number = 1;

        /**
         * The point where they touch, in the world: the middle of the overlap along the normal. If one of the two is thinner there than the depth,
         * the point may be beside that one. For hierarchies it is the overlap of the first two nodes or triangles that touch. For a model inside
         * another that does not touch its surface, it is the overlap of the structures around both.
         */
        public var point:Vector3D = new Vector3D();

        /** The direction in which the collider has to move to get free, from the collidee to the collider: a unit vector. */
        public var normal:Vector3D = new Vector3D(0, 0, 1);

        /**
         * The length of their overlap along the normal at that time, in patches. If their motions first made them touch, it is 0, except for
         * rounding. Moved by the depth along the normal, the collider just touches the collidee.
         */
        public var depth:Number = 0;

        /**
         * How fast the collider came to the collidee along the normal, in patches a frame. It is computed from their motions since the last
         * frame, and is not negative. It is 0 if neither sweeps, or if they do not come nearer. For <code>moveUntilTouch()</code> it is how
         * far the motion goes against the normal.
         */
        public var approachSpeed:Number = 0;

        /** Its values, as text. */
        public function toString():String
        {
            return "contact at " + point + ", normal " + normal + ", depth " + depth + ", time " + time;
        }

        /** @private Takes the point, the normal and the depth of a contact. */
        engine function setFromPoint(from:ContactPoint):void
        {
            point.setTo(from.x, from.y, from.z);
            normal.setTo(from.normalX, from.normalY, from.normalZ);
            depth = from.depth;
        }

        /** @private Takes the values of another contact. */
        engine function copyFrom(other:Contact):void
        {
            time = other.time;
            point.copyFrom(other.point);
            normal.copyFrom(other.normal);
            depth = other.depth;
            approachSpeed = other.approachSpeed;
        }

        /** @private Sets a contact half way between two agents, along the line from one to the other. */
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
