package away3d.bounds
{
    /** A volume around what is drawn. */
    public class BoundingVolumeBase
    {
        public function BoundingVolumeBase()
        {
        }
    }
}
