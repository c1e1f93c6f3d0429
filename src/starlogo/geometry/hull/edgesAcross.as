package starlogo.geometry.hull
{
    /**
     * Finds the edges of a closed surface of triangles that run along each other, each in one of two neighbouring triangles. The cost is
     * proportional to the number of triangles.
     *
     * @param triangles three corners each, counter-clockwise seen from outside. The edge i begins at the corner triangles[i] and ends at
     *     the next corner of the triangle
     * @param cornerCount all corners are below this number
     * @return for each edge the edge in the neighbouring triangle, which runs the other way
     * @private
     */
    public function edgesAcross(triangles:Vector.<int>, cornerCount:int):Vector.<int>
    {
        var count:int = triangles.length;
        var across:Vector.<int> = new Vector.<int>(count);
        // the edges that begin at a corner, as a list: the first one, and for each edge the next one plus 1; 0 ends the list
        var first:Vector.<int> = new Vector.<int>(cornerCount, true);
        var next:Vector.<int> = new Vector.<int>(count, true);
        var degrees:Vector.<int> = new Vector.<int>(cornerCount, true);
        for (var i:int = 0; i < count; i++)
        {
            var corner:int = triangles[i];
            next[i] = first[corner];
            first[corner] = i + 1;
            degrees[corner]++;
        }
        for (i = 0; i < count; i++)
        {
            var start:int = triangles[i];
            var end:int = triangles[i % 3 == 2 ? i - 2 : i + 1];
            // The end with fewer edges is searched for the other one, because a corner may have edges to all others. The surface is closed, so it is there.
            if (degrees[end] > degrees[start])
            {
                continue;
            }
            var other:int = first[end] - 1;
            while (triangles[other % 3 == 2 ? other - 2 : other + 1] != start)
            {
                other = next[other] - 1;
            }
            across[i] = other;
            across[other] = i;
        }
        return across;
    }
}
