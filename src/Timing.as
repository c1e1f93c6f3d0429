package
{
    import evaluation.GameTask;
    import evaluation.GroundView;
    import evaluation.ModelFiles;
    import evaluation.Plan;
    import evaluation.Results;
    import evaluation.Settings;
    import evaluation.Task;
    import evaluation.TaskQueue;
    import flash.display.Sprite;
    import flash.display.StageAlign;
    import flash.display.StageScaleMode;
    import flash.events.Event;
    import flash.text.TextField;
    import flash.text.TextFieldAutoSize;
    import flash.text.TextFormat;
    import flash.utils.getDefinitionByName;
    import flash.utils.getTimer;
    import headless.Host;

    /**
     * The timing harness: the thesis's evaluation (§6), one step per player frame. The measurements go to the runner as results.json, and
     * test/timing makes tables and a report from it. Settings lists the parameters.
     */
    public class Timing extends Sprite
    {
        // Drawing the stage takes the player a good part of a shorter step.
        private static const STEP_MS:int = 150;
        private static const VIEW_MS:int = 250;
        private static const SAVE_MS:int = 5000;
        private static const FRAME_RATE:int = 60;
        // Drawing more agents takes the player longer than colliding them.
        private static const MOST_SHOWN:int = 1000;
        private static const USAGE:int = 64;

        private var _files:ModelFiles;
        private var _settings:Settings;
        private var _results:Results = new Results();
        private var _queue:TaskQueue;
        private var _lastView:int = 0;
        private var _lastSave:int = 0;
        private var _lastTask:Task = null;
        private var _view:GroundView = new GroundView(560);
        private var _caption:TextField = new TextField();

        /** Loads the models, then starts. */
        public function Timing()
        {
            stage.scaleMode = StageScaleMode.NO_SCALE;
            stage.align = StageAlign.TOP_LEFT;
            stage.frameRate = FRAME_RATE;
            _view.x = _view.y = 40;
            _caption.x = 640;
            _caption.y = 40;
            _caption.autoSize = TextFieldAutoSize.LEFT;
            _caption.defaultTextFormat = new TextFormat("_sans", 16, 0x2b2f26);
            addChild(_view);
            addChild(_caption);
            try
            {
                _settings = new Settings(loaderInfo.parameters, getDefinitionByName);
            }
            catch (error:ArgumentError)
            {
                trace("FAILED timing: " + error.message);
                Host.exit(USAGE);
                return;
            }
            _files = new ModelFiles(start, fail, _settings.hasNova);
        }

        private function fail(text:String):void
        {
            trace(text);
            Host.exit(1);
        }

        private function start():void
        {
            _results.settings = _settings.described;
            _queue = new TaskQueue(new Plan(_settings, _files, _results, stage).tasks);
            addEventListener(Event.ENTER_FRAME, onEnterFrame);
        }

        private function onEnterFrame(event:Event):void
        {
            var isDone:Boolean = false;
            var end:int = getTimer() + STEP_MS;
            do
            {
                isDone = _queue.work();
            }
            while (!isDone && getTimer() < end);
            if (getTimer() - _lastView >= VIEW_MS)
            {
                _lastView = getTimer();
                show(_queue.current);
            }
            if (_queue.current !== _lastTask && getTimer() - _lastSave >= SAVE_MS)
            {
                // what is measured stays if the run ends early
                _lastTask = _queue.current;
                _lastSave = getTimer();
                Host.writeFile("results.json", _results.toText(false));
            }
            if (isDone)
            {
                removeEventListener(Event.ENTER_FRAME, onEnterFrame);
                finish();
            }
        }

        private function show(task:Task):void
        {
            _caption.text = task.title;
            var game:GameTask = task as GameTask;
            if (game != null)
            {
                _view.visible = game.scene.agents.length <= MOST_SHOWN;
                _caption.appendText("\n\n" + game.lastFrame);
                if (_view.visible)
                {
                    _view.show(game.scene.agents, game.colliding);
                }
            }
        }

        private function finish():void
        {
            Host.writeFile("results.json", _results.toText());
            Host.exit(_results.failures == 0 ? 0 : 1);
        }
    }
}
