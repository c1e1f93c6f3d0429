package soak
{
    import flash.events.Event;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.async.Async;

    /** The soak in short: all that happens in it, and its checks. */
    public class SoakTest
    {
        private static const FRAMES:int = 1200;
        private static const CHECK_EVERY:int = 20;

        [Test(async, timeout="120000")]
        public function aMixedGame():void
        {
            var run:SoakRun = new SoakRun(FRAMES, CHECK_EVERY);
            Async.handleEvent(this, run, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals("", run.problem);
                }, 110000);
            run.start();
        }
    }
}
