// This room shows what frames cost. CollisionMonitor shows the last frames on the stage, and CollisionRecorder counts and times a whole game, as text.
// Nothing of the engine needs it. Read this file first.
package starlogo.diagnostics
{
    import flash.display.Bitmap;
    import flash.display.BitmapData;
    import flash.display.Sprite;
    import flash.events.Event;
    import flash.events.KeyboardEvent;
    import flash.geom.Rectangle;
    import flash.system.System;
    import flash.text.TextField;
    import flash.text.TextFormat;
    import flash.text.TextFormatAlign;
    import flash.ui.Keyboard;
    import flash.utils.getTimer;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionStatistics;
    import starlogo.data.requireGiven;
    import starlogo.engine;

    use namespace engine;

    /**
     * An overlay that shows the work and the cost of collision detection while a game runs:
     *
     * <listing version="3.0">
     * stage.addChild(new CollisionMonitor(collision));
     * </listing>
     *
     * <p>It shows the frames per second. It shows the milliseconds of collision detection with its handlers: the mean, the median and the
     * longest of the last 180 frames, and a graph of them. The height of the graph is 40 ms, a frame at 25 frames per second. For the last
     * update it shows the agents, the candidate pairs, the tests by kind, the node visits, the collisions and the memory. The last line is
     * the cost of the monitor itself, in milliseconds and as a share of 40 ms.</p>
     *
     * <p>A key hides and shows it. While it is hidden, it does nothing. You can drag it.</p>
     */
    public class CollisionMonitor extends Sprite
    {
        private static const WIDTH:int = 204;
        private static const MARGIN:int = 12;
        private static const GRAPH_TOP:int = 58;
        private static const GRAPH_WIDTH:int = 180;
        private static const GRAPH_HEIGHT:int = 40;
        private static const LINES_TOP:int = 104;
        private static const LINE_HEIGHT:int = 17;
        private static const FRAME_MS:int = 40;
        private static const REFRESH_FRAMES:int = 12;

        private static const PANEL:uint = 0x14181d;
        private static const LINE:uint = 0x2c343d;
        private static const TEXT:uint = 0xe8edf2;
        private static const QUIET:uint = 0x93a1b0;
        private static const EASY:uint = 0xff4fb286;
        private static const BUSY:uint = 0xffe0a53a;
        private static const LATE:uint = 0xffe2574c;
        private static const GROUND:uint = 0xff1d242b;

        /** The key code that hides and shows the monitor. */
        public var toggleKey:uint = Keyboard.BACKQUOTE;

        private var _collision:Collision;
        private var _history:BitmapData = new BitmapData(GRAPH_WIDTH, GRAPH_HEIGHT, false, GROUND);
        private var _headline:TextField;
        private var _rate:TextField;
        private var _numbers:TextField;

        // the times in the graph
        private var _times:FrameTimes = new FrameTimes(GRAPH_WIDTH);

        // since the numbers were last refreshed
        private var _frames:int = 0;
        private var _startMs:int;

        // what the monitor itself costs
        private var _ownTimes:FrameTimes = new FrameTimes();

        /**
         * Creates a monitor. It starts as soon as it is on the stage.
         *
         * @param collision the game's collisions
         * @throws ArgumentError if it is null
         */
        public function CollisionMonitor(collision:Collision)
        {
            this.collision = collision;
            x = y = MARGIN;
            draw();
            addEventListener(Event.ADDED_TO_STAGE, onAdded);
            addEventListener(Event.REMOVED_FROM_STAGE, onRemoved);
            addEventListener("mouseDown", onMouseDown);
            addEventListener("mouseUp", onMouseUp);
        }

        /** The game's collisions. You can set the collisions of another game. */
        public function get collision():Collision
        {
            return _collision;
        }

        public function set collision(value:Collision):void
        {
            requireGiven("collision", value);
            _collision = value;
        }

        /** Whether it is shown and works. */
        public function get isShown():Boolean
        {
            return visible;
        }

        public function set isShown(value:Boolean):void
        {
            visible = value;
            if (value && stage != null)
            {
                restart();
                addEventListener(Event.ENTER_FRAME, onFrame);
            }
            else
            {
                removeEventListener(Event.ENTER_FRAME, onFrame);
            }
        }

        /** The cost of the monitor itself: the mean milliseconds per frame, of the last 10,000 frames. */
        public function get ownMsPerFrame():Number
        {
            return _ownTimes.mean;
        }

        private function onAdded(event:Event):void
        {
            stage.addEventListener(KeyboardEvent.KEY_DOWN, onKeyDown);
            isShown = visible;
        }

        private function onRemoved(event:Event):void
        {
            stage.removeEventListener(KeyboardEvent.KEY_DOWN, onKeyDown);
            removeEventListener(Event.ENTER_FRAME, onFrame);
        }

        private function onKeyDown(event:KeyboardEvent):void
        {
            if (event.keyCode == toggleKey)
            {
                isShown = !visible;
            }
        }

        private function onMouseDown(event:Event):void
        {
            startDrag();
        }

        private function onMouseUp(event:Event):void
        {
            stopDrag();
        }

        /** @private Counts one frame. */
        engine function onFrame(event:Event = null):void
        {
            var start:int = getTimer();
            var ms:Number = _collision.statistics.frameMs;
            _times.add(ms);
            addToHistory(ms);
            _frames++;
            if (_frames == REFRESH_FRAMES)
            {
                refresh(start);
                restart();
            }
            // The clock counts whole milliseconds. Over many frames the mean is right.
            _ownTimes.add(getTimer() - start);
        }

        private function restart():void
        {
            _frames = 0;
            _startMs = getTimer();
        }

        private function addToHistory(ms:int):void
        {
            _history.scroll(-1, 0);
            var height:int = Math.max(1, Math.min(GRAPH_HEIGHT, ms * GRAPH_HEIGHT / FRAME_MS));
            _history.fillRect(new Rectangle(GRAPH_WIDTH - 1, 0, 1, GRAPH_HEIGHT), GROUND);
            _history.fillRect(new Rectangle(GRAPH_WIDTH - 1, GRAPH_HEIGHT - height, 1, height), ms * 4 <= FRAME_MS ? EASY : ms < FRAME_MS ? BUSY : LATE);
        }

        private function refresh(now:int):void
        {
            _headline.text = _times.mean.toFixed(1) + " ms";
            _rate.text = Math.round(1000 * _frames / Math.max(1, now - _startMs)) + " fps\nmedian " + _times.median.toFixed(1) + "\nmost "
                + _times.most.toFixed(1);
            _numbers.text = columnOf(lines, 1);
        }

        // The lines below the graph: a label and a value each.
        private function get lines():Array
        {
            var did:CollisionStatistics = _collision.statistics;
            var ownMs:Number = ownMsPerFrame;
            return [
                    ["agents", did.agents],
                    ["candidate pairs", did.candidatePairs],
                    ["sphere-sphere", did.sphereSphereTests],
                    ["sphere-capsule", did.sphereCapsuleTests],
                    ["sphere-box", did.sphereBoxTests],
                    ["capsule-capsule", did.capsuleCapsuleTests],
                    ["capsule-box", did.capsuleBoxTests],
                    ["box-box", did.boxBoxTests],
                    ["hulls", did.hullTests],
                    ["hierarchies", did.hierarchyTests],
                    ["node visits", did.nodeVisits],
                    ["triangles", did.triangleTests],
                    ["collisions", did.collisions],
                    ["handler calls", did.handlerCalls],
                    ["memory", (System.totalMemory / 1048576).toFixed(1) + " MB"],
                    ["this monitor", ownMs.toFixed(2) + " ms, " + (100 * ownMs / FRAME_MS).toFixed(1) + " %"]
                ];
        }

        private static function columnOf(lines:Array, column:int):String
        {
            return lines.map(function(line:Array, ...ignored):Object
                {
                    return line[column];
                }).join("\n");
        }

        private function draw():void
        {
            graphics.lineStyle(1, LINE);
            graphics.beginFill(PANEL, 0.92);
            graphics.drawRoundRect(0, 0, WIDTH, LINES_TOP + LINE_HEIGHT * lines.length + MARGIN, 12, 12);
            graphics.endFill();
            var graph:Bitmap = new Bitmap(_history);
            graph.x = MARGIN;
            graph.y = GRAPH_TOP;
            addChild(graph);
            addText(8, 11, QUIET, TextFormatAlign.LEFT).text = "collisions";
            _headline = addText(22, 22, TEXT, TextFormatAlign.LEFT);
            _rate = addText(8, 11, QUIET, TextFormatAlign.RIGHT);
            addText(LINES_TOP, 12, QUIET, TextFormatAlign.LEFT).text = columnOf(lines, 0);
            _numbers = addText(LINES_TOP, 12, TEXT, TextFormatAlign.RIGHT);
            mouseChildren = false;
        }

        private function addText(y:int, size:int, color:uint, align:String):TextField
        {
            var format:TextFormat = new TextFormat("_sans", size, color);
            format.align = align;
            var field:TextField = new TextField();
            field.defaultTextFormat = format;
            field.x = MARGIN - 2;
            field.y = y;
            field.width = WIDTH - 2 * field.x;
            field.height = LINE_HEIGHT * lines.length;
            field.selectable = false;
            addChild(field);
            return field;
        }
    }
}
