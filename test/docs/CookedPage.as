package docs
{
    import org.flexunit.asserts.assertTrue;
    import starlogo.models.Model;
    import starlogo.models.ModelLoader;
    import support.Fixtures;

    /** For docs/cooked.md: the text of a model. */
    public class CookedPage extends Page
    {
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        protected var loader:ModelLoader;
        protected var bearText:String = Fixtures.text("/assets/bear.obj");

        public function CookedPage()
        {
            loader = new ModelLoader(greatLand);
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            greatLand.addModel(Model(shown["model"]));
            assertTrue(greatLand.boundingStructures.has("bear"));
            assertTrue(greatLand.fitStore != null);
            greatLand.fitStore.clear();
        }
    }
}
