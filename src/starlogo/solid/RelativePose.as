package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Touching;

    use namespace engine;

    /**
     * The pose of model b in the space of model a. It is computed once for each pair of agents, because all nodes of their hierarchies share it.
     *
     * @private
     */
    public final class RelativePose
    {
        /** Transforms b into a's space. */
        public var placement:Placement = new Placement();

        /** The largest distance at which the two models still touch, in a's space: the rounding error of their places. */
        public var margin:Number = 0;

        // For each kind, a structure of b in a's space.
        private var _placed:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(BoundingStructure.KIND_COUNT, true);

        /**
         * Computes b's origin and axes in a's space.
         *
         * @param a the placement of a in the world
         * @param b the placement of b in the world
         * @param motion has brought a from its placement to another place: RelativeMotion.NONE if it stands
         * @param time of the motion
         */
        public function setBetween(a:Placement, b:Placement, motion:RelativeMotion, time:Number):void
        {
            var relative:Placement = placement;
            var aX:Number = a.x + (motion.startX + time * motion.x);
            var aY:Number = a.y + (motion.startY + time * motion.y);
            var aZ:Number = a.z + (motion.startZ + time * motion.z);
            var x:Number = (b.x - aX) / a.size;
            var y:Number = (b.y - aY) / a.size;
            var z:Number = (b.z - aZ) / a.size;
            margin = (Touching.marginOfPlace(aX, aY, aZ) + Touching.marginOfPlace(b.x, b.y, b.z)) / a.size;
            relative.size = b.size / a.size;
            relative.x = a.r00 * x + a.r10 * y + a.r20 * z;
            relative.y = a.r01 * x + a.r11 * y + a.r21 * z;
            relative.z = a.r02 * x + a.r12 * y + a.r22 * z;
            Placement.setRelativeRotation(a, b, relative);
        }

        /**
         * Computes the motion of b in a's space.
         *
         * @param a the placement of a in the world
         * @param worldMotion the motion of a relative to b, in the world
         * @param out receives the motion, from b's pose on, but no time: its start must be 0
         */
        public static function writeMotion(a:Placement, worldMotion:RelativeMotion, out:RelativeMotion):void
        {
            var x:Number = -worldMotion.x / a.size;
            var y:Number = -worldMotion.y / a.size;
            var z:Number = -worldMotion.z / a.size;
            out.x = a.r00 * x + a.r10 * y + a.r20 * z;
            out.y = a.r01 * x + a.r11 * y + a.r21 * z;
            out.z = a.r02 * x + a.r12 * y + a.r22 * z;
            out.earliestTime = 0;
            out.latestTime = worldMotion.latestTime;
        }

        /**
         * Turns the contact of b with a, in a's space, into the contact of a with b, in the world.
         *
         * @param contact at the motion's time
         * @param a the placement of a in the world, where it stands without the motion
         * @param motion the motion of a relative to b, in the world
         */
        public static function moveContactToWorld(contact:ContactPoint, a:Placement, motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            var x:Number = contact.x * a.size;
            var y:Number = contact.y * a.size;
            var z:Number = contact.z * a.size;
            contact.x = a.r00 * x + a.r01 * y + a.r02 * z + a.x + motion.startX + time * motion.x;
            contact.y = a.r10 * x + a.r11 * y + a.r12 * z + a.y + motion.startY + time * motion.y;
            contact.z = a.r20 * x + a.r21 * y + a.r22 * z + a.z + motion.startZ + time * motion.z;
            x = -contact.normalX;
            y = -contact.normalY;
            z = -contact.normalZ;
            contact.setNormal(a.r00 * x + a.r01 * y + a.r02 * z, a.r10 * x + a.r11 * y + a.r12 * z, a.r20 * x + a.r21 * y + a.r22 * z);
            contact.depth *= a.size;
        }

        /**
         * A structure of b in a's space. The next call for the same kind overwrites it.
         *
         * @param structure in b's space
         */
        public function place(structure:BoundingStructure):BoundingStructure
        {
            var kind:int = structure.kind;
            var placed:BoundingStructure = structure.place(placement, _placed[kind]);
            // Writing an object to a field costs Adobe's VM more than comparing it first.
            if (_placed[kind] !== placed)
            {
                _placed[kind] = placed;
            }
            return placed;
        }

        /**
         * The structure of <code>place()</code>, enlarged by the margin. It is enlarged here, because V8 would allocate an object for a margin
         * that other classes pass.
         */
        public function placeWidened(structure:BoundingStructure):BoundingStructure
        {
            var placed:BoundingStructure = place(structure);
            placed.widen(margin);
            return placed;
        }
    }
}
