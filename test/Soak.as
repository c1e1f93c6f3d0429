package
{
    import flash.display.Sprite;
    import flash.events.Event;
    import headless.Host;
    import soak.SoakRun;

    /** The soak's SWF: a long mixed game; the parameter <code>frames</code> says how long. */
    public class Soak extends Sprite
    {
        private static const CHECK_EVERY:int = 100;

        private var _run:SoakRun;

        public function Soak()
        {
            trace("a soak in " + Host.player);
            _run = new SoakRun(int(loaderInfo.parameters["frames"] || 20000), CHECK_EVERY);
            _run.addEventListener(Event.COMPLETE, onComplete);
            _run.start();
        }

        private function onComplete(event:Event):void
        {
            trace(_run.problem == "" ? "the soak is well" : "the soak FAILED: " + _run.problem);
            Host.exit(_run.problem == "" ? 0 : 1);
        }
    }
}
