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

        /** Adds a part. */
        public function addSubGeometry(subGeometry:ISubGeometry):void
        {
        }

        /** Takes all parts away. */
        public function dispose():void
        {
        }
    }
}
