package evaluation
{
    import evaluation.scenes.Scene;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionSystem;

    /**
     * Plays a scene with a collider and measures a frame's collision detection with its handlers (§6.1). Before that it checks the
     * collisions of an early frame against trying all pairs. How many frames are measured depends on the noise, but this frame is the
     * same for all colliders, so their collisions can be compared.
     */
    public final class GameTask extends MeasuringTask
    {
        private static const LITERAL_PAIRS:int = 300;
        private static const CHECKED_PAIRS:int = 40000;
        private static const CHECKED_FRAME:int = 3;

        /** The scene that is played. */
        public var scene:Scene;

        /** The collider. */
        public var collider:CollisionSystem;

        private var _figure:String;
        private var _subject:String;
        private var _variant:String;
        private var _literalTest:Function;
        private var _thesis:*;
        private var _checkedPairs:int;
        private var _collision:Collision;
        // the number of the last frame, which is also the colour of the agents that collided in it
        private var _paint:Number = 0;
        private var _frame:Measurement;
        private var _literal:Measurement;
        private var _check:AllPairsCheck;
        // of the frame that is checked
        private var _collisions:int;
        private var _nodeVisits:int;
        private var _hierarchyTests:int;

        /**
         * @param figure the results' figure
         * @param subject the results' row
         * @param variant the results' column: the collider
         * @param scene the scene to play
         * @param collider finds the collisions
         * @param literalTest function that decides by the thesis's own algorithms whether two agents collide, or null
         * @param thesis the thesis's milliseconds, or undefined
         * @param settings says how often
         * @param results takes the times
         */
        public function GameTask(figure:String, subject:String, variant:String, scene:Scene, collider:CollisionSystem, literalTest:Function, thesis:*, settings:Settings, results:Results)
        {
            super(variant + ", " + subject, settings.repetitions * 120, settings, results);
            _figure = figure;
            _subject = subject;
            _variant = variant;
            this.scene = scene;
            this.collider = collider;
            _literalTest = literalTest;
            _thesis = thesis;
            _checkedPairs = settings.isFull ? 25 * CHECKED_PAIRS : CHECKED_PAIRS;
        }

        /** The numbers of handler calls, pairs and collisions of the last frame, in words. */
        public function get lastFrame():String
        {
            return _collision == null ? "" : _collision.statistics.candidatePairs + " pairs\n" + _collision.statistics.collisions + " collisions";
        }

        /** The agents that collided in the last frame. Their handlers painted them, so nothing is searched again. */
        public function get colliding():Vector.<Agent>
        {
            var painted:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < scene.agents.length; i++)
            {
                if (_paint > 0 && scene.agents[i].color == _paint)
                {
                    painted.push(scene.agents[i]);
                }
            }
            return painted;
        }

        /** @inheritDoc */
        override public function work():Boolean
        {
            return isChecked() && super.work();
        }

        /** @inheritDoc */
        override protected function prepare():void
        {
            _frame = measure("step and update", playFrame, 1);
            measureOverhead(_frame, "step", scene.step, 1);
            if (_literalTest != null)
            {
                var pairs:Vector.<Agent> = somePairs();
                _literal = measure("literal", function():void
                    {
                        for (var i:int = 0; i < pairs.length; i += 2)
                        {
                            if (_literalTest(pairs[i], pairs[i + 1]))
                            {
                                changeColor(pairs[i], pairs[i + 1]);
                                changeColor(pairs[i + 1], pairs[i]);
                            }
                        }
                    }, pairs.length / scene.agents.length / (scene.agents.length - 1));
            }
        }

        /** @inheritDoc */
        override protected function conclude():Boolean
        {
            var entry:Object = _results.addTime(_figure, _subject, _variant, _frame, _base, _thesis);
            entry.agents = scene.agents.length;
            entry.collisions = _collisions;
            entry.agrees = _check.agrees;
            if (_figure == "crowds" && _nodeVisits > 0)
            {
                var visits:Object = _results.addNumber("visits", _subject, _variant, _nodeVisits, "pairs of nodes");
                visits.agents = scene.agents.length;
                visits.tests = _hierarchyTests;
            }
            if (_literal != null)
            {
                _results.addTime(_figure, _subject, _variant + ", literal", _literal, _base);
            }
            return true;
        }

        // Plays the frames up to the one that is checked, and checks it. Each call does a part of that.
        private function isChecked():Boolean
        {
            if (_collision == null)
            {
                _collision = new Collision(collider);
                _collision.onCollision("turtles", "turtles", changeColor);
            }
            if (_check != null)
            {
                return _check.work();
            }
            playFrame();
            if (_paint == CHECKED_FRAME)
            {
                _collisions = _collision.statistics.collisions;
                _nodeVisits = _collision.statistics.nodeVisits;
                _hierarchyTests = _collision.statistics.hierarchyTests;
                _check = new AllPairsCheck(collider, scene.agents, _checkedPairs);
            }
            return false;
        }

        private function playFrame():void
        {
            scene.step();
            _paint++;
            _collision.update(scene.agents);
        }

        // Pairs of agents at equal distances in the list. There are as many as the literal collider can test in a moment.
        private function somePairs():Vector.<Agent>
        {
            var agents:Vector.<Agent> = scene.agents;
            var stride:int = Math.max(1, Math.ceil(agents.length * (agents.length - 1) / 2 / LITERAL_PAIRS));
            var pairs:Vector.<Agent> = new Vector.<Agent>();
            var index:int = 0;
            for (var i:int = 0; i < agents.length; i++)
            {
                for (var j:int = i + 1; j < agents.length; j++)
                {
                    if (index++ % stride == 0)
                    {
                        pairs.push(agents[i], agents[j]);
                    }
                }
            }
            return pairs;
        }

        // The handler of the thesis's game (§6.1): the agent changes its colour.
        private function changeColor(agent:Agent, other:Agent):void
        {
            agent.color = _paint;
        }
    }
}
