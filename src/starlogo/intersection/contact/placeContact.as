package starlogo.intersection.contact
{
    import starlogo.convex.ContactPoint;
    import starlogo.intersection.distance.RoundGap;

    /**
     * Moves a contact's point from the first structure's core to the middle of the overlap, against the normal. A depth that rounding has
     * made negative becomes 0.
     *
     * @param gap has the first structure's radius
     * @param out has the normal, the depth and the first core's closest point; receives the point
     * @private
     */
    public function placeContact(gap:RoundGap, out:ContactPoint):void
    {
        out.depth = out.depth > 0 ? out.depth : 0;
        var back:Number = gap.radiusA - out.depth / 2;
        out.x -= back * out.normalX;
        out.y -= back * out.normalY;
        out.z -= back * out.normalZ;
    }
}
