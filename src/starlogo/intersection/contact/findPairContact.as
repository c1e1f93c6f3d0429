package starlogo.intersection.contact
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.PairTable;

    /**
     * Finds the contact of two structures: where they touch, or how they overlap.
     *
     * <p>The normal is the direction of the shortest displacement that separates the first structure from the second. The depth is its
     * length: after that displacement the two just touch. The point is in the middle of the overlap along the normal. If two boxes touch
     * along an edge or a face, it is in the middle of that edge or face too. The same holds for a box and a capsule's axis inside of it.
     * The result is exact except for rounding. Allocates nothing.</p>
     *
     * <p>A structure's core is a sphere's centre, a capsule's axis or a whole box. If the cores are apart, the normal is along the line
     * between their closest points. If they overlap, and for two boxes, the normal is perpendicular to a face of one or to an edge of each:
     * the direction along which they overlap least (Gottschalk, Lin and Manocha, "OBBTree", 1996).</p>
     *
     * <p>If several displacements are equally short, one is chosen. Spheres with the same centre separate along z. If a sphere's centre is
     * on a capsule's axis, or two capsules are parallel, the normal is perpendicular to the axis and points upwards as far as possible. In
     * the middle of a box any face is chosen.</p>
     *
     * @param a a Sphere, Capsule, Box or Hull
     * @param b a Sphere, Capsule, Box or Hull, in the same space
     * @param displacement moves the first structure from its stored place to the start of this motion. Its other fields must be 0
     * @param out receives the contact
     * @throws ArgumentError if there is no such test for the pair
     * @private
     */
    public function findPairContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
    {
        PairTable.kernelOf(a, b).findContact(a, b, displacement, out);
    }
}
