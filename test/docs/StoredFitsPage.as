package docs
{
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertTrue;
    import starlogo.models.ObjModel;
    import starlogo.steps.finish;
    import support.Fixtures;

    /** For docs/stored-fits.md: the text of a model. */
    public class StoredFitsPage extends Page
    {
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        protected var bearText:String = Fixtures.text("/assets/bear.obj");

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            finish(greatLand.receiveWithFits(new ObjModel("bear", bearText), shown["bytes"] as ByteArray));
            assertTrue(greatLand.boundingStructures.has("bear"));
            assertTrue(greatLand.fitStore != null);
            greatLand.fitStore.clear();
        }
    }
}
