package
{
    import flash.display.Sprite;
    import flash.display.StageAlign;
    import flash.display.StageScaleMode;
    import flash.events.Event;
    import flash.events.IOErrorEvent;
    import flash.net.URLLoader;
    import flash.net.URLRequest;
    import flash.text.TextField;
    import flash.text.TextFieldAutoSize;
    import flash.text.TextFormat;
    import flash.utils.getTimer;
    import headless.Host;
    import scenes.CrowdScene;
    import scenes.ScatteredScene;
    import starlogo.GreatLand;
    import starlogo.collision.BinCollider;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ObjModel;
    import timing.GroundView;
    import timing.Run;
    import timing.Table;

    /**
     * The timing harness: plays games with the engine, a frame at a time, and prints what their collisions cost.
     */
    public class Timing extends Sprite
    {
        private static const MODEL_ADDRESS:String = "/assets/";
        private static const FRAME_BUDGET_MS:int = 40;
        private static const PROGRESS_MS:int = 2000;
        private static const VIEW_MS:int = 200;

        private var _greatLand:GreatLand = new GreatLand();
        private var _objFiles:Array = ["bear"];
        private var _runs:Vector.<Run> = new Vector.<Run>();
        private var _current:int = 0;
        private var _lastProgress:int;
        private var _lastView:int = 0;
        private var _failures:int = 0;
        private var _table:Table = new Table("scene", "collider", "ms/frame", "pairs tested", "collisions", "all pairs agree", "thesis ms");
        private var _view:GroundView = new GroundView(560);
        private var _caption:TextField = new TextField();

        /** Loads the models, then starts. */
        public function Timing()
        {
            stage.scaleMode = StageScaleMode.NO_SCALE;
            stage.align = StageAlign.TOP_LEFT;
            _view.x = _view.y = 40;
            _caption.x = 640;
            _caption.y = 40;
            _caption.autoSize = TextFieldAutoSize.LEFT;
            _caption.defaultTextFormat = new TextFormat("_sans", 16, 0x2b2f26);
            addChild(_view);
            addChild(_caption);
            loadModels();
        }

        private function loadModels():void
        {
            if (_objFiles.length == 0)
            {
                start();
                return;
            }
            var name:String = _objFiles.shift();
            var loader:URLLoader = new URLLoader();
            loader.addEventListener(Event.COMPLETE, function(event:Event):void
                {
                    _greatLand.addModel(new ObjModel(name, loader.data));
                    loadModels();
                });
            loader.addEventListener(IOErrorEvent.IO_ERROR, function(event:IOErrorEvent):void
                {
                    trace("can't load " + MODEL_ADDRESS + name + ".obj: " + event.text);
                    Host.exit(1);
                });
            loader.load(new URLRequest(MODEL_ADDRESS + name + ".obj"));
        }

        private function start():void
        {
            _greatLand.addModel(BuiltInModel.sphere());
            _greatLand.addModel(BuiltInModel.cube());
            plan(new BinCollider(_greatLand), "BinCollider", "30", "30");
            plan(new TightestFitCollider(_greatLand), "TightestFitCollider", "78", "1300");
            trace("Collision detection in a running game: " + _runs.length + " runs");
            _lastProgress = getTimer();
            addEventListener(Event.ENTER_FRAME, onEnterFrame);
        }

        // The thesis's set-up with spheres and with bears, and games of a thousand agents and of five thousand.
        private function plan(collider:CollisionSystem, name:String, thesisSpheresMs:String, thesisBearsMs:String):void
        {
            _runs.push(new Run(new CrowdScene(100, "sphere"), collider, name, 100, thesisSpheresMs));
            _runs.push(new Run(new CrowdScene(100, "bear"), collider, name, 100, thesisBearsMs));
            _runs.push(new Run(new ScatteredScene(1000, "bear", "sphere", "cube"), collider, name, 100));
            _runs.push(new Run(new ScatteredScene(5000, "bear", "sphere", "cube"), collider, name, 40));
        }

        private function onEnterFrame(event:Event):void
        {
            var run:Run = _runs[_current];
            run.playFrame();
            if (getTimer() - _lastView >= VIEW_MS)
            {
                _lastView = getTimer();
                show(run);
            }
            reportProgress(run);
            if (run.isOver)
            {
                record(run);
                _current++;
            }
            if (_current == _runs.length)
            {
                removeEventListener(Event.ENTER_FRAME, onEnterFrame);
                finish();
            }
        }

        private function reportProgress(run:Run):void
        {
            if (getTimer() - _lastProgress >= PROGRESS_MS)
            {
                _lastProgress = getTimer();
                trace("  run " + (_current + 1) + " of " + _runs.length + ", " + run.scene.name + ": " + run.progress);
            }
        }

        private function show(run:Run):void
        {
            _view.show(run.scene.agents, run.collider.findCollisions(run.scene.agents));
            _caption.text = run.scene.name + "\n" + run.colliderName + "\n\n" + run.progress + "\n" + run.msPerFrame.toFixed(1) + " ms a frame\n" + run.statistics.candidatePairs + " pairs tested\n" + run.statistics.collisions + " collisions";
        }

        private function record(run:Run):void
        {
            trace("  " + run.scene.name + ": checking against all pairs");
            var agrees:Boolean = run.agreesWithAllPairs();
            if (!agrees)
            {
                _failures++;
            }
            _table.add(run.scene.name, run.colliderName, run.msPerFrame.toFixed(1), run.statistics.tests, run.statistics.collisions, agrees ? "yes" : "NO", run.thesisMs);
        }

        private function finish():void
        {
            trace("");
            trace(_table);
            trace("");
            trace("Times are means over the frames after a warm-up of " + Run.WARM_UP_FRAMES + ", handlers included; a frame at 25 a second has " + FRAME_BUDGET_MS + " ms.");
            trace("The thesis's times are for 10,000 collisions: either agent of a pair against the other.");
            Host.writeFile("timing.txt", _table + "\n");
            Host.exit(_failures == 0 ? 0 : 1);
        }
    }
}
