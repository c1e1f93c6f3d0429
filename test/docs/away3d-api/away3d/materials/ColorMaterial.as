package away3d.materials
{
    /** As CubeGeometry here. */
    public class ColorMaterial extends MaterialBase
    {
        public function ColorMaterial(color:uint)
        {
        }
    }
}
