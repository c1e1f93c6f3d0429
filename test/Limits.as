package
{
    import flash.display.Sprite;
    import flash.events.Event;
    import headless.Host;
    import soak.HostileFiles;
    import soak.LargeFiles;
    import soak.LoadRun;

    /**
     * The SWF that measures what large and hostile model files cost (docs/limits.md). Parameters: <code>files</code>, which of them by a part of
     * their names; <code>size</code>, of the hostile ones, in characters.
     */
    public class Limits extends Sprite
    {
        private var _part:String;
        private var _size:int;

        public function Limits()
        {
            _part = loaderInfo.parameters["files"] || "";
            _size = int(loaderInfo.parameters["size"] || 1000000);
            trace("in " + Host.player + ": large models, then with prepareExact, then hostile files");
            run(LargeFiles.names, LargeFiles.make, false, function():void
                {
                    run(LargeFiles.names, LargeFiles.make, true, function():void
                        {
                            run(HostileFiles.names, makeHostile, false, function():void
                                {
                                    Host.exit(0);
                                });
                        });
                });
        }

        private function run(names:Array, make:Function, prepareExact:Boolean, next:Function):void
        {
            var chosen:Array = names.filter(function(name:String, index:int, all:Array):Boolean
                {
                    return name.indexOf(_part) >= 0;
                });
            var loads:LoadRun = new LoadRun(chosen, make, prepareExact);
            loads.addEventListener(Event.COMPLETE, function(event:Event):void
                {
                    next();
                });
            loads.start();
        }

        private function makeHostile(name:String):Object
        {
            return HostileFiles.make(name, _size);
        }
    }
}
