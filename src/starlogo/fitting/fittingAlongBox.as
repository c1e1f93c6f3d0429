package starlogo.fitting
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;

    /**
     * The fit of a structure along the longest axis of a box (thesis §3.4.3). Another fitter finds the box, so it decides the structure's
     * direction.
     *
     * @param session the vertices
     * @param boxFitter finds the box; if it finds another structure, the fit throws an ArgumentError
     * @param findAlong <code>function(vertices:Vector.&lt;Number&gt;, center:Vector3D, axis:Vector3D, half:Number):BoundingStructure</code>; gets the
     *     box's centre, the unit vector along the box's longest side, or along the first of several longest sides, and half of that side's length
     *
     * @private
     */
    internal function fittingAlongBox(session:FitSession, boxFitter:Fitter, findAlong:Function):Fit
    {
        var boxFit:Fit = session.fitOf(boxFitter);
        return new Fit(session, function(session:FitSession):BoundingStructure
            {
                var box:Box = boxFit.structure as Box;
                if (box == null)
                {
                    throw new ArgumentError("the fitter must find a box: " + boxFitter);
                }
                var half:Number = Math.max(box.halfX, Math.max(box.halfY, box.halfZ));
                var axis:Vector3D = box.halfX == half ? box.axisX : (box.halfY == half ? box.axisY : box.axisZ);
                return findAlong(session.vertices, box.center, axis, half);
            }, boxFit);
    }
}
