package evaluation.literal
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;

    /**
     * The capsule as the thesis describes it (§3.4.4): inscribed in a box, along its longest axis, then grown for each vertex outside: the end
     * that is nearer to the vertex moves out just enough to cover it.
     *
     * @param vertices x, y, z each
     * @param box encloses them
     */
    public function grownCapsule(vertices:Vector.<Number>, box:Box):Capsule
    {
        var axis:Vector3D = box.axisX;
        var half:Number = box.halfX;
        if (box.halfY > half)
        {
            axis = box.axisY;
            half = box.halfY;
        }
        if (box.halfZ > half)
        {
            axis = box.axisZ;
            half = box.halfZ;
        }
        var radius:Number = 0;
        for (var i:int = 0; i < vertices.length; i += 3)
        {
            radius = Math.max(radius, fromAxis(vertices, i, box.center, axis));
        }
        var end:Number = Math.max(0, half - radius);
        var start:Number = -end;
        for (i = 0; i < vertices.length; i += 3)
        {
            var along:Number = toVertex(vertices, i, box.center).dotProduct(axis);
            var across:Number = fromAxis(vertices, i, box.center, axis);
            var reach:Number = Math.sqrt(Math.max(0, radius * radius - across * across));
            end = Math.max(end, along - reach);
            start = Math.min(start, along + reach);
        }
        return new Capsule(onAxis(box.center, axis, start), onAxis(box.center, axis, end), radius);
    }
}

import flash.geom.Vector3D;

function toVertex(vertices:Vector.<Number>, i:int, center:Vector3D):Vector3D
{
    return new Vector3D(vertices[i] - center.x, vertices[i + 1] - center.y, vertices[i + 2] - center.z);
}

function fromAxis(vertices:Vector.<Number>, i:int, center:Vector3D, axis:Vector3D):Number
{
    return toVertex(vertices, i, center).crossProduct(axis).length;
}

function onAxis(center:Vector3D, axis:Vector3D, along:Number):Vector3D
{
    return new Vector3D(center.x + along * axis.x, center.y + along * axis.y, center.z + along * axis.z);
}
