package client
{
    import flash.geom.Vector3D;
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
    public final class Hills extends BearGame implements Show
    {
        private static const HALF_WIDTH:Number = 40;
        private static const HILLS:Array = [[-4, 10, 22, 6], [14, -8, 18, 4.5], [-18, -10, 24, 7], [20, 18, 26, 8], [-22, 22, 20, 5], [2, -24, 20, 4],
                [30, -24, 20, 6], [-34, 4, 16, 4]];

        private var _queries:AgentQueries;
        private var _terrain:Terrain = new Terrain(161, 161, 0.5, -HALF_WIDTH, -HALF_WIDTH);
        private var _ground:Away3dTerrain;
        private var _options:WalkOptions = new WalkOptions();
        private var _footing:Footing = new Footing();
        private var _turtleFooting:Footing = new Footing();
        private var _at:Vector3D = new Vector3D();

        /**
         * @param land shows the game
         * @param cast the shapes
         */
        public function Hills(land:Land, cast:Cast)
        {
            super(land, cast, new CombinationCollider(cast.greatLand));
            for each (var hill:Array in HILLS)
            {
                _terrain.raiseMound(hill[0], hill[1], hill[2], hill[3]);
            }
            _ground = new Away3dTerrain(_terrain, land.material(0x79b356));
            land.show(_ground);
            collision.terrain = _terrain;
            collision.bounds = new WorldBounds(-HALF_WIDTH, -HALF_WIDTH, -Infinity, HALF_WIDTH, HALF_WIDTH, Infinity);
            collision.onCollision("paintballs", Collision.TERRAIN, splash);
            collision.onCollision("turtles", Collision.EDGE, turnBack);
            _queries = new AgentQueries(collision);
            populate();
        }

        /** @inheritDoc */
        public function get caption():String
        {
            var place:String = "falls";
            if (_footing.stands)
            {
                place = "stands on " + (_footing.on === _terrain.agent ? "the ground" : "the " + _footing.on.breed);
            }
            return "The bear " + place + ", " + bear.agent.z.toFixed(1)
                + " patches high\narrows: the bear   space: a paintball, which raises the ground";
        }

        /** @inheritDoc */
        override public function update():void
        {
            _ground.update();
            super.update();
            var agent:Agent = bear.agent;
            var heading:Number = agent.heading * Math.PI / 180;
            var x:Number = Math.cos(heading);
            var y:Number = Math.sin(heading);
            _at.setTo(agent.x - 10 * x, agent.y - 10 * y, agent.z + 5);
            _at.z = Math.max(_at.z, _terrain.heightAt(_at.x, _at.y) + 2 || 0);
            land.look(_at.x, _at.y, _at.z, agent.x + 4 * x, agent.y + 4 * y, agent.z + 1, frame == 1 ? 1 : 0.08);
        }

        private function populate():void
        {
            bear = place("bear", "bears", 1.5, -14, 0, -10);
            for (var i:int = 0; i < 8; i++)
            {
                // stairs of cubes
                var step:Agent = place("cube", "stairs", 2, 4 + i * 0.8, -1, 0).agent;
                step.moveTo(step.x, step.y, step.z - 1.8 + i * 0.22);
            }
            for (i = 0; i < 20; i++)
            {
                place("tree", "trees", 2.1 + i % 4 * 0.5, 33 * Math.cos(i * 2.4) * (i % 3 + 1) / 3, 33 * Math.sin(i * 2.4) * (i % 3 + 1) / 3, 77 * i);
            }
            for (i = 0; i < 24; i++)
            {
                place("turtle", "turtles", 0.9 + i % 3 * 0.25, -12 + i % 6 * 4.1, -8 + int(i / 6) * 5.4 + i % 2, 67 * i).speed = 0.04 + i % 4 * 0.01;
            }
        }

        // Adds an agent that stands on the ground.
        private function place(shape:String, breed:String, size:Number, x:Number, y:Number, heading:Number):Character
        {
            return add(shape, breed, size, x, y, _terrain.heightAt(x, y), heading, _terrain);
        }

        /** @inheritDoc */
        override protected function beginFrame(agents:Vector.<Agent>):void
        {
            _queries.update(agents);
            steer(0.16, 0.1);
        }

        /** @inheritDoc */
        override protected function move(character:Character):void
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
                        gone.push(character.agent);
                    }
                    break;
            }
        }

        private function walk(character:Character, footing:Footing):void
        {
            var heading:Number = character.agent.heading * Math.PI / 180;
            _queries.walk(character.agent, character.speed * Math.cos(heading), character.speed * Math.sin(heading), _options, footing);
        }

        /** @inheritDoc */
        override protected function throwBall(heading:Number, number:int):Character
        {
            var from:Agent = bear.agent;
            var radians:Number = heading * Math.PI / 180;
            var ball:Character = place("sphere", "paintballs", 0.45, from.x + 1.4 * Math.cos(radians), from.y + 1.4 * Math.sin(radians), heading);
            ball.agent.jumpTo(ball.agent.x, ball.agent.y, from.z + 1.8);
            ball.agent.sweeps = true;
            ball.speed = 0.35;
            ball.climb = 0.1;
            return ball;
        }

        // A ball that has hit the ground raises it, and leaves.
        private function splash(ball:Agent, ground:Agent):void
        {
            _terrain.raiseMound(ball.x, ball.y, 3, 0.5);
            gone.push(ball);
        }

        private function turnBack(turtle:Agent, edge:Agent):void
        {
            turtle.heading = Math.atan2(-turtle.y, -turtle.x) * 180 / Math.PI;
        }
    }
}
