package docs
{
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;
    import org.flexunit.async.Async;

    /** For the ASDoc of ModelLoader. */
    public class ModelLoaderPage extends Page
    {
        public static const FIXTURES:Array = [];

        protected function startGame(event:Event):void
        {
        }

        protected function showError(event:ErrorEvent):void
        {
            fail(event.text);
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            Async.handleEvent(this, shown["loader"], Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertTrue(greatLand.hasModel("bear"));
                }, 120000);
        }
    }
}
