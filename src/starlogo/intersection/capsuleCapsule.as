package starlogo.intersection
{
    import starlogo.bounding.Capsule;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.compareVectors;
    import starlogo.geometry.Tolerances;

    /**
     * Whether two capsules touch or overlap: compares the distance of their segments with the sum of the radii (thesis §3.6.3). Touching
     * counts, to within Tolerances.TOUCHING. Allocates nothing.
     *
     * <p>The thesis finds the closest points of the two lines and clamps both parameters. That does not always give the closest points of
     * the segments, so here the other parameter is computed again after one is clamped (Ericson, "Real-Time Collision Detection", 5.1.9).
     * Nearly parallel segments cost a little more, because the lines' closest points then come from cross products, which do not
     * cancel.</p>
     *
     * @param a in the space of b; its length may be 0
     * @param b in the space of a; the answer is the same, to the last bit, for (b, a)
     */
    public function capsuleCapsule(a:Capsule, b:Capsule):Boolean
    {
        var segments:SegmentPair = SegmentPair.SCRATCH;
        var gap:RoundGap = RoundGap.SCRATCH;
        // Capsules with the same start touch, so their order does not matter.
        var areSwapped:Boolean = compareVectors(a.start, b.start) > 0;
        var first:Capsule = areSwapped ? b : a;
        var second:Capsule = areSwapped ? a : b;
        segments.setTo(first.start, first.end, RelativeMotion.NONE, second.start, second.end);
        segments.findGap(gap);
        var touchingDistance:Number = (a.radius + b.radius) * Tolerances.TOUCHING;
        return gap.squaredLength <= touchingDistance * touchingDistance;
    }
}
