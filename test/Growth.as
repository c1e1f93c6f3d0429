package
{
    import flash.display.Sprite;
    import flash.events.Event;
    import growth.GrowthRows;
    import growth.GrowthRun;
    import headless.Host;

    /** The SWF that measures how costs grow (docs/limits.md). The parameter <code>rows</code> chooses rows by a part of their names. */
    public class Growth extends Sprite
    {
        private var _run:GrowthRun;

        public function Growth()
        {
            _run = new GrowthRun(GrowthRows.named(loaderInfo.parameters["rows"] || ""));
            _run.addEventListener(Event.COMPLETE, onComplete);
            trace("in " + Host.player + "\n" + GrowthRun.head);
            _run.start();
        }

        private function onComplete(event:Event):void
        {
            trace(_run.failures.length == 0 ? "nothing grows too fast" : "too much:\n" + _run.failures.join("\n"));
            Host.exit(_run.failures.length == 0 ? 0 : 1);
        }
    }
}
