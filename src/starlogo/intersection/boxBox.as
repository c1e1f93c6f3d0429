package starlogo.intersection
{
    import starlogo.bounding.Box;
    import starlogo.intersection.boxes.BoxSeparation;

    /**
     * Whether two boxes touch or overlap, by separating axes (thesis §3.6.4; Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996;
     * Ericson, "Real-Time Collision Detection", §4.4.1). Touching counts, to within Tolerances.TOUCHING. Allocates nothing.
     *
     * <p>Two spheres decide most pairs before any axis is tried: the smallest sphere around b and the largest sphere inside of b. Then come the
     * faces of both and the cross products of their edges. If the z axes of both boxes are parallel, the faces are enough. If other axes are, or
     * are nearly so, the sweep decides, whose edge axes do not cancel.</p>
     *
     * @param a in the space of b; half-extents may be 0
     * @param b in the space of a; the answer is the same, to the last bit, for (b, a)
     */
    public function boxBox(a:Box, b:Box):Boolean
    {
        return BoxSeparation.areTouching(a, b);
    }
}
