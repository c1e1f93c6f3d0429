package client
{
    import flash.geom.Vector3D;
    import flash.ui.Keyboard;
    import flash.utils.Dictionary;
    import starlogo.agents.Agent;
    import starlogo.away3d.Away3dTerrain;
    import starlogo.collision.Collision;
    import starlogo.collision.CombinationCollider;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.Footing;
    import starlogo.queries.WalkOptions;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;

    /**
     * The bear walks over hills and up stairs, among turtles. Its paintballs fall to the ground, and each raises a small hill there. At the
     * edges of the world turtles turn around.
     */
    public final class Hills implements Show
    {
        private static const HALF_WIDTH:Number = 40;
        private static const HILLS:Array = [[-4, 10, 22, 6], [14, -8, 18, 4.5], [-18, -10, 24, 7], [20, 18, 26, 8], [-22, 22, 20, 5], [2, -24, 20, 4],
                [30, -24, 20, 6], [-34, 4, 16, 4]];
        private static const PAINTS:Array = [0xe4572e, 0x2e86ab, 0xf6ae2d, 0x8e44ad, 0x17a398, 0xd81e5b];

        private var _land:Land;
        private var _cast:Cast;
        private var _collision:Collision;
        private var _queries:AgentQueries;
        private var _terrain:Terrain = new Terrain(161, 161, 0.5, -HALF_WIDTH, -HALF_WIDTH);
        private var _ground:Away3dTerrain;
        private var _agents:Vector.<Agent> = new Vector.<Agent>();
        private var _characters:Dictionary = new Dictionary();
        private var _gone:Vector.<Agent> = new Vector.<Agent>();
        private var _bear:Character;
        private var _options:WalkOptions = new WalkOptions();
        private var _footing:Footing = new Footing();
        private var _turtleFooting:Footing = new Footing();
        private var _at:Vector3D = new Vector3D();
        private var _held:Object = {};
        private var _frame:int = 0;
        private var _lastThrow:int = -100;
        private var _thrown:int = 0;

        /**
         * @param land shows the game
         * @param cast the shapes
         */
        public function Hills(land:Land, cast:Cast)
        {
            _land = land;
            _cast = cast;
            for each (var hill:Array in HILLS)
            {
                _terrain.raiseMound(hill[0], hill[1], hill[2], hill[3]);
            }
            _ground = new Away3dTerrain(_terrain, land.material(0x79b356));
            land.show(_ground);
            _collision = new Collision(new CombinationCollider(cast.greatLand));
            _collision.terrain = _terrain;
            _collision.bounds = new WorldBounds(-HALF_WIDTH, -HALF_WIDTH, -Infinity, HALF_WIDTH, HALF_WIDTH, Infinity);
            _collision.onCollision("paintballs", Collision.TERRAIN, splash);
            _collision.onCollision("turtles", Collision.EDGE, turnBack);
            _queries = new AgentQueries(_collision);
            populate();
        }

        /** @inheritDoc */
        public function get collision():Collision
        {
            return _collision;
        }

        /** @inheritDoc */
        public function get caption():String
        {
            var place:String = "falls";
            if (_footing.stands)
            {
                place = "stands on " + (_footing.on === _terrain.agent ? "the ground" : "the " + _footing.on.breed);
            }
            return "The bear " + place + ", " + _bear.agent.z.toFixed(1)
                + " patches high\narrows: the bear   space: a paintball, which raises the ground";
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
            _queries.update(_agents);
            steer();
            for each (var agent:Agent in _agents)
            {
                move(_characters[agent]);
            }
            _collision.update(_agents);
            for each (var gone:Agent in _gone)
            {
                remove(gone);
            }
            _gone.length = 0;
        }

        /** @inheritDoc */
        public function update():void
        {
            _ground.update();
            for each (var agent:Agent in _agents)
            {
                Character(_characters[agent]).update();
            }
            var bear:Agent = _bear.agent;
            var heading:Number = bear.heading * Math.PI / 180;
            var x:Number = Math.cos(heading);
            var y:Number = Math.sin(heading);
            _at.setTo(bear.x - 10 * x, bear.y - 10 * y, bear.z + 5);
            _at.z = Math.max(_at.z, _terrain.heightAt(_at.x, _at.y) + 2 || 0);
            _land.look(_at.x, _at.y, _at.z, bear.x + 4 * x, bear.y + 4 * y, bear.z + 1, _frame == 1 ? 1 : 0.08);
        }

        /** @inheritDoc */
        public function press(key:uint):void
        {
            _held[key] = true;
        }

        /** @inheritDoc */
        public function release(key:uint):void
        {
            _held[key] = false;
        }

        private function populate():void
        {
            _bear = add("bear", "bears", 1.5, -14, 0, -10);
            for (var i:int = 0; i < 8; i++)
            {
                // stairs of cubes
                var step:Agent = add("cube", "stairs", 2, 4 + i * 0.8, -1, 0).agent;
                step.moveTo(step.x, step.y, step.z - 1.8 + i * 0.22);
            }
            for (i = 0; i < 20; i++)
            {
                add("tree", "trees", 2.1 + i % 4 * 0.5, 33 * Math.cos(i * 2.4) * (i % 3 + 1) / 3, 33 * Math.sin(i * 2.4) * (i % 3 + 1) / 3, 77 * i);
            }
            for (i = 0; i < 24; i++)
            {
                add("turtle", "turtles", 0.9 + i % 3 * 0.25, -12 + i % 6 * 4.1, -8 + int(i / 6) * 5.4 + i % 2, 67 * i).speed = 0.04 + i % 4 * 0.01;
            }
        }

        private function add(shape:String, breed:String, size:Number, x:Number, y:Number, heading:Number):Character
        {
            var agent:Agent = new Agent(shape, breed);
            agent.size = size;
            agent.moveTo(x, y, _terrain.heightAt(x, y));
            agent.heading = heading;
            var character:Character = new Character(_land, _cast, agent, _terrain);
            _agents.push(agent);
            _characters[agent] = character;
            return character;
        }

        private function steer():void
        {
            _bear.speed = _held[Keyboard.UP] ? 0.16 : _held[Keyboard.DOWN] ? -0.1 : 0;
            _bear.agent.heading += (_held[Keyboard.LEFT] ? 2.5 : 0) - (_held[Keyboard.RIGHT] ? 2.5 : 0);
            if (_held[Keyboard.SPACE] && _frame - _lastThrow > 14)
            {
                throwBall();
            }
        }

        private function move(character:Character):void
        {
            switch (character.agent.breed)
            {
                case "bears":
                    walk(character, _footing);
                    break;
                case "turtles":
                    walk(character, _turtleFooting);
                    if (_turtleFooting.part < 0.3)
                    {
                        character.agent.heading += 25;
                    }
                    break;
                case "paintballs":
                    character.climb -= 0.012;
                    character.move();
                    if (character.agent.z < -5)
                    {
                        _gone.push(character.agent);
                    }
                    break;
            }
        }

        private function walk(character:Character, footing:Footing):void
        {
            var heading:Number = character.agent.heading * Math.PI / 180;
            _queries.walk(character.agent, character.speed * Math.cos(heading), character.speed * Math.sin(heading), _options, footing);
        }

        private function throwBall():void
        {
            var bear:Agent = _bear.agent;
            var spread:Number = (bear.heading + 16 * Math.sin(_thrown * 2.3)) * Math.PI / 180;
            var ball:Character = add("sphere", "paintballs", 0.45, bear.x + 1.4 * Math.cos(spread), bear.y + 1.4 * Math.sin(spread), spread * 180 / Math.PI);
            ball.agent.jumpTo(ball.agent.x, ball.agent.y, bear.z + 1.8);
            ball.agent.sweeps = true;
            ball.speed = 0.35;
            ball.climb = 0.1;
            ball.paint(PAINTS[_thrown % PAINTS.length]);
            _thrown++;
            _lastThrow = _frame;
        }

        // A ball that has hit the ground raises it, and leaves.
        private function splash(ball:Agent, ground:Agent):void
        {
            _terrain.raiseMound(ball.x, ball.y, 3, 0.5);
            _gone.push(ball);
        }

        private function turnBack(turtle:Agent, edge:Agent):void
        {
            turtle.heading = Math.atan2(-turtle.y, -turtle.x) * 180 / Math.PI;
        }

        private function remove(agent:Agent):void
        {
            Character(_characters[agent]).leave();
            delete _characters[agent];
            _agents.splice(_agents.indexOf(agent), 1);
        }
    }
}
