package client
{
    import flash.ui.Keyboard;
    import flash.utils.Dictionary;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionSystem;
    import starlogo.terrain.Terrain;

    /** What the games of the bear share: the agents, the keys that steer the bear, and its paintballs. */
    public class BearGame
    {
        private static const PAINTS:Array = [0xe4572e, 0x2e86ab, 0xf6ae2d, 0x8e44ad, 0x17a398, 0xd81e5b];
        private static const MOST_AGENTS:int = 90;

        // The least number of frames between two paintballs.
        private static const PAUSE:int = 14;

        /** Shows the game. */
        protected var land:Land;

        /** The shapes. */
        protected var cast:Cast;

        /** The bear; a game adds it first. */
        protected var bear:Character;

        /** By agent: its character. */
        protected var characters:Dictionary = new Dictionary();

        /** The agents that leave the game after this frame. */
        protected var gone:Vector.<Agent> = new Vector.<Agent>();

        /** The number of the frame. */
        protected var frame:int = 0;

        private var _collision:Collision;
        private var _agents:Vector.<Agent> = new Vector.<Agent>();
        private var _held:Object = {};
        private var _lastThrow:int = -100;
        private var _thrown:int = 0;

        /**
         * @param land shows the game
         * @param cast the shapes
         * @param system finds the collisions
         */
        public function BearGame(land:Land, cast:Cast, system:CollisionSystem)
        {
            this.land = land;
            this.cast = cast;
            _collision = new Collision(system);
        }

        /** @copy Show#collision */
        public function get collision():Collision
        {
            return _collision;
        }

        /** @copy Show#agentCount */
        public function get agentCount():int
        {
            return _agents.length;
        }

        /** @copy Show#play() */
        public function play():void
        {
            frame++;
            beginFrame(_agents);
            for each (var agent:Agent in _agents)
            {
                move(characters[agent]);
            }
            _collision.update(_agents);
            for each (agent in gone)
            {
                remove(agent);
            }
            gone.length = 0;
        }

        /** Moves the objects to their agents. */
        public function update():void
        {
            for each (var character:Character in characters)
            {
                character.update();
            }
        }

        /** @copy Show#press() */
        public function press(key:uint):void
        {
            _held[key] = true;
        }

        /** @copy Show#release() */
        public function release(key:uint):void
        {
            _held[key] = false;
        }

        /** Begins a frame. A game overrides it, and steers the bear. */
        protected function beginFrame(agents:Vector.<Agent>):void
        {
        }

        /** Moves an agent by one frame. A game overrides it. */
        protected function move(character:Character):void
        {
        }

        /** Throws a paintball in a direction. A game overrides it. @param number how many were thrown before */
        protected function throwBall(heading:Number, number:int):Character
        {
            return null;
        }

        /** Lets the keys steer the bear. Its speeds are in patches a frame. */
        protected function steer(forward:Number, back:Number):void
        {
            bear.speed = _held[Keyboard.UP] ? forward : _held[Keyboard.DOWN] ? -back : 0;
            bear.agent.heading += (_held[Keyboard.LEFT] ? 2.5 : 0) - (_held[Keyboard.RIGHT] ? 2.5 : 0);
            if (_held[Keyboard.SPACE] && frame - _lastThrow > PAUSE && _agents.length < MOST_AGENTS)
            {
                throwBall(bear.agent.heading + 16 * Math.sin(_thrown * 2.3), _thrown).paint(PAINTS[_thrown % PAINTS.length]);
                _thrown++;
                _lastThrow = frame;
            }
        }

        /** Adds an agent. @param terrain the ground that its shadow falls on; null for flat ground */
        protected function add(shape:String, breed:String, size:Number, x:Number, y:Number, z:Number, heading:Number, terrain:Terrain = null):Character
        {
            var agent:Agent = new Agent(shape, breed);
            agent.size = size;
            agent.moveTo(x, y, z);
            agent.heading = heading;
            var character:Character = new Character(land, cast, agent, terrain);
            _agents.push(agent);
            characters[agent] = character;
            return character;
        }

        private function remove(agent:Agent):void
        {
            var place:int = _agents.indexOf(agent);
            if (place >= 0)
            {
                _agents.splice(place, 1);
                Character(characters[agent]).leave();
                delete characters[agent];
            }
        }
    }
}
