package soak
{
    import flash.events.Event;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.async.Async;
    import support.Effort;

    /** The soak in short: all that happens in it, and its checks. */
    public class SoakTest
    {
        private static const CHECK_EVERY:int = 20;

        // whatever changes an answer, an order or a bit of a contact changes it: then it is to be written anew, the same for each machine
        private static const HASH:String = "46f825db";
        private static const FRAMES_HASHED:int = 200;

        [Test(async, timeout="330000")]
        public function whatAGameSeesIsTheSameEverywhere():void
        {
            var run:SoakRun = new SoakRun(FRAMES_HASHED, FRAMES_HASHED / 2);
            Async.handleEvent(this, run, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals(HASH, run.hash);
                }, 250000);
            run.start();
        }

        [Test(async, timeout="630000")]
        public function aMixedGame():void
        {
            var run:SoakRun = new SoakRun(Effort.choose(560, 1200), CHECK_EVERY);
            Async.handleEvent(this, run, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals("", run.problem);
                }, 550000);
            run.start();
        }
    }
}
