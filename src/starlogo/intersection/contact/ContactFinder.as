package starlogo.intersection.contact
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.intersection.PairTable;
    import starlogo.intersection.sweep.RelativeMotion;

    /**
     * Where two structures touch, or how they overlap.
     *
     * <p>The normal points along the shortest displacement that separates the first from the second, and the depth is its length: moved by as much,
     * the first just touches. Where spheres and capsules have gone no deeper than to their centres and axes, that is the line between the points of
     * these, or of the box, that are nearest to each other. Deeper than that, and for boxes, it is the direction at right angles to a face or to an
     * edge of each along which they overlap least (Gottschalk, Lin and Manocha, "OBBTree", 1996). Of several that are equally short, one is chosen:
     * centres that coincide are parted along z; a sphere or capsule on the axis of a capsule parallel to it, or in line, leaves it at right angles
     * and as upright as can be; in the middle of a box any of the faces will do.</p>
     *
     * <p>The point is in the middle of the overlap along the normal; of two boxes that touch in an edge or a face, and of a box with a
     * capsule's axis in it, in the middle of that too. Exact but for rounding; allocates nothing.</p>
     *
     * @private
     */
    public final class ContactFinder
    {
        /** How far the first structure is displaced from where it stands: to the start of this motion, which is none otherwise. */
        public var displacement:RelativeMotion = new RelativeMotion();

        private var _turned:RelativeMotion = new RelativeMotion();

        /** No contact yet. */
        public function ContactFinder()
        {
            displacement.time = 0;
        }

        /**
         * Finds the contact of two structures, of which the first is displaced.
         *
         * @param a a Sphere, Capsule or Box
         * @param b likewise, in the same space
         * @param out takes the result
         * @throws ArgumentError when there is no test for the pair
         */
        public function find(a:BoundingStructure, b:BoundingStructure, out:ContactPoint):void
        {
            if (a.kind > b.kind)
            {
                // in the other order, and turned back
                _turned.turn(displacement);
                PairTable.KERNELS[b.kind << 2 | a.kind].findContact(b, a, _turned, out);
                out.turn(displacement);
                return;
            }
            PairTable.KERNELS[a.kind << 2 | b.kind].findContact(a, b, displacement, out);
        }
    }
}
