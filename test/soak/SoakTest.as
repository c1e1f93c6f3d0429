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

        // A hash of all that the game has seen. They are the same on every machine.
        private static const HASH:String = "e2868552";
        private static const HASH_OF_THE_FIRST:String = "dfad9469";
        private static const FRAMES_HASHED:int = 200;
        private static const FIRST_FRAMES:int = 48;
        private static const MEANING:String = "An answer, the order of answers or a bit of a contact is another one: this is a hash of all that a game sees in "
            + "some frames. A hash cannot say which. If another test fails too, mend that one first. If none does, find out what has changed. Write the hash "
            + "anew only if it was meant";

        [Test(async, timeout="330000")]
        public function whatAGameSeesFirstIsTheSameEverywhere():void
        {
            assertHash(HASH_OF_THE_FIRST, FIRST_FRAMES);
        }

        [Test(async, timeout="330000")]
        public function whatAGameSeesIsTheSameEverywhere():void
        {
            assertHash(HASH, FRAMES_HASHED);
        }

        [Test(async, timeout="630000")]
        public function aMixedGame():void
        {
            var run:SoakRun = new SoakRun(Effort.choose(800, 1200), CHECK_EVERY);
            Async.handleEvent(this, run, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals("", run.problem);
                }, 550000);
            run.start();
        }

        private function assertHash(expected:String, frames:int):void
        {
            var run:SoakRun = new SoakRun(frames, frames / 2);
            Async.handleEvent(this, run, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals(MEANING, expected, run.hash);
                }, 250000);
            run.start();
        }
    }
}
