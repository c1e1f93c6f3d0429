package support
{
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.geometry.ConvexHull;

    /**
     * Sets a convex shape to the hull of points.
     *
     * @param center the origin of the points
     * @param points x, y, z of each
     * @return how many of the points are its corners
     */
    public function setHull(shape:ConvexShape, center:Vector3D, points:Vector.<Number>):int
    {
        var hull:ConvexHull = new ConvexHull(points);
        if (hull.triangles.length > 0)
        {
            shape.setHull(center, hull.points, facesOf(hull), edgesOf(hull));
        }
        else
        {
            shape.setHull(center, hull.points, fan(hull.points.length), allEdges(hull.points.length));
        }
        return hull.points.length / 3;
    }
}

import starlogo.geometry.ConvexHull;

// If the hull has no volume, any points are faces and edges.
function fan(end:int):Vector.<int>
{
    var faces:Vector.<int> = new Vector.<int>();
    for (var i:int = 6; i < end; i += 3)
    {
        faces.push(0, i - 3, i);
    }
    return faces;
}

function allEdges(end:int):Vector.<int>
{
    var edges:Vector.<int> = new Vector.<int>();
    for (var i:int = 0; i < end; i += 3)
    {
        for (var k:int = 0; k < i; k += 3)
        {
            edges.push(i, k, i, i);
        }
    }
    return edges;
}

function facesOf(hull:ConvexHull):Vector.<int>
{
    var faces:Vector.<int> = new Vector.<int>();
    for (var i:int = 0; i < hull.triangles.length; i++)
    {
        faces.push(3 * hull.triangles[i]);
    }
    return faces;
}

function edgesOf(hull:ConvexHull):Vector.<int>
{
    var edges:Vector.<int> = new Vector.<int>();
    var opposite:Object = {};
    for (var i:int = 0; i < hull.triangles.length; i++)
    {
        var first:int = i - i % 3;
        var p:int = hull.triangles[i];
        var q:int = hull.triangles[first + (i + 1) % 3];
        var apex:int = hull.triangles[first + (i + 2) % 3];
        if ((q + " " + p) in opposite)
        {
            edges.push(3 * p, 3 * q, 3 * apex, 3 * opposite[q + " " + p]);
        }
        else
        {
            opposite[p + " " + q] = apex;
        }
    }
    return edges;
}
