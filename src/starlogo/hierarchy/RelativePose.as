package starlogo.hierarchy
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Touching;

    use namespace engine;

    /**
     * The pose of one agent's model in the space of another agent's model. It is computed once for each pair of agents, because all nodes
     * of their hierarchies share it.
     *
     * @private
     */
    public final class RelativePose
    {
        /** Transforms the second model into the first model's space. Its <code>isUnrotated</code> stays false: nothing is left out. */
        public var placement:Placement = new Placement();

        /** The largest distance at which the two models still touch, in the first model's space: the rounding error of their places. */
        public var tolerance:Number = 0;

        // For each kind, a structure of the second model in the first model's space.
        private var _placed:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(BoundingStructure.KIND_COUNT, true);

        public function RelativePose()
        {
            placement.isUnrotated = false;
        }

        /**
         * Computes the second model's origin and axes in the first model's space.
         *
         * @param a the first model's placement in the world
         * @param b the second model's placement in the world
         */
        public function relate(a:Placement, b:Placement):void
        {
            relateAt(a, RelativeMotion.NONE, 0, b);
        }

        /**
         * Does what <code>relate()</code> does when a motion has brought the first model from its placement to another place.
         *
         * @param time of the motion
         */
        public function relateAt(a:Placement, motion:RelativeMotion, time:Number, b:Placement):void
        {
            var relative:Placement = placement;
            var aX:Number = a.x + (motion.startX + time * motion.x);
            var aY:Number = a.y + (motion.startY + time * motion.y);
            var aZ:Number = a.z + (motion.startZ + time * motion.z);
            var x:Number = (b.x - aX) / a.size;
            var y:Number = (b.y - aY) / a.size;
            var z:Number = (b.z - aZ) / a.size;
            tolerance = (Touching.marginOfPlace(aX, aY, aZ) + Touching.marginOfPlace(b.x, b.y, b.z)) / a.size;
            relative.size = b.size / a.size;
            relative.x = a.r00 * x + a.r10 * y + a.r20 * z;
            relative.y = a.r01 * x + a.r11 * y + a.r21 * z;
            relative.z = a.r02 * x + a.r12 * y + a.r22 * z;
            relative.r00 = a.r00 * b.r00 + a.r10 * b.r10 + a.r20 * b.r20;
            relative.r01 = a.r00 * b.r01 + a.r10 * b.r11 + a.r20 * b.r21;
            relative.r02 = a.r00 * b.r02 + a.r10 * b.r12 + a.r20 * b.r22;
            relative.r10 = a.r01 * b.r00 + a.r11 * b.r10 + a.r21 * b.r20;
            relative.r11 = a.r01 * b.r01 + a.r11 * b.r11 + a.r21 * b.r21;
            relative.r12 = a.r01 * b.r02 + a.r11 * b.r12 + a.r21 * b.r22;
            relative.r20 = a.r02 * b.r00 + a.r12 * b.r10 + a.r22 * b.r20;
            relative.r21 = a.r02 * b.r01 + a.r12 * b.r11 + a.r22 * b.r21;
            relative.r22 = a.r02 * b.r02 + a.r12 * b.r12 + a.r22 * b.r22;
        }

        /**
         * Computes the second model's motion in the first model's space.
         *
         * @param a the first model's placement in the world
         * @param worldMotion the first model's motion relative to the second, in the world
         * @param out receives the motion, from the second model's pose on, but no time: its start must be 0
         */
        public static function relateMotion(a:Placement, worldMotion:RelativeMotion, out:RelativeMotion):void
        {
            var x:Number = -worldMotion.x / a.size;
            var y:Number = -worldMotion.y / a.size;
            var z:Number = -worldMotion.z / a.size;
            out.x = a.r00 * x + a.r10 * y + a.r20 * z;
            out.y = a.r01 * x + a.r11 * y + a.r21 * z;
            out.z = a.r02 * x + a.r12 * y + a.r22 * z;
            out.latest = worldMotion.latest;
        }

        /**
         * Turns the contact of the second model with the first, in the first one's space, into the contact of the first with the second, in the world.
         *
         * @param contact at the motion's time
         * @param a the first model's placement in the world, where it stands without the motion
         * @param motion the first model's motion relative to the second, in the world
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
         * A structure of the second model in the first model's space. The next call for the same kind overwrites it.
         *
         * @param structure in the second model's space
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
         * The structure of <code>place()</code>, enlarged by the tolerance. It is enlarged here, because V8 would allocate an object for a tolerance
         * that other classes pass.
         */
        public function placeWidened(structure:BoundingStructure):BoundingStructure
        {
            var placed:BoundingStructure = place(structure);
            placed.widen(tolerance);
            return placed;
        }
    }
}
