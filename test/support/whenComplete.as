package support
{
    import flash.events.Event;
    import org.flexunit.async.Async;
    import starlogo.models.ModelLoader;

    /**
     * Lets a test go on when a loader is complete. The test fails if that takes two minutes.
     *
     * @param test the object whose test runs
     * @param check <code>function():void</code>, the rest of the test
     */
    public function whenComplete(test:Object, loader:ModelLoader, check:Function):void
    {
        Async.handleEvent(test, loader, Event.COMPLETE, function(event:Event, data:Object):void
            {
                check();
            }, 120000);
    }
}
