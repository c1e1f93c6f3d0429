package starlogo.blocks
{
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.geometry.Trigonometry;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.Footing;
    import starlogo.queries.WalkOptions;

    use namespace engine;

    /**
     * The blocks that move agents over floors and along walls: "solid", "forward", "walk", "fall", "jump", "standing?", "what I stand on". Floors
     * and walls are the ground and the agents of solid breeds. An agent that stands on a moving agent is carried by it.
     *
     * <p>The upward speed of an agent is a number that the client keeps for each agent, 0 at the beginning. "fall" and "jump" get it and return
     * the new one. A program calls "fall" in every frame.</p>
     */
    public class WalkBlocks
    {
        private var _detection:DetectionBlocks;
        private var _gravity:Number = 0.01;
        private var _solid:AgentFilter = AgentFilter.ofBreeds();

        // What is in the way: the ground and the solid breeds.
        private var _obstacles:AgentFilter = AgentFilter.ofBreeds(Collision.TERRAIN);

        private var _footing:Footing = new Footing();

        /**
         * Creates blocks without solid breeds.
         *
         * @param detection finds what is in an agent's way. Agents are in the way where its <code>update()</code> has seen them
         * @throws ArgumentError if it is null
         */
        public function WalkBlocks(detection:DetectionBlocks)
        {
            requireGiven("detection", detection);
            _detection = detection;
        }

        /** By how much falling gets faster in each frame, in patches a frame; 0.01. @throws RangeError if it is not more than 0, or more than 1e9 */
        public function get gravity():Number
        {
            return _gravity;
        }

        public function set gravity(value:Number):void
        {
            if (!(value > 0 && value <= Agent.LARGEST_COORDINATE))
            {
                throw new RangeError("gravity must be more than 0 and at most " + Agent.LARGEST_COORDINATE + ", not " + value);
            }
            _gravity = value;
        }

        /**
         * The names of the solid breeds. The list that is read is a copy, and so is the list that is kept.
         *
         * @throws ArgumentError if it is set to null
         * @throws BlockError if a name that is set is missing, or is Collision.ANY_BREED, TERRAIN or EDGE
         */
        public function get solidBreeds():Array
        {
            var names:Array = [];
            for each (var name:String in _solid.breeds)
            {
                names.push(name);
            }
            return names;
        }

        public function set solidBreeds(names:Array):void
        {
            requireGiven("solidBreeds", names);
            var breeds:Vector.<String> = new Vector.<String>();
            for each (var name:String in names)
            {
                BlockChecks.requireTraitSubject("solid", name);
                if (breeds.indexOf(name) < 0)
                {
                    breeds.push(name);
                }
            }
            _solid.breeds = breeds;
            _obstacles.breeds = breeds.concat();
            _obstacles.breeds.push(Collision.TERRAIN);
        }

        /**
         * The block "solid": a switch. Nobody walks, falls or jumps through the agents of a solid breed.
         *
         * @param breed the name of a breed
         * @param isOn whether it is solid from now on
         * @throws BlockError if there is no breed, or if it is Collision.ANY_BREED, TERRAIN or EDGE
         */
        public function setSolid(breed:String, isOn:Boolean):void
        {
            BlockChecks.requireBreed("solid", breed);
            BlockChecks.requireTraitSubject("solid", breed);
            _detection.warnOfBreed(breed);
            solidBreeds = isOn ? solidBreeds.concat(breed) : solidBreeds.filter(function(name:String, ...ignored):Boolean
                {
                    return name != breed;
                });
        }

        /**
         * The block "forward", in a game with solid breeds: moves the agent by its heading, at its height. It slides along solid agents, and their
         * slopes stop it as walls do. The ground is not in its way.
         *
         * @param agent the agent that moves
         * @param steps how far, in patches; a negative number moves it back
         * @throws BlockError if there is no agent, or steps is not a number or more than 1e9 either way
         * @throws RangeError if the agent would leave the world; it then stays
         */
        public function forward(agent:Agent, steps:Number):void
        {
            checkNumber("forward", agent, steps, "steps");
            _detection.queries.moves.slideLevel(agent, steps * Trigonometry.cosine(agent.heading), steps * Trigonometry.sine(agent.heading), _solid);
        }

        /**
         * The block "walk": moves the agent by its heading, as a game character goes. It climbs low steps and gentle slopes, stays on the ground
         * when the way leads down, slides along walls, and is carried by what it stands on. It does not fall: "fall" does that.
         *
         * @param agent the agent that walks
         * @param steps how far, in patches; a negative number moves it back
         * @throws BlockError if there is no agent, or steps is not a number or more than 1e9 either way
         * @throws RangeError if the agent would leave the world; it then stays
         */
        public function walk(agent:Agent, steps:Number):void
        {
            checkNumber("walk", agent, steps, "steps");
            _detection.queries.walk(agent, steps * Trigonometry.cosine(agent.heading), steps * Trigonometry.sine(agent.heading), optionsOf(0), _footing);
        }

        /**
         * The block "fall": one frame of a jump or a fall. The agent lands on floors, and bumps its head.
         *
         * @param agent the agent that falls, or rises
         * @param speed its upward speed, in patches a frame
         * @return its new speed, at most 1e9 downwards; 0 if it stands, or has bumped its head
         * @throws BlockError if there is no agent, or the speed is not a number or more than 1e9 either way
         * @throws RangeError if the agent would leave the world; it then stays
         */
        public function fall(agent:Agent, speed:Number):Number
        {
            checkNumber("fall", agent, speed, "a speed");
            if (speed > 0)
            {
                return _detection.queries.moveUntilTouch(agent, 0, 0, speed, _obstacles) < 1 ? 0 : speed - _gravity;
            }
            var fall:Number = Math.min(_gravity - speed, Agent.LARGEST_COORDINATE);
            _detection.queries.walk(agent, 0, 0, optionsOf(fall), _footing);
            return _footing.stands ? 0 : -fall;
        }

        /**
         * The block "jump": the speed with which an agent that stands jumps. If it does not stand, its speed stays. See standsOn().
         *
         * @param agent the agent that jumps
         * @param height how high, in patches, 0 or more
         * @param speed its upward speed, in patches a frame
         * @return its new speed
         * @throws BlockError if there is no agent, the height is negative, more than 1e9 or not a number, or the speed is not a number or more than
         *     1e9 either way
         */
        public function jump(agent:Agent, height:Number, speed:Number):Number
        {
            checkNumber("jump", agent, height, "a height");
            checkNumber("jump", agent, speed, "a speed");
            BlockChecks.requireNotNegative("jump", height, "height");
            if (standsOn(agent) == null)
            {
                return speed;
            }
            // A rise of n frames has the speeds v, v - g, ... and the height n v - n (n - 1) g / 2. This is the least n that is high enough.
            var frames:Number = Math.max(1, Math.ceil((Math.sqrt(_gravity * (_gravity + 8 * height)) / _gravity - 1) / 2));
            return height / frames + (frames - 1) * _gravity / 2;
        }

        /**
         * The block "standing?": whether the agent stands on a floor. See standsOn().
         *
         * @param agent the agent that asks
         * @throws BlockError if there is no agent
         */
        public function isStanding(agent:Agent):Boolean
        {
            BlockChecks.requirePlacedAgent("standing?", agent);
            return standsOn(agent) != null;
        }

        /**
         * The block "what I stand on": the agent below the agent. It stands if "walk" with 0 steps would stand, which first lets a platform that has
         * moved carry it, and pushes it out of what it overlaps. But nothing moves.
         *
         * @param agent the agent that asks
         * @return null if it does not stand; for the ground the agent of the terrain
         * @throws BlockError if there is no agent
         */
        public function standsOn(agent:Agent):Agent
        {
            BlockChecks.requirePlacedAgent("what I stand on", agent);
            return _detection.queries.moves.findFooting(agent, optionsOf(0), _footing).on;
        }

        // The options of a walk in which the agent falls at most so far.
        private function optionsOf(fall:Number):WalkOptions
        {
            var options:WalkOptions = new WalkOptions();
            options.filter = _obstacles;
            options.fall = fall;
            return options;
        }

        private static function checkNumber(block:String, agent:Agent, value:Number, what:String):void
        {
            BlockChecks.requirePlacedAgent(block, agent);
            BlockChecks.requireNumber(block, value, what);
        }
    }
}
