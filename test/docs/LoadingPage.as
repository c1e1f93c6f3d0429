package docs
{
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.fail;
    import org.flexunit.async.Async;
    import starlogo.models.ModelEvent;

    /** For docs/loading.md: what the loader's listeners hear. */
    public class LoadingPage extends Page
    {
        public static const FIXTURES:Array = [];

        private var _loaded:Array = [];

        protected function addAgents(event:ModelEvent):void
        {
            _loaded.push(event.model.name);
        }

        protected function showError(event:ErrorEvent):void
        {
            fail(event.text);
        }

        protected function hideProgress(event:Event):void
        {
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            Async.handleEvent(this, shown["loader"], Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals("bear,dragon", _loaded.join());
                }, 120000);
        }
    }
}
