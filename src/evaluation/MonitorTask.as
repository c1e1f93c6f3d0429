package evaluation
{
    import evaluation.scenes.Scenes;
    import flash.display.Stage;
    import flash.events.Event;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionSystem;
    import starlogo.diagnostics.CollisionMonitor;
    import starlogo.diagnostics.CollisionRecorder;

    /** Measures the cost of a CollisionMonitor per frame and of a CollisionRecorder per collision. */
    public final class MonitorTask extends MeasuringTask
    {
        private static const FRAMES:int = 200;
        private static const FRAME_MS:Number = 40;
        private static const CROWD:int = 100;

        private var _agents:Vector.<Agent>;
        private var _collider:CollisionSystem;
        private var _stage:Stage;
        private var _monitor:CollisionMonitor;
        private var _time:Measurement;
        private var _recording:Measurement;

        /**
         * @param stage shows the monitor
         * @param agents play the game
         * @param collider finds the collisions
         * @param settings says how often
         * @param results takes the times
         */
        public function MonitorTask(stage:Stage, agents:Vector.<Agent>, collider:CollisionSystem, settings:Settings, results:Results)
        {
            super("the monitor of a game", settings.repetitions * 60, settings, results);
            _stage = stage;
            _agents = agents;
            _collider = collider;
        }

        /** @inheritDoc */
        override protected function prepare():void
        {
            var collision:Collision = new Collision(new CollisionRecorder(_collider));
            collision.onCollision("turtles", "turtles", changeColor);
            _monitor = new CollisionMonitor(collision);
            _stage.addChild(_monitor);
            _monitor.x = _stage.stageWidth - _monitor.width - 40;
            _monitor.y = 180;
            collision.update(_agents);
            _time = measure("monitor", showFrames, FRAMES);
            prepareRecording();
        }

        /** @inheritDoc */
        override protected function conclude():Boolean
        {
            var entry:Object = _results.addTime("monitor", _agents.length + " agents", "a frame of the monitor", _time, _base);
            _results.addTime("monitor", "recorder", "a collision recorded", _recording, _base);
            if (entry.value != null)
            {
                _results.addNumber("monitor", _agents.length + " agents", "part of a frame at 25 a second", 100 * entry.value / FRAME_MS, "%");
            }
            return true;
        }

        // Measures a system that finds every pair, with and without a recorder.
        private function prepareRecording():void
        {
            var crowd:Vector.<Agent> = Scenes.crowd(CROWD, "spheres").agents;
            var found:Vector.<Agent> = new Vector.<Agent>();
            var plain:EveryPairSystem = new EveryPairSystem();
            var recording:CollisionRecorder = new CollisionRecorder(plain);
            var pairs:int = CROWD * (CROWD - 1) / 2;
            _recording = measure("recorder", function():void
                {
                    recording.findCollisions(crowd, found);
                }, pairs);
            measureOverhead(_recording, "every pair", function():void
                {
                    plain.findCollisions(crowd, found);
                }, pairs);
        }

        private function showFrames():void
        {
            var frame:Event = new Event(Event.ENTER_FRAME);
            for (var i:int = 0; i < FRAMES; i++)
            {
                _monitor.dispatchEvent(frame);
            }
        }

        private function changeColor(agent:Object, other:Object):void
        {
            agent.color++;
        }
    }
}
