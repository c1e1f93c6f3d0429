package evaluation.literal
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;

    /**
     * Thesis §3.6.6, written literally: adds the distances along the three dimensions, and compares the square of the sum with the square
     * of the radius.
     */
    public function sphereBox(sphere:Sphere, box:Box):Boolean
    {
        var between:Vector3D = sphere.center.subtract(box.center);
        var distance:Number = outside(between.dotProduct(box.axisX), box.halfX);
        distance += outside(between.dotProduct(box.axisY), box.halfY);
        distance += outside(between.dotProduct(box.axisZ), box.halfZ);
        return distance * distance <= sphere.radius * sphere.radius;
    }
}

/** How far a coordinate is outside a range around 0. */
function outside(coordinate:Number, half:Number):Number
{
    if (coordinate < -half)
    {
        return -half - coordinate;
    }
    return coordinate > half ? coordinate - half : 0;
}
