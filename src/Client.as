package
{
    import client.Cast;
    import client.Game;
    import client.Hills;
    import client.Land;
    import client.Parade;
    import client.Show;
    import flash.display.Sprite;
    import flash.display.StageAlign;
    import flash.display.StageScaleMode;
    import flash.events.Event;
    import flash.events.KeyboardEvent;
    import flash.filters.DropShadowFilter;
    import flash.text.TextField;
    import flash.text.TextFieldAutoSize;
    import flash.text.TextFormat;
    import headless.Host;
    import starlogo.diagnostics.CollisionMonitor;

    /**
     * A small client: a game on Away3D that uses only the engine's public names.
     *
     * <p>Parameters: <code>scene</code> is "game", "models" or "hills". <code>keys</code> are key codes, separated by commas, that are held down
     * from the start. With <code>frames</code> it ends after that many frames and traces their times.</p>
     */
    public class Client extends Sprite
    {
        private static const WARM_UP:int = 20;

        private var _land:Land;
        private var _cast:Cast;
        private var _show:Show;
        private var _monitor:CollisionMonitor = null;
        private var _caption:TextField = new TextField();
        private var _frames:int;
        private var _frame:int = 0;
        private var _collisionMs:Number = 0;
        private var _bindingMs:Number = 0;
        private var _mostMs:Number = 0;

        /** Loads the shapes, then plays. */
        public function Client()
        {
            stage.scaleMode = StageScaleMode.NO_SCALE;
            stage.align = StageAlign.TOP_LEFT;
            stage.frameRate = 60;
            _frames = int(loaderInfo.parameters["frames"]);
            _land = new Land();
            addChild(_land);
            _caption.defaultTextFormat = new TextFormat("_sans", 17, 0xffffff, null, null, null, null, null, null, null, null, null, 6);
            _caption.filters = [new DropShadowFilter(1, 90, 0x16301c, 1, 4, 4, 3)];
            _caption.autoSize = TextFieldAutoSize.LEFT;
            _caption.selectable = false;
            _caption.x = 22;
            _caption.text = "loading ...";
            addChild(_caption);
            stage.addEventListener(Event.RESIZE, onResize);
            layOut();
            _cast = new Cast(_land, start, fail);
        }

        private function fail(text:String):void
        {
            _caption.text = text;
            trace(text);
            Host.exit(1);
        }

        private function onResize(event:Event):void
        {
            layOut();
        }

        private function layOut():void
        {
            _land.resize(stage.stageWidth, stage.stageHeight);
            _caption.y = stage.stageHeight - 72;
            if (_monitor != null)
            {
                _monitor.x = stage.stageWidth - _monitor.width - 12;
            }
        }

        private function start():void
        {
            _show = newShow(loaderInfo.parameters["scene"]);
            _monitor = new CollisionMonitor(_show.collision);
            addChild(_monitor);
            layOut();
            stage.addEventListener(KeyboardEvent.KEY_DOWN, onKeyDown);
            stage.addEventListener(KeyboardEvent.KEY_UP, onKeyUp);
            addEventListener(Event.ENTER_FRAME, onEnterFrame);
            for each (var key:String in String(loaderInfo.parameters["keys"] || "").split(","))
            {
                _show.press(uint(key));
            }
        }

        private function newShow(scene:String):Show
        {
            if (scene == "models")
            {
                return new Parade(_land, _cast);
            }
            return scene == "hills" ? new Hills(_land, _cast) : new Game(_land, _cast);
        }

        private function onKeyDown(event:KeyboardEvent):void
        {
            _show.press(event.keyCode);
        }

        private function onKeyUp(event:KeyboardEvent):void
        {
            _show.release(event.keyCode);
        }

        private function onEnterFrame(event:Event):void
        {
            _frame++;
            var start:Number = Host.now;
            _show.play();
            var middle:Number = Host.now;
            _show.update();
            var end:Number = Host.now;
            _land.draw();
            _caption.text = _show.caption;
            if (_frame > WARM_UP)
            {
                _collisionMs += middle - start;
                _bindingMs += end - middle;
                _mostMs = Math.max(_mostMs, end - start);
            }
            if (_frame == _frames)
            {
                finish();
            }
        }

        private function finish():void
        {
            removeEventListener(Event.ENTER_FRAME, onEnterFrame);
            var count:int = _frames - WARM_UP;
            trace(_show.agentCount + " agents: " + (_collisionMs / count).toFixed(2) + " ms moving and collisions, " + (_bindingMs / count).toFixed(2)
                    + " ms bindings a frame, " + _mostMs.toFixed(1) + " ms both at most");
            Host.exit(0);
        }
    }
}
