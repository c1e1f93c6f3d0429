package client
{
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.collision.TightestFitCollider;

    /** The twelve models in rows, each with its tightest structure, or with a level of its hierarchy. Keys 0 to 9 choose. */
    public final class Parade implements Show
    {
        // low models stand in front
        private static const SHAPES:Array = ["dragon", "fortress", "spaceship", "kelp", "sphere", "cube", "seagull", "bear", "tree", "cylinder", "fireman",
                "person"];
        private static const HEIGHTS:Object = {sphere: 1, cube: 1, cylinder: 1.13, bear: 2, dragon: 0.4, seagull: 0.5, tree: 2.2, kelp: 0.1, fortress: 0.5,
                spaceship: 0.3, fireman: 2.2, person: 1.05};

        private static const TURN:Number = 150;

        private var _land:Land;
        private var _cast:Cast;
        private var _collision:Collision;
        private var _agents:Vector.<Agent> = new Vector.<Agent>();
        private var _characters:Vector.<Character> = new Vector.<Character>();
        private var _frame:int = 0;

        /**
         * @param land shows them
         * @param cast the shapes
         */
        public function Parade(land:Land, cast:Cast)
        {
            _land = land;
            _cast = cast;
            _collision = new Collision(new TightestFitCollider(cast.greatLand));
            for (var i:int = 0; i < SHAPES.length; i++)
            {
                var agent:Agent = new Agent(SHAPES[i], "models");
                agent.size = 3.6 / Math.max(1.25, HEIGHTS[SHAPES[i]]);
                agent.moveTo(int(i / 4) * 6.5 - 6, (1.5 - i % 4) * 5.4, 0.02);
                agent.heading = TURN;
                _agents.push(agent);
                _characters.push(new Character(land, cast, agent));
            }
            press(48);
        }

        /** @inheritDoc */
        public function get collision():Collision
        {
            return _collision;
        }

        /** @inheritDoc */
        public function get caption():String
        {
            return "The twelve models, with what collides in place of each\n0: the tightest structures   1 to 9: levels of their hierarchies";
        }

        /** @inheritDoc */
        public function get agentCount():int
        {
            return _agents.length;
        }

        /** @inheritDoc */
        public function play():void
        {
            _frame++;
            for each (var agent:Agent in _agents)
            {
                agent.heading = TURN + _frame / 2;
            }
            _collision.update(_agents);
        }

        /** @inheritDoc */
        public function update():void
        {
            for each (var character:Character in _characters)
            {
                character.update();
            }
            _land.look(-19, -2, 11, -1, -2, 0.4, 1);
        }

        /** @inheritDoc */
        public function press(key:uint):void
        {
            if (key < 48 || key > 57)
            {
                return;
            }
            for each (var character:Character in _characters)
            {
                var shape:String = character.agent.shape;
                if (key == 48)
                {
                    character.showStructure(_cast.greatLand.boundingStructures.tightestFit(shape));
                }
                else
                {
                    character.showLevel(_cast.greatLand.hierarchies.root(shape), key - 48);
                }
            }
        }

        /** @inheritDoc */
        public function release(key:uint):void
        {
        }
    }
}
