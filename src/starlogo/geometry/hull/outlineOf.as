package starlogo.geometry.hull
{
    /**
     * The corners of a complete hull of vertices in a plane, in their order around it, as positions in the hull's <code>indices</code>.
     *
     * @private
     */
    public function outlineOf(hull:ConvexHull):Vector.<int>
    {
        // Each corner has two neighbours. So the walk goes on to the one that it does not come from, until it is back at the first corner.
        var outline:Vector.<int> = new <int>[0];
        var next:int = hull.neighbors[0];
        while (next != 0)
        {
            outline.push(next);
            var at:int = hull.firstNeighbor[next];
            var before:int = outline[outline.length - 2];
            next = hull.neighbors[at] == before ? hull.neighbors[at + 1] : hull.neighbors[at];
        }
        return outline;
    }
}
