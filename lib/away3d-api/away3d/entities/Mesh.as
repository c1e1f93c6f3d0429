package away3d.entities
{
    import away3d.core.base.Geometry;
    import away3d.materials.MaterialBase;

    /** A geometry with a material. */
    public class Mesh extends Entity
    {
        public function Mesh(geometry:Geometry, material:MaterialBase = null)
        {
        }

        /** Its shape. */
        public function get geometry():Geometry
        {
            return null;
        }

        public function set geometry(value:Geometry):void
        {
        }
    }
}
