package away3d.primitives
{
    import away3d.core.base.Geometry;

    /** Declares what the samples that need Away3D stand on, for where they are compiled without it; lib/away3d-api has the rest. */
    public class CubeGeometry extends Geometry
    {
        public function CubeGeometry(width:Number = 100, height:Number = 100, depth:Number = 100)
        {
        }
    }
}
