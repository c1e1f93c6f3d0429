package starlogo
{
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.async.Async;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.ColladaAnimations;
    import starlogo.models.ColladaModel;
    import starlogo.models.ModelLoader;
    import starlogo.models.ObjModel;
    import support.Failures;
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

        [Test(async, timeout="150000")]
        public function anAddressIsNone():void
        {
            var said:Array = [];
            var loader:ModelLoader = new ModelLoader(new GreatLand());
            loader.addEventListener(ErrorEvent.ERROR, function(event:ErrorEvent):void
                {
                    said.push(event.text);
                });
            loader.load("nowhere", null);
            Async.handleEvent(this, loader, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals(1, said.length);
                    assertTrue(said[0], said[0].indexOf("model \"nowhere\": there is no address") == 0);
                }, 120000);
        }
    }
}
