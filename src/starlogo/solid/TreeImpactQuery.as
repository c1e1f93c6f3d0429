package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.RelativePose;
    import starlogo.intersection.PairTable;

    /**
     * Finds when and where two models first touch while the first one, a tree, moves relative to the second.
     *
     * @private
     */
    public final class TreeImpactQuery extends ImpactQuery
    {
        private var _pair:TreePair = null;

        // The second model's motion in the first model's space, from the pair's pose on.
        private var _motion:RelativeMotion = new RelativeMotion();

        // For the contact of two structures.
        private var _pose:RelativePose = new RelativePose();

        /** Sets the two models. Call it before each question. */
        public function setTo(pair:TreePair):void
        {
            _pair = pair;
        }

        /** @inheritDoc */
        override public function overlapsAt(motion:RelativeMotion, time:Number):Boolean
        {
            _pair.relateAt(motion, time);
            return _pair.overlapInPose();
        }

        /** @inheritDoc */
        override public function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            _pair.relateAt(motion, 0);
            RelativePose.relateMotion(_pair.placementA, motion, _motion);
            _pair.findTouch(_motion, out);
            motion.time = _motion.time;
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                moveToWorld(out, _pair.placementA, motion);
            }
        }

        /** Does what <code>findImpact()</code> does, and says whether one of the two is inside of the other where the motion begins. */
        public function findEntry(motion:RelativeMotion, out:ContactPoint):Boolean
        {
            findImpact(motion, out);
            return motion.time > 0 && _pair.isOneInside();
        }

        /**
         * It is the contact of two triangles that touch there, or of two nodes that decide. If one model is inside of the other, it is the contact of
         * the boxes of their roots.
         *
         * @inheritDoc
         */
        override public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            _pair.relateAt(motion, motion.time);
            RelativePose.relateMotion(_pair.placementA, motion, _motion);
            // Only what touches at once counts. The motion gives the contact its direction.
            _motion.earliest = _motion.latest = 0;
            _pair.findTouch(_motion, out);
            if (_motion.time == RelativeMotion.NEVER)
            {
                _motion.time = 0;
                _pair.findContactOfRoots(_motion, out);
            }
            moveToWorld(out, _pair.placementA, motion);
        }

        /**
         * Finds the contact of the structures around two standing models.
         *
         * @param a the structure around the first model, in its space
         * @param placementA the first model's placement in the world
         * @param b the structure around the second model, in its space
         * @param placementB the second model's placement in the world
         * @param out receives the contact, in the world
         */
        public function findOuterContact(a:BoundingStructure, placementA:Placement, b:BoundingStructure, placementB:Placement,
                out:ContactPoint):void
        {
            _pose.relate(placementA, placementB);
            PairTable.findContact(_pose.place(b), a, RelativeMotion.NONE, out);
            moveToWorld(out, placementA, RelativeMotion.NONE);
        }

        // Turns the contact of the second model with the first, in the first one's space, into the contact of the first with the second, in the world.
        // The placement is where the first model stands without the motion; the contact is at the motion's time.
        private static function moveToWorld(contact:ContactPoint, a:Placement, motion:RelativeMotion):void
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
    }
}
