package starlogo.queries
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.CombinationCollider;
    import starlogo.fitting.Fitter;
    import starlogo.models.Model;

    /**
     * A character with gravity in the scenes that Jolt Physics tests its CharacterVirtual with (UnitTests/Physics/CharacterVirtualTests.cpp), to
     * the tolerances of these tests. The character is a capsule. Boxes are boxes, and what is curved or has steps is a mesh of triangles.
     *
     * <p>Two rules of the engine differ. A walk up or down a slope is as fast on the ground plane as on level ground. And a character that
     * touches a slope follows it downhill however fast it is, also without <code>snap</code>.</p>
     */
    public class CharacterScenesTest
    {
        private static const RADIUS:Number = 0.32;
        private static const LENGTH:Number = 1.35;
        private static const FREQUENCIES:Array = [60, 120, 240, 360];
        private static const STEP:Number = 0.3;
        private static const STEPS:int = 10;

        private var _land:GreatLand = new GreatLand();
        private var _agents:Vector.<Agent> = new Vector.<Agent>();
        private var _queries:AgentQueries;

        public function CharacterScenesTest()
        {
            _land.prepareExact = true;
        }

        [Test]
        public function fallsAndJumps():void
        {
            addFloor();
            var character:GameCharacter = begin(addCharacter(0, 0, 2));
            assertFalse("in the air", character.step());
            character.run(1);
            isAt(character, 0, 0, 0, 1e-6);
            assertTrue(character.footing.stands);
            character.jumpSpeed = 1;
            assertFalse("it jumps", character.step());
            isAt(character, 0, 0, (1 - 9.81 / 60) / 60, 1e-6);
            character.run(1);
            isAt(character, 0, 0, 0, 1e-6);
            assertTrue(character.footing.stands);
        }

        /** It climbs slopes up to slopeDegrees. From steeper ones it slides down as a body without friction does. */
        [Test]
        public function walksOnSlopes():void
        {
            for (var degrees:int = 5; degrees < 85; degrees += 10)
            {
                clear();
                var slope:Number = degrees * Math.PI / 180;
                var character:GameCharacter = begin(addOnSlope(degrees));
                var isSteep:Boolean = degrees > character.options.slopeDegrees;
                var z:Number = character.agent.z;
                // a step of gravity, along the slope
                var first:Number = isSteep ? -9.81 / 3600 * Math.sin(slope) : 0;
                assertEquals(!isSteep, character.step());
                isAt(character, first * Math.cos(slope), 0, z + first * Math.sin(slope), 1e-5);
                character.speedZ = 0;
                character.speedX = 2;
                character.run(1.5);
                assertEquals(!isSteep, character.footing.stands);
                if (isSteep)
                {
                    // the sum of the speeds of 90 steps
                    var along:Number = first - 9.81 / 3600 * 90 * 91 / 2 * Math.sin(slope);
                    isAt(character, along * Math.cos(slope), 0, z + along * Math.sin(slope), 1e-4);
                }
                else
                {
                    isAt(character, 3, 0, z + 3 * Math.tan(slope), 1e-4);
                }
            }
        }

        /** It stays on a slope of 45 degrees that it runs down faster than it would fall. */
        [Test]
        public function sticksToASlope():void
        {
            var character:GameCharacter = begin(addOnSlope(45));
            var z:Number = character.agent.z;
            assertTrue(character.step());
            character.speedX = -10;
            for (var i:int = 1; i <= 90; i++)
            {
                assertTrue(character.step());
                isAt(character, -i / 6, 0, z - i / 6, 1e-4);
            }
        }

        /** Stairs stop it, or it climbs them: always forward, always standing, nearly as fast as on level ground. */
        [Test]
        public function climbsStairs():void
        {
            for each (var frequency:Number in FREQUENCIES)
            {
                clear();
                addFloor();
                add("stairs", stairs(), 0, 0, 0).hierarchical = true;
                var character:GameCharacter = begin(addCharacter(0, -2, 0), 1 / frequency);
                character.options.stepHeight = 0;
                character.speedY = 4;
                character.run(1);
                assertTrue(character.footing.stands);
                isAt(character, 0, -RADIUS, 0, 1.1e-2);
                character.options.stepHeight = 0.4;
                var left:int = 1.5 * Math.round((STEPS * STEP + RADIUS) / character.speedY * frequency);
                while (character.agent.z < STEPS * STEP - 1e-3)
                {
                    var y:Number = character.agent.y;
                    assertTrue("it climbs", left-- > 0);
                    assertTrue(character.step());
                    assertTrue("forward", character.agent.y > y && character.agent.y < STEPS * STEP);
                    assertTrue(Math.abs(character.agent.x) < 1e-6);
                }
            }
        }

        [Test]
        public function turnsWithAPlatform():void
        {
            var platform:Agent = add("platform", boxOf(10, 10, 1), 0, 0, 0);
            var character:GameCharacter = begin(addCharacter(9, 0, 1));
            assertTrue(character.step());
            for (var i:int = 1; i <= 60; i++)
            {
                platform.heading = 6 * i;
                _queries.refresh(platform);
                assertTrue(character.step());
                isAt(character, 9 * Math.cos(i * Math.PI / 30), 9 * Math.sin(i * Math.PI / 30), 1, 1e-4);
            }
        }

        [Test]
        public function ridesUpAndDown():void
        {
            var platform:Agent = add("platform", boxOf(10, 10, 1), 0, 0, 0);
            var character:GameCharacter = begin(addCharacter(0, 0, 1));
            assertTrue(character.step());
            for each (var speed:Number in [0.5, 0, -0.5])
            {
                for (var i:int = 0; i < 60; i++)
                {
                    platform.moveTo(0, 0, platform.z + speed / 60);
                    _queries.refresh(platform);
                    assertTrue(character.step());
                    isAt(character, 0, 0, platform.z + 1, 1e-2);
                }
            }
        }

        /** A trough of very many narrow triangles, hardly wider than the character, stops it at the ends only. */
        [Test]
        public function walksInATroughOfManyTriangles():void
        {
            addFloor();
            add("trough", trough(), 0, 0, 1).hierarchical = true;
            var character:GameCharacter = begin(addCharacter(0, 0, 1));
            character.options.stepHeight = character.options.snap = 0;
            for each (var way:Number in [1, -1])
            {
                character.speedX = 2 * way;
                for (var i:int = 0; i < 60; i++)
                {
                    character.step();
                    assertTrue("upright", character.footing.normal.z > 0.999);
                }
                isAt(character, way * (1 - RADIUS), 0, 1, 1e-4);
            }
            character.agent.jumpTo(0, 1, 0);
            _queries.refresh(character.agent);
            character.speedX = 2;
            character.run(1);
            isAt(character, 2, 1, 0, 1e-4);
            assertStrictlyEquals("the floor", _agents[0], character.footing.on);
        }

        /** A wall that it presses against does not make it faster or slower along the wall, whatever the steps. */
        [Test]
        public function walksAlongAWall():void
        {
            for each (var frequency:Number in FREQUENCIES)
            {
                clear();
                addFloor();
                add("wall", boxOf(50, 0.05, 1), 0, -RADIUS - 0.05, 1);
                var character:GameCharacter = begin(addCharacter(0, 0, 0), 1 / frequency);
                character.speedX = 5;
                character.speedY = -1;
                character.run(1);
                assertTrue(character.footing.stands);
                isAt(character, 5, 0, 0, 1e-2);
            }
        }

        /** What it overlaps at the beginning pushes it out in one step. */
        [Test]
        public function comesOutOfACrate():void
        {
            addFloor();
            add("crate", boxOf(0.5, 0.5, 0.5), -0.5, 0, 0.5);
            var character:GameCharacter = begin(addCharacter(0, 0, 0));
            for (var i:int = 0; i < 3; i++)
            {
                character.step();
                isAt(character, RADIUS, 0, 0, 1e-6);
            }
        }

        /** Two steep planks that cross where it stands drive it up. Once past them it falls back to the floor. */
        [Test]
        public function comesOutOfCrossedPlanks():void
        {
            addFloor();
            add("crate", boxOf(0.5, 0.5, 0.5), -0.5, 0, 0.5);
            add("plank", boxOf(1, 1, 0.1), 0, 0, 0).pitch = 75;
            add("plank", null, 0, 0, 0).pitch = -75;
            var character:GameCharacter = begin(addCharacter(0, 0, 0));
            for (var i:int = 0; i < 10; i++)
            {
                var z:Number = character.agent.z;
                character.step();
                assertTrue("never down", character.agent.z >= z);
            }
            assertTrue("up " + character.agent.z, character.agent.z > 0.5);
            assertTrue("between the planks " + character.agent.x, Math.abs(character.agent.x) < RADIUS && Math.abs(character.agent.y) < 1e-3);
            var x:Number = character.agent.x;
            character.speedX = 2;
            character.run(1);
            isAt(character, x + 2, 0, 0, 0.05);
        }

        /** Another character stops it, at any speed, and so does a post in between. */
        [Test]
        public function meetsACharacter():void
        {
            for each (var hasPost:Boolean in [false, true])
            {
                for each (var speed:Number in [600, 1])
                {
                    clear();
                    addFloor();
                    var other:Agent = addCharacter(1, 0, 0, 0.33);
                    var post:Agent = add("post", boxOf(0.1, 1, 1), 1.5, 0, 0);
                    post = hasPost ? add("post", null, 0.5, 0, 0) : post;
                    var character:GameCharacter = begin(addCharacter(0, 0, 0, 0.24));
                    character.step();
                    character.speedX = speed;
                    character.run(speed > 1 ? 1 / 60 : 1);
                    isAt(character, hasPost ? 0.5 - 0.1 - 0.24 : 1 - 0.33 - 0.24, 0, 0, 1e-6);
                    assertStrictlyEquals(hasPost ? post : other, _queries.castAgent(character.agent, 0.1, 0, 0).agent);
                }
            }
        }

        private static function isAt(character:GameCharacter, x:Number, y:Number, z:Number, tolerance:Number):void
        {
            var agent:Agent = character.agent;
            var off:Number = Math.sqrt((agent.x - x) * (agent.x - x) + (agent.y - y) * (agent.y - y) + (agent.z - z) * (agent.z - z));
            assertTrue([agent.x, agent.y, agent.z] + " is not " + [x, y, z], off <= tolerance);
        }

        private function clear():void
        {
            _agents.length = 0;
        }

        private function begin(agent:Agent, seconds:Number = 1 / 60):GameCharacter
        {
            var collider:CombinationCollider = new CombinationCollider(_land);
            collider.exact = true;
            _queries = new AgentQueries(collider);
            _queries.update(_agents);
            var character:GameCharacter = new GameCharacter(_queries, agent, seconds);
            character.options.slopeDegrees = 50;
            character.options.stepHeight = 0.4;
            character.options.snap = 0.5;
            return character;
        }

        // An agent with a model. A model is added once.
        private function add(shape:String, model:Model, x:Number, y:Number, z:Number):Agent
        {
            if (!_land.hasModel(shape))
            {
                _land.addModel(new Model(shape, model.vertices, model.triangles, Model.AS_GIVEN));
            }
            var agent:Agent = new Agent(shape);
            agent.moveTo(x, y, z);
            _agents.push(agent);
            return agent;
        }

        private function addFloor():Agent
        {
            return add("floor", boxOf(100, 100, 1), 0, 0, -1);
        }

        // A character that touches a slope which rises along x.
        private function addOnSlope(degrees:Number):Agent
        {
            add("floor", boxOf(100, 100, 1), 0, 0, 0).pitch = -degrees;
            return addCharacter(0, 0, (RADIUS + 1) / Math.cos(degrees * Math.PI / 180) - RADIUS);
        }

        private function addCharacter(x:Number, y:Number, z:Number, radius:Number = RADIUS):Agent
        {
            var fitters:Vector.<Fitter> = _land.boundingStructures.fitters;
            _land.boundingStructures.fitters = new <Fitter>[new OneCapsuleFitter(radius, LENGTH)];
            var agent:Agent = add("character " + radius, new Model("a", new <Number>[0, 0, 0, 0, 0, 2 * radius + LENGTH], null, Model.AS_GIVEN), x, y, z);
            _land.boundingStructures.fitters = fitters;
            return agent;
        }

        // A box around the origin.
        private static function boxOf(halfX:Number, halfY:Number, halfZ:Number):Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < 8; i++)
            {
                vertices.push((i & 1) == 0 ? -halfX : halfX, (i & 2) == 0 ? -halfY : halfY, (i & 4) == 0 ? -halfZ : halfZ);
            }
            return new Model("a", vertices, new <uint>[0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2,
                        1, 3, 7, 1, 7, 5], Model.AS_GIVEN);
        }

        // Upright and level faces alone. They rise along y, from the origin on.
        private static function stairs():Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < STEPS; i++)
            {
                for each (var x:Number in [2, -2])
                {
                    vertices.push(x, STEP * i, STEP * i, x, STEP * i, STEP * (i + 1), x, STEP * (i + 1), STEP * (i + 1));
                }
                var at:uint = 6 * i;
                triangles.push(at + 1, at, at + 4, at, at + 3, at + 4, at + 1, at + 5, at + 2, at + 1, at + 4, at + 5);
            }
            return new Model("a", vertices, triangles, Model.AS_GIVEN);
        }

        // Half of a cylinder along x, of length 2, open above and closed at both ends.
        private static function trough():Model
        {
            var segments:int = 768;
            var radius:Number = RADIUS + 0.01;
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for each (var x:Number in [-1, 1])
            {
                for (var i:int = 0; i < segments; i++)
                {
                    var angle:Number = (i / segments - 0.5) * Math.PI;
                    var isRim:Boolean = i == 0 || i == segments - 1;
                    vertices.push(x, radius * Math.sin(angle), isRim ? 0.5 : radius * (1 - Math.cos(angle)));
                }
            }
            for (i = 1; i < segments; i++)
            {
                var at:uint = segments + i;
                triangles.push(at, at - 1, i, at - 1, i - 1, i);
                triangles.push(0, i, i - 1, segments, at - 1, at);
            }
            return new Model("a", vertices, triangles, Model.AS_GIVEN);
        }
    }
}
