package starlogo
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.ColladaAnimations;
    import starlogo.models.ColladaModel;
    import starlogo.models.ModelLoader;
    import starlogo.models.ObjModel;
    import support.Failures;
    import support.assertThrows;
    import support.create;

    /** Tests null as a name, a file or an address. JavaScript refuses it where the engine is called. */
    public final class NullInputTest
    {
        [Test]
        public function nothingHasThisName():void
        {
            assertFalse(new GreatLand().removeModel(null));
            assertFalse(new HierarchiesLibrary().has(null));
        }

        [Test]
        public function aFileIsNotThere():void
        {
            for each (var format:Class in [ObjModel, ColladaModel, ColladaAnimations])
            {
                Failures.assertFails("", "there is nothing to read: the file's content is null", create, format, "a", null);
            }
            Failures.assertFails("", "there is nothing to read", ColladaModel.fromBytes, "a", null);
        }

        [Test]
        public function aLoaderHasNothingToLoad():void
        {
            var greatLand:GreatLand = new GreatLand();
            var loader:ModelLoader = new ModelLoader(greatLand);
            for each (var load:Function in [loader.load, loader.loadBytes, loader.loadText])
            {
                assertThrows(ArgumentError, 'model "nothing": there is nothing to load', load, "nothing", null);
            }
            assertThrows(ArgumentError, 'model "nothing": there is nothing to load', loader.load, "nothing", "");
            assertThrows(ArgumentError, "needs a name", loader.loadText, null, "v 0 0 0");
            assertEquals(0, loader.pendingCount);
            assertFalse(greatLand.isLoading("nothing"));
        }
    }
}
