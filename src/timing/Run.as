package timing
{
    import flash.utils.getTimer;
    import scenes.Scene;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionStatistics;
    import starlogo.collision.CollisionSystem;

    /**
     * A scene that is played with a collider, a frame at a time, and what it cost.
     */
    public class Run
    {
        /** Frames that are played before the clock counts. */
        public static const WARM_UP_FRAMES:int = 10;

        /** What is played. */
        public var scene:Scene;

        /** Finds the collisions. */
        public var collider:CollisionSystem;

        /** The collider's name, for tables. */
        public var colliderName:String;

        /** The thesis's figure for the same, or "". */
        public var thesisMs:String;

        private var _collision:Collision;
        private var _frames:int;
        private var _played:int = 0;
        private var _ms:int = 0;
        private var _paint:Number = 0;

        /**
         * @param scene what is played
         * @param collider finds the collisions
         * @param colliderName the collider's name
         * @param frames how many frames are timed
         * @param thesisMs the thesis's figure
         */
        public function Run(scene:Scene, collider:CollisionSystem, colliderName:String, frames:int, thesisMs:String = "")
        {
            this.scene = scene;
            this.collider = collider;
            this.colliderName = colliderName;
            this.thesisMs = thesisMs;
            _frames = frames;
            _collision = new Collision(collider);
            _collision.onCollision("turtles", "turtles", changeColor);
        }

        /** Whether all frames were played. */
        public function get isOver():Boolean
        {
            return _played == WARM_UP_FRAMES + _frames;
        }

        /** How many frames were played, warm-up included, and how many there are. */
        public function get progress():String
        {
            return _played + " of " + (WARM_UP_FRAMES + _frames) + " frames";
        }

        /** The mean time of a frame's collision detection, handlers included, in milliseconds. */
        public function get msPerFrame():Number
        {
            return _ms / Math.max(1, _played - WARM_UP_FRAMES);
        }

        /** What the last frame did. */
        public function get statistics():CollisionStatistics
        {
            return _collision.statistics;
        }

        /** Plays one frame. */
        public function playFrame():void
        {
            scene.step();
            _paint += 1;
            var start:int = getTimer();
            _collision.update(scene.agents);
            if (_played >= WARM_UP_FRAMES)
            {
                _ms += getTimer() - start;
            }
            _played++;
        }

        /** Whether trying every pair of agents finds the collisions of the last frame too, no more and no less. */
        public function agreesWithAllPairs():Boolean
        {
            var agents:Vector.<Agent> = scene.agents;
            var collisions:int = 0;
            for (var i:int = 0; i < agents.length; i++)
            {
                for (var j:int = i + 1; j < agents.length; j++)
                {
                    if (collider.areColliding(agents[i], agents[j]))
                    {
                        collisions++;
                    }
                }
            }
            return collisions == statistics.collisions;
        }

        // What the thesis's game does on a collision (§6.1): the agent changes its colour.
        private function changeColor(agent:Agent, other:Agent):void
        {
            agent.color = _paint;
        }
    }
}
