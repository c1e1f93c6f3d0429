package away3d.core.base
{
    /** The shape of a mesh, in parts. */
    public class Geometry
    {
        public function Geometry()
        {
        }

        /** Its parts. */
        public function get subGeometries():Vector.<ISubGeometry>
        {
            return null;
        }
    }
}
