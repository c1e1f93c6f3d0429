package client
{
    import flash.geom.Vector3D;
    import flash.ui.Keyboard;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.terrain.Terrain;

    /** The bear of thesis §2.2 among turtles, seagulls and a fortress. Paintballs colour the agents that they hit. */
    public final class Game extends BearGame implements Show
    {
        private static const EDGE:Number = 30;

        // The level of the hierarchies that is tested and shown.
        private static const LEVEL:int = 5;

        private var _systems:Vector.<CollisionSystem>;
        private var _system:int = 1;
        private var _hasWireframes:Boolean = false;

        /**
         * @param land shows the game
         * @param cast the shapes
         */
        public function Game(land:Land, cast:Cast)
        {
            var greatLand:GreatLand = cast.greatLand;
            _systems = new <CollisionSystem>[new BinCollider(greatLand), new TightestFitCollider(greatLand), new HierarchicalCollider(greatLand),
                    new CombinationCollider(greatLand)];
            super(land, cast, _systems[_system]);
            collision.onCollision("paintballs", Collision.ANY_BREED, splash);
            collision.onCollision("bears", Collision.ANY_BREED, bump);
            collision.onCollision("turtles", Collision.ANY_BREED, turnAway);
            populate();
        }

        /** @inheritDoc */
        public function get caption():String
        {
            return ["1  BinCollider: spheres of the agents' sizes", "2  TightestFitCollider: the tightest sphere, box or capsule",
                    "3  HierarchicalCollider: a tree of boxes, to level " + LEVEL, "4  CombinationCollider: the bear's tree, the others' structures"][_system]
                + "\narrows: the bear   space: paintball   1 to 4: collision system   W: wireframes   `: monitor";
        }

        /** @inheritDoc */
        override public function update():void
        {
            super.update();
            var agent:Agent = bear.agent;
            var heading:Number = agent.heading * Math.PI / 180;
            var x:Number = Math.cos(heading);
            var y:Number = Math.sin(heading);
            land.look(agent.x - 9.5 * x, agent.y - 9.5 * y, 6.5, agent.x + 4 * x, agent.y + 4 * y, 1.2, frame == 1 ? 1 : 0.08);
        }

        /** @inheritDoc */
        override public function press(key:uint):void
        {
            super.press(key);
            if (key >= 49 && key <= 52)
            {
                _system = key - 49;
                collision.collisionSystem = _systems[_system];
            }
            else if (key == Keyboard.W)
            {
                _hasWireframes = !_hasWireframes;
            }
            else
            {
                return;
            }
            for each (var character:Character in characters)
            {
                outline(character);
            }
        }

        private function populate():void
        {
            bear = add("bear", "bears", 1.5, -9, -2, 0, 10);
            bear.agent.hierarchical = true;
            bear.agent.traversalDepth = LEVEL;
            add("fortress", "forts", 13, 10, 6, 0, 205);
            add("dragon", "dragons", 6, -1, 8, 0, -75);
            add("spaceship", "ships", 5, 12, -12, 0.1, 120);
            for (var i:int = 0; i < 12; i++)
            {
                add("tree", "trees", 2.1 + i % 4 * 0.5, 25 * Math.cos(i * 2.4) + i % 3, 22 * Math.sin(i * 2.4) - i % 5, 0, 77 * i);
            }
            for (i = 0; i < 22; i++)
            {
                add("turtle", "turtles", 0.9 + i % 3 * 0.25, -4 + i % 6 * 3.1, -8 + int(i / 6) * 3.4 + i % 2, 0, 67 * i).speed = 0.025 + i % 4 * 0.006;
            }
            for (i = 0; i < 12; i++)
            {
                add("seagull", "seagulls", 1.5, 11 + 11.5 * Math.cos(i), 5 + 11.5 * Math.sin(i), 4.5 + i % 4 * 1.2, 57.3 * i + 90).speed = 0.11;
            }
            for (i = 0; i < 4; i++)
            {
                add("person", "people", 1.7, 1.5 + 2 * i, -1.5 + i % 2 * 2.5, 0, 160 + 40 * i);
                add("fireman", "people", 0.8, -2 + 3 * i, 13 - i, 0, -80 - 20 * i);
            }
            add("kelp", "plants", 2, -4, -10, 0, 30).agent.pitch = -90;
            add("cylinder", "things", 1.2, -3, -7, 0, 0);
        }

        /** @inheritDoc */
        override protected function add(shape:String, breed:String, size:Number, x:Number, y:Number, z:Number, heading:Number,
                terrain:Terrain = null):Character
        {
            var character:Character = super.add(shape, breed, size, x, y, z, heading, terrain);
            outline(character);
            return character;
        }

        /** @inheritDoc */
        override protected function beginFrame(agents:Vector.<Agent>):void
        {
            steer(0.14, 0.08);
            bear.agent.roll = bear.speed == 0 ? 0 : 2.5 * Math.sin(frame / 5);
        }

        /** @inheritDoc */
        override protected function throwBall(heading:Number, number:int):Character
        {
            var x:Number = Math.cos(heading * Math.PI / 180);
            var y:Number = Math.sin(heading * Math.PI / 180);
            var ball:Character = add("sphere", "paintballs", 0.45, bear.agent.x + 1.9 * x, bear.agent.y + 1.9 * y, 1.6, heading);
            ball.speed = 0.3;
            ball.climb = 0.06 + number % 3 * 0.03;
            return ball;
        }

        /** @inheritDoc */
        override protected function move(character:Character):void
        {
            var agent:Agent = character.agent;
            switch (agent.breed)
            {
                case "paintballs":
                    character.climb -= 0.006;
                    if (agent.z < 0)
                    {
                        gone.push(agent);
                    }
                    break;
                case "turtles":
                    agent.heading += 1.5 * Math.sin(frame / 40 + agent.id);
                    if (Math.abs(agent.x) > EDGE || Math.abs(agent.y) > EDGE)
                    {
                        agent.heading = Math.atan2(-agent.y, -agent.x) * 180 / Math.PI;
                    }
                    break;
                case "seagulls":
                    // it flies in a circle, banked, up and down
                    agent.heading += 0.55;
                    agent.roll = -18;
                    agent.pitch = -8 * Math.sin(frame / 30 + agent.id);
                    character.climb = 0.016 * Math.sin(frame / 30 + agent.id);
                    break;
            }
            character.move();
        }

        private function splash(ball:Agent, hit:Agent):void
        {
            if (hit.breed != "paintballs" && hit != bear.agent)
            {
                Character(characters[hit]).paint(uint(ball.color));
                gone.push(ball);
            }
        }

        // Moves the bear back along its path, and around the agent that it hit.
        private function bump(bear:Agent, met:Agent):void
        {
            if (met.breed != "paintballs")
            {
                push(bear, met, 0.16);
            }
        }

        private function turnAway(turtle:Agent, met:Agent):void
        {
            if (met.breed != "paintballs" && met.breed != "seagulls")
            {
                push(turtle, met, 0.04);
                turtle.heading = Math.atan2(turtle.y - met.y, turtle.x - met.x) * 180 / Math.PI + 25;
            }
        }

        private static function push(agent:Agent, from:Agent, distance:Number):void
        {
            var x:Number = agent.x - from.x;
            var y:Number = agent.y - from.y;
            var length:Number = Math.sqrt(x * x + y * y);
            if (length > 0)
            {
                agent.moveTo(agent.x + distance * x / length, agent.y + distance * y / length, agent.z);
            }
        }

        // Shows the shape that the collision system in use tests for the agent.
        private function outline(character:Character):void
        {
            var shape:String = character.agent.shape;
            var greatLand:GreatLand = cast.greatLand;
            if (!_hasWireframes)
            {
                character.hideWireframe();
            }
            else if (_system == 0)
            {
                character.showStructure(new Sphere(new Vector3D(0, 0, 0.5), 0.5));
            }
            else if (_system == 2 || (_system == 3 && character.agent.hierarchical))
            {
                character.showLevel(greatLand.hierarchies.root(shape), LEVEL);
            }
            else
            {
                character.showStructure(greatLand.boundingStructures.tightestFit(shape));
            }
        }
    }
}
