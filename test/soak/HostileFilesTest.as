package soak
{
    import flash.events.Event;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.async.Async;
    import support.Effort;

    /** Large files are models in every format; every hostile file, a small one, ends: as a model, or with an error that says why. */
    public class HostileFilesTest
    {
        private static const SIZE:int = 3000;

        [Test(async, timeout="150000")]
        public function largeFilesAreModels():void
        {
            var run:LoadRun = new LoadRun(["OBJ 2000", "COLLADA 2000"], LargeFiles.make);
            Async.handleEvent(this, run, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals("", run.errors.join());
                    assertEquals(2, run.models);
                }, 120000);
            run.start();
        }

        [Test(async, timeout="330000")]
        public function allEnd():void
        {
            var names:Array = HostileFiles.names.filter(isForThisMachine);
            var run:LoadRun = new LoadRun(names, function(name:String):Object
                {
                    return HostileFiles.make(name, SIZE);
                });
            Async.handleEvent(this, run, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals(names.length, run.models + run.errors.length);
                    assertTrue(run.models > 10 && run.errors.length > 10);
                    for each (var error:String in run.errors)
                    {
                        assertTrue(error, error.indexOf("model \"model\"") == 0 && error.indexOf("it can't be added") < 0);
                    }
                }, 275000);
            run.start();
        }

        // Scenes of 250,000 nodes are plain code, and seconds of it.
        private static function isForThisMachine(name:String, index:int, names:Array):Boolean
        {
            return !Effort.isInterpreted || name.indexOf("placed again") < 0;
        }
    }
}
