package away3d.materials
{
    /** How a surface looks. */
    public class MaterialBase
    {
        public function MaterialBase()
        {
        }
    }
}
