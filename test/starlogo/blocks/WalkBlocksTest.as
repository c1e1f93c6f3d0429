package starlogo.blocks
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.collision.Collision;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import support.assertClose;
    import support.assertThrows;
    import support.create;
    import support.fillHeights;
    import support.landOf;

    public class WalkBlocksTest
    {
        private var _terrain:Terrain = new Terrain(21, 21, 1, -10, -10);
        private var _agents:Vector.<Agent> = new <Agent>[];
        private var _collisions:CollisionBlocks;
        private var _detection:DetectionBlocks;
        private var _blocks:WalkBlocks;
        private var _hero:Agent = new Agent("cube", "heroes");
        private var _platform:Agent = new Agent("slab", "platforms");

        [Before]
        public function begin():void
        {
            _collisions = new CollisionBlocks(landOf(BuiltInModel.cube(), BuiltInModel.box(4, 4, 0.5, "slab")), _agents);
            _collisions.collision.terrain = _terrain;
            _detection = new DetectionBlocks(_collisions);
            _blocks = new WalkBlocks(_detection);
            _platform.moveTo(0, 0, 2);
            _agents.push(_hero, _platform);
            _detection.update();
        }

        [Test]
        public function fallsOntoTheGround():void
        {
            _hero.moveTo(6, 0, 2);
            var speed:Number = 0;
            for (var frame:int = 0; frame < 100; frame++)
            {
                speed = _blocks.fall(_hero, speed);
            }
            assertEquals(0, speed);
            assertClose(0, _hero.z, 1e-8);
            assertTrue(_blocks.isStanding(_hero));
            assertTrue(_blocks.standsOn(_hero) === _terrain.agent);
        }

        [Test]
        public function jumpsAsHighAsTheBlockSays():void
        {
            _hero.moveTo(6, 0, 0);
            for each (var height:Number in [0.025, 0.5, 1, 3])
            {
                var speed:Number = _blocks.jump(_hero, height, _blocks.fall(_hero, 0));
                var most:Number = 0;
                for (var frame:int = 0; frame < 200; frame++)
                {
                    speed = _blocks.fall(_hero, speed);
                    most = Math.max(most, _hero.z);
                    if (frame == 1)
                    {
                        assertFalse(_blocks.isStanding(_hero));
                        assertEquals("no second jump in the air", speed, _blocks.jump(_hero, height, speed));
                    }
                }
                assertClose(height, most, 1e-8);
                assertClose(0, _hero.z, 1e-8);
            }
        }

        [Test]
        public function aSolidBreedIsASwitch():void
        {
            _hero.moveTo(0, 0, 0);
            // through the platform
            assertClose(2.4, jumpedTo(2.4), 1e-8);
            _blocks.setSolid("platforms", true);
            _blocks.setSolid("platforms", true);
            assertEquals(["platforms"].toString(), _blocks.solidBreeds.toString());
            assertClose(1, jumpedTo(2.4), 1e-6, "it bumps its head");
            _hero.moveTo(0, 0, 4);
            settle();
            assertClose(2.5, _hero.z, 1e-6, "it lands on the platform");
            assertTrue(_blocks.standsOn(_hero) === _platform);
            _blocks.setSolid("platforms", false);
            settle();
            assertClose(0, _hero.z, 1e-6);
            assertEquals(0, _blocks.solidBreeds.length);
            _blocks.solidBreeds = ["platforms", "platforms"];
            assertEquals(1, _blocks.solidBreeds.length);
        }

        [Test]
        public function goesForwardAlongSolidAgents():void
        {
            _platform.moveTo(3, 0, 0);
            _detection.update();
            _blocks.forward(_hero, 1);
            assertClose(1, _hero.x, 1e-12);
            _blocks.setSolid("platforms", true);
            _hero.moveTo(0, 0, 0);
            _blocks.forward(_hero, 3);
            assertClose(0.5, _hero.x, 1e-6);
            _hero.heading = 60;
            _blocks.forward(_hero, 1);
            assertClose(0.5, _hero.x, 1e-6);
            assertClose(Math.sqrt(3) / 2, _hero.y, 1e-6);
            assertEquals(0, _hero.z);
        }

        // A slope that would lead an agent up or down is a wall for one that stays at its height: it never gets into it.
        [Test]
        public function goesForwardAlongSlopesAtItsHeight():void
        {
            _collisions.greatLand.addModel(BuiltInModel.sphere());
            _hero.shape = "sphere";
            _agents.push(new Agent("sphere", "rocks"));
            var rock:Agent = _agents[2];
            rock.size = 2;
            _blocks.setSolid("rocks", true);
            for each (var system:String in CollisionBlocks.systemNames)
            {
                _collisions.useCollisionSystem(system);
                for each (var height:Number in [-0.9, 0.4])
                {
                    rock.moveTo(2, 0.1, height);
                    for each (var startX:Number in [-1, 1.2])
                    {
                        // at its second place it is deep in the rock, and gets no deeper
                        _hero.moveTo(startX, 0, 0);
                        _hero.heading = 0;
                        _detection.update();
                        var depth:Number = depthOf(rock);
                        for (var i:int = 0; i < 50; i++)
                        {
                            _blocks.forward(_hero, 0.1);
                            var message:String = system + " " + height + " " + startX + " " + i + ": " + _hero.x + ", " + _hero.y;
                            assertEquals(message, 0, _hero.z);
                            assertTrue(message, _detection.queries.nearPoint(new Vector3D(_hero.x, _hero.y, 0), 0).indexOf(_hero) >= 0);
                            assertTrue(message, i % 10 > 0 || depthOf(rock) <= depth + 1e-9);
                        }
                    }
                }
            }
        }

        private function depthOf(other:Agent):Number
        {
            return Collider(_collisions.collision.collisionSystem).contactOf(_hero, other).depth;
        }

        [Test]
        public function walksUpLowStepsAndIsCarried():void
        {
            _blocks.setSolid("platforms", true);
            _platform.moveTo(3, 0, -0.3);
            _detection.update();
            for (var i:int = 0; i < 20; i++)
            {
                _blocks.walk(_hero, 0.1);
            }
            assertClose(2, _hero.x, 1e-6);
            assertClose(0.2, _hero.z, 1e-6);
            for (i = 0; i < 10; i++)
            {
                _platform.moveTo(_platform.x, _platform.y + 0.1, _platform.z);
                _detection.update();
                _blocks.walk(_hero, 0);
            }
            assertClose(1, _hero.y, 1e-6, "carried");
            _blocks.walk(_hero, -1.6);
            assertClose(0, _hero.z, 1e-6, "down the step");
        }

        [Test]
        public function walkingDoesNotFall():void
        {
            _hero.moveTo(6, 0, 3);
            _blocks.walk(_hero, 0.5);
            assertClose(6.5, _hero.x, 1e-9);
            assertEquals(3, _hero.z);
            assertNull(_blocks.standsOn(_hero));
        }

        // On a slope that is as steep as a walk climbs, rounding decides nothing.
        [Test]
        public function standsOnTheSteepestSlopeThatItWalksOn():void
        {
            fillHeights(_terrain, function(column:int, row:int):Number
                {
                    return column - 10;
                });
            _collisions.greatLand.addModel(BuiltInModel.sphere());
            _hero.shape = "sphere";
            _hero.moveTo(0.3, 0.2, 2);
            settle();
            assertTrue(_blocks.fall(_hero, 0) == 0);
            assertTrue(_blocks.isStanding(_hero));
            assertTrue(_blocks.standsOn(_hero) === _terrain.agent);
            assertTrue(_blocks.jump(_hero, 1, 0) > 0);
        }

        [Test]
        public function jumpsFromTheEdgeOfAPlatform():void
        {
            _blocks.setSolid("platforms", true);
            _collisions.greatLand.addModel(BuiltInModel.sphere());
            _hero.shape = "sphere";
            _hero.moveTo(2.4, 0, 4);
            settle();
            var z:Number = _hero.z;
            assertTrue(z > 2.2);
            assertTrue(_blocks.standsOn(_hero) === _platform);
            assertTrue(_blocks.jump(_hero, 1, 0) > 0);
            assertEquals("the question moves nothing", z, _hero.z);
        }

        // The next walk takes it along, so it can jump before that.
        [Test]
        public function jumpsFromAPlatformThatGoesDown():void
        {
            _blocks.setSolid("platforms", true);
            _hero.moveTo(0, 0, 4);
            settle();
            _platform.moveTo(1, 0, 1.5);
            _detection.update();
            assertTrue(_blocks.standsOn(_hero) === _platform);
            assertEquals(0, _hero.x);
            assertClose(2.5, _hero.z, 1e-6);
            _blocks.walk(_hero, 0);
            assertClose(1, _hero.x, 1e-6, "a question does not unlink them");
            assertClose(2, _hero.z, 1e-6);
        }

        [Test]
        public function tellsStudentsWhatIsWrong():void
        {
            assertThrows(BlockError, /"walk" needs an agent, but got nothing/, _blocks.walk, null, 1);
            assertThrows(BlockError, /"walk" needs a number up to 1000000000 for steps, but got NaN/, _blocks.walk, _hero, NaN);
            assertThrows(BlockError, /"forward" needs a number up to 1000000000 for steps/, _blocks.forward, _hero, Infinity);
            assertThrows(BlockError, /"fall" needs a number up to 1000000000 for a speed/, _blocks.fall, _hero, NaN);
            for each (var block:Function in [_blocks.walk, _blocks.forward, _blocks.fall])
            {
                assertThrows(BlockError, /needs a number up to 1000000000 for (steps|a speed), but got -1100000000/, block, _hero, -1.1e9);
            }
            _blocks.fall(_hero, -1e9);
            assertThrows(BlockError, /"jump" needs a number up to 1000000000 for a height, but got 1e\+300/, _blocks.jump, _hero, 1e300, 0);
            assertThrows(ArgumentError, /solidBreeds must not be null/, function():void
                {
                    _blocks.solidBreeds = null;
                });
            assertThrows(BlockError, /"jump" needs a number up to 1000000000 for a speed, but got NaN/, _blocks.jump, _hero, 1, NaN);
            assertThrows(BlockError, /"jump" needs a number up to 1000000000 for a speed/, _blocks.jump, _hero, 1, -2e9);
            assertThrows(BlockError, /"jump" needs a height of 0 or more, but got -1/, _blocks.jump, _hero, -1, 0);
            assertThrows(BlockError, /"standing\?" needs an agent/, _blocks.isStanding, null);
            assertThrows(BlockError, /"what I stand on" needs an agent/, _blocks.standsOn, null);
            assertThrows(BlockError, /"solid" needs the name of a breed/, _blocks.setSolid, "", true);
            for each (var breed:String in [Collision.ANY_BREED, Collision.TERRAIN, Collision.EDGE])
            {
                assertThrows(BlockError, /"solid" needs an agent or a breed of the game, not the ground/, _blocks.setSolid, breed, true);
                assertThrows(BlockError, /"solid" needs an agent or a breed of the game, not the ground/, function():void
                    {
                        _blocks.solidBreeds = ["bears", breed];
                    });
            }
            assertEquals(0, _blocks.solidBreeds.length);
            for each (block in [_blocks.walk, _blocks.forward, _blocks.fall])
            {
                assertThrows(BlockError, /needs an agent, but got the ground or the edges of the world/, block, _terrain.agent, 1);
            }
            assertThrows(ArgumentError, /detection must not be null/, create, WalkBlocks, null);
            assertThrows(RangeError, /gravity must be more than 0 and at most 1000000000, not 0/, function():void
                {
                    _blocks.gravity = 0;
                });
        }

        /** No gravity makes a speed that a block refuses. */
        [Test]
        public function aSpeedStaysOneThatBlocksTake():void
        {
            assertThrows(RangeError, /at most 1000000000, not 1e\+300/, function():void
                {
                    _blocks.gravity = 1e300;
                });
            _blocks.gravity = 1e9;
            for each (var speed:Number in [-5e8, -1e9])
            {
                _hero.moveTo(50, 0, 1e9);
                assertEquals(-1e9, _blocks.fall(_hero, speed));
            }
        }

        private function settle():void
        {
            var speed:Number = 0;
            for (var frame:int = 0; frame < 120; frame++)
            {
                speed = _blocks.fall(_hero, speed);
            }
        }

        private function jumpedTo(height:Number):Number
        {
            settle();
            var speed:Number = _blocks.jump(_hero, height, 0);
            var most:Number = 0;
            while (speed > 0)
            {
                speed = _blocks.fall(_hero, speed);
                most = Math.max(most, _hero.z);
            }
            settle();
            return most;
        }
    }
}
