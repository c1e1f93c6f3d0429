package docs
{
    import away3d.containers.Scene3D;
    import away3d.materials.ColorMaterial;
    import org.flexunit.asserts.assertEquals;
    import starlogo.terrain.Terrain;

    /** For the ASDoc of Away3dTerrain. */
    public class Away3dTerrainPage extends Page
    {
        public static const FIXTURES:Array = [];

        protected var scene:Scene3D = new Scene3D();
        protected var terrain:Terrain = new Terrain(5, 5);
        protected var material:ColorMaterial = new ColorMaterial(0x88aa55);

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            terrain.setHeight(2, 2, 3);
            shown.ground.update();
            assertEquals(3, shown.ground.maxY);
            assertEquals(scene, shown.ground.scene);
        }
    }
}
