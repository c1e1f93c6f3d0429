package docs
{
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertTrue;
    import starlogo.models.CookedModel;
    import support.Fixtures;

    /** For docs/cooked.md: the text of a model. */
    public class CookedPage extends Page
    {
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        protected var bearText:String = Fixtures.text("/assets/bear.obj");

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            greatLand.addModel(CookedModel.fromBytes("bear", shown["bytes"] as ByteArray));
            assertTrue(greatLand.boundingStructures.has("bear"));
            assertTrue(greatLand.fitStore != null);
            greatLand.fitStore.clear();
        }
    }
}
