package away3d.bounds
{
    /** A box along the object's axes. */
    public class AxisAlignedBoundingBox extends BoundingVolumeBase
    {
        public function AxisAlignedBoundingBox()
        {
        }
    }
}
