package starlogo.intersection.ray
{
    import starlogo.bounding.Box;

    /**
     * Narrows a ray to the part inside of a box, which is the part between its three pairs of faces (Kay and Kajiya, "Ray tracing complex
     * scenes", SIGGRAPH 1986). Touching counts, to within <code>ray.touchingFactor</code>. Allocates nothing.
     *
     * @param ray in the space of the box; its part is narrowed, and its normal is set if it enters the box
     * @param box half-extents may be 0
     * @return whether the ray meets the box
     * @private
     */
    public function rayBox(ray:Ray, box:Box):Boolean
    {
        ray.near = ray.entry = -Infinity;
        ray.far = Infinity;
        ray.cutAlong(box.axisX, box.center, box.halfX);
        ray.cutAlong(box.axisY, box.center, box.halfY);
        ray.cutAlong(box.axisZ, box.center, box.halfZ);
        if (ray.near > ray.from)
        {
            ray.setNormal(ray.entered.x, ray.entered.y, ray.entered.z);
        }
        return ray.narrowExactly();
    }
}
