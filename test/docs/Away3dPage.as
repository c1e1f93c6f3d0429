package docs
{
    import away3d.entities.Mesh;
    import away3d.materials.ColorMaterial;
    import away3d.primitives.CubeGeometry;
    import org.flexunit.asserts.assertEquals;
    import starlogo.agents.Agent;
    import starlogo.terrain.Terrain;

    /** For docs/away3d.md: a bear that is a cube. */
    public class Away3dPage extends Page
    {
        public static const FIXTURES:Array = [];

        protected var bearMesh:Mesh = new Mesh(new CubeGeometry(2, 2, 2));
        protected var terrain:Terrain = new Terrain(5, 5);
        protected var material:ColorMaterial = new ColorMaterial(0x88aa55);

        public function Away3dPage()
        {
            bear = new Agent("bear", "bears");
            bear.moveTo(3, 4, 5);
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            assertEquals("x, and y for z", "3,4", [bearMesh.x, bearMesh.z].join());
            assertEquals(terrain, shown.ground.terrain);
        }
    }
}
