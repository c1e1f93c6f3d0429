package starlogo.blocks
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.data.warn;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.assertClose;
    import support.assertThrows;
    import support.create;
    import support.landOf;

    public class DetectionBlocksTest
    {
        private var _agents:Vector.<Agent> = new Vector.<Agent>();
        private var _collisions:CollisionBlocks;
        private var _blocks:DetectionBlocks;
        private var _turtle:Agent;

        [Before]
        public function begin():void
        {
            var greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube());
            _collisions = new CollisionBlocks(greatLand, _agents);
            _blocks = new DetectionBlocks(_collisions);
            _turtle = add("turtles", 0);
            add("turtles", 0.8).color = 10;
            add("wolves", 3).color = 20;
            add("wolves", 5).color = 10;
            add("wolves", -7).color = 10;
            _blocks.update();
        }

        [Test]
        public function countsAndFinds():void
        {
            assertEquals(1, _blocks.countWithin(_turtle, "wolves", 3));
            assertEquals(0, _blocks.countWithin(_turtle, "wolves", 2.9));
            assertEquals(3, _blocks.countWithin(_turtle, Collision.ANY_BREED, 5));
            assertEquals(0, _blocks.countWithin(_turtle, "sheep", 50));
            assertEquals(2, _blocks.countWith(_turtle, "wolves", "color", 10));
            assertEquals(3, _blocks.countWith(_turtle, Collision.ANY_BREED, "color", 10));
            assertEquals(_agents[2], _blocks.nearestWithin(_turtle, "wolves", 100));
            assertNull(_blocks.nearestWithin(_turtle, "wolves", 1));
            assertEquals(_agents[3], _blocks.nearestWith(_turtle, "wolves", "color", 10));
            assertNull(_blocks.nearestWith(_turtle, "wolves", "color", 11));
        }

        /** A warning that is said is not said again. */
        [Test]
        public function breedsThatAreProbablyMisspelledAreTold():void
        {
            assertEquals(0, _blocks.countWithin(_turtle, "wovles", 5));
            assertFalse(_blocks.isTouching(_turtle, "wolvesz"));
            new WalkBlocks(_blocks).setSolid("turltes", true);
            new TraitBlocks(_agents).setHierarchical("wolvse", true);
            new StructureBlocks(_collisions).show("wolfes", true);
            assertFalse(warn("no agent is of the breed \"wovles\"; is \"wolves\" meant?"));
            assertFalse(warn("no agent is of the breed \"wolvesz\"; is \"wolves\" meant?"));
            assertFalse(warn("no agent is of the breed \"turltes\"; is \"turtles\" meant?"));
            assertFalse(warn("no agent is of the breed \"wolvse\"; is \"wolves\" meant?"));
            assertFalse(warn("no agent is of the breed \"wolfes\"; is \"wolves\" meant?"));
        }

        [Test]
        public function looksAhead():void
        {
            assertEquals(_agents[2], _blocks.ahead(_turtle, "wolves", 4));
            assertClose(2, _blocks.distanceAhead(_turtle, "wolves", 4), 1e-9);
            assertNull("it is farther", _blocks.ahead(_turtle, "wolves", 1.9));
            assertEquals(Infinity, _blocks.distanceAhead(_turtle, "wolves", 1.9));
            assertEquals("it would go into this one at once", _agents[1], _blocks.ahead(_turtle, Collision.ANY_BREED, 1));
            assertEquals(0, _blocks.distanceAhead(_turtle, Collision.ANY_BREED, 1));
            _turtle.heading = 180;
            assertEquals(_agents[4], _blocks.ahead(_turtle, Collision.ANY_BREED, 10));
            _turtle.heading = 90;
            assertNull(_blocks.ahead(_turtle, Collision.ANY_BREED, 100));
            _turtle.heading = 0;
            assertThrows(BlockError, /"ahead" needs an agent/, _blocks.ahead, null, "wolves", 1);
            assertThrows(BlockError, /"ahead" needs the name of a breed/, _blocks.ahead, _turtle, "", 1);
            assertThrows(BlockError, /"distance ahead" needs a distance of 0 or more, but got -1/, _blocks.distanceAhead, _turtle, "wolves", -1);
            assertThrows(BlockError, /"ahead" needs a number up to 1000000000 for the distance, but got Infinity/, _blocks.ahead, _turtle, "wolves", Infinity);
            assertThrows(BlockError, /"distance ahead" needs a number up to 1000000000 for the distance, but got 1e\+300/, _blocks.distanceAhead, _turtle, "wolves", 1e300);
        }

        [Test]
        public function theGroundIsNotAnyone():void
        {
            _collisions.collision.terrain = new Terrain(41, 41, 1, -20, -20);
            _blocks.update();
            assertTrue(_blocks.isTouching(_turtle, Collision.TERRAIN));
            assertTrue(_blocks.isTouching(_turtle, _collisions.collision.terrain.agent));
            assertEquals(4, _blocks.countWithin(_turtle, Collision.ANY_BREED, 50));
            assertEquals(3, _blocks.countWith(_turtle, Collision.ANY_BREED, "color", 10));
            assertEquals(_agents[1], _blocks.nearestWithin(_turtle, Collision.ANY_BREED, 50));
            _turtle.moveTo(0, 9, 0);
            assertFalse(_blocks.isTouching(_turtle, Collision.ANY_BREED));
        }

        [Test]
        public function touchesTheEdges():void
        {
            assertFalse("there are none", _blocks.isTouching(_turtle, Collision.EDGE));
            _collisions.collision.bounds = new WorldBounds(_turtle.x, -100, -100, 100, 100, 100);
            assertTrue(_blocks.isTouching(_turtle, Collision.EDGE));
            assertTrue(_blocks.isTouching(_turtle, _collisions.collision.bounds.agent));
            assertFalse(_blocks.isTouching(_agents[3], Collision.EDGE));
        }

        /** They have no place, from which one could ask. */
        [Test]
        public function theGroundAsksNothing():void
        {
            var ground:Agent = new Terrain(5, 5, 1, -2, -2).agent;
            for each (var ask:Function in [_blocks.countWithin, _blocks.nearestWithin, _blocks.ahead, _blocks.distanceAhead])
            {
                assertThrows(BlockError, /needs an agent, but got the ground or the edges of the world\.$/, ask, ground, "wolves", 1);
            }
            assertThrows(BlockError, /"can see\?" needs an agent, but got the ground/, _blocks.canSee, _turtle, ground);
            assertThrows(BlockError, /"can see\?" needs an agent, but got the ground/, _blocks.canSee, ground, _turtle);
        }

        [Test]
        public function touchesAsTheCollisionSystemSays():void
        {
            assertTrue(_blocks.isTouching(_turtle, "turtles"));
            assertTrue(_blocks.isTouching(_turtle, _agents[1]));
            assertFalse(_blocks.isTouching(_turtle, "wolves"));
            assertFalse(_blocks.isTouching(_turtle, _agents[2]));
            // on a corner of the cube there is no sphere
            _turtle.moveTo(0, 0.9, 0);
            assertTrue(_blocks.isTouching(_turtle, _agents[1]));
            assertEquals(0, _blocks.distanceTo(_turtle, _agents[1]));
            assertEquals(2, Math.round(_blocks.distanceTo(_turtle, _agents[2]) * 1e9) / 1e9);
            _collisions.useCollisionSystem(CollisionBlocks.UNIT_SPHERES);
            _blocks.update();
            assertFalse(_blocks.isTouching(_turtle, _agents[1]));
            _collisions.useCollisionSystem(CollisionBlocks.EXACT);
            assertFalse("not before the next update", _blocks.isTouching(_turtle, _agents[1]));
            _blocks.update();
            assertTrue(_blocks.isTouching(_turtle, _agents[1]));
        }

        /** So "distance to" is 0 for the same pairs. */
        [Test]
        public function touchesAnAgentThatIsNewInThisFrame():void
        {
            var born:Agent = new Agent("cube", "wolves");
            assertTrue(_blocks.isTouching(_turtle, born));
            assertTrue(_blocks.isTouching(born, _turtle));
            assertEquals(0, _blocks.distanceTo(_turtle, born));
            born.x = 2;
            assertFalse(_blocks.isTouching(_turtle, born));
            assertFalse("nobody touches itself", _blocks.isTouching(_turtle, _turtle));
            _collisions.collision.terrain = new Terrain(5, 5, 1, -2, -2);
            var bounds:WorldBounds = _collisions.collision.bounds = new WorldBounds(-5, -5, -5, 5, 5, 5);
            assertFalse("what is no agent of the game", _blocks.isTouching(bounds.agent, _collisions.collision.terrain.agent));
        }

        [Test]
        public function seesWhatNoAgentIsInFrontOf():void
        {
            assertTrue(_blocks.canSee(_turtle, _agents[1]));
            assertFalse(_blocks.canSee(_turtle, _agents[2]));
            assertTrue(_blocks.canSee(_turtle, _agents[4]));
            _agents[1].y = 9;
            assertFalse("not before the next update", _blocks.canSee(_turtle, _agents[2]));
            _blocks.moved(_agents[1]);
            assertTrue(_blocks.canSee(_turtle, _agents[2]));
            assertFalse(_blocks.canSee(_turtle, _agents[3]));
        }

        [Test]
        public function aTraitMayAskAnotherQuestion():void
        {
            var asking:AskingAgent = new AskingAgent("sphere", "dogs", _blocks);
            asking.moveTo(1, 0, 0);
            _agents.unshift(asking);
            var other:AskingAgent = new AskingAgent("sphere", "dogs", _blocks);
            other.moveTo(2, 0, 0);
            _agents.push(other);
            _blocks.update();
            var asker:AskingAgent = new AskingAgent("sphere", "wolves", _blocks);
            assertEquals(2, _blocks.countWith(asker, "dogs", "hunger", 10));
            assertEquals(asking, _blocks.nearestWith(asker, "dogs", "hunger", 10));
            assertEquals(0, _blocks.countWith(asker, "dogs", "hunger", 20));
            assertTrue(asking.asked > 2);
        }

        [Test]
        public function theBreedHasTheTraitNotWhoAsks():void
        {
            assertEquals("no agent of the breed is there", 0, _blocks.countWith(_turtle, "dogs", "hunger", 0));
            assertNull(_blocks.nearestWith(_turtle, "dogs", "hunger", 0));
            var dog:AskingAgent = new AskingAgent("sphere", "dogs", _blocks);
            _agents.push(dog);
            _blocks.update();
            assertEquals(1, _blocks.countWith(_turtle, "dogs", "hunger", 10));
            assertEquals(dog, _blocks.nearestWith(_turtle, "dogs", "hunger", 10));
            assertEquals(dog, _blocks.nearestWith(_turtle, Collision.ANY_BREED, "hunger", 10));
            var message:RegExp = /with" does not know the trait "hunger": no agent of the breed "wolves" has it\. Check/;
            assertThrows(BlockError, message, _blocks.countWith, dog, "wolves", "hunger", 10);
            assertThrows(BlockError, message, _blocks.nearestWith, dog, "wolves", "hunger", null);
            assertThrows(BlockError, /"count with" does not know the trait "hungre": no agent has it\. Check/, _blocks.countWith, dog, Collision.ANY_BREED, "hungre", 10);
        }

        [Test]
        public function agentsWithoutATraitDoNotMatch():void
        {
            var dog:AskingAgent = new AskingAgent("sphere", "wolves", _blocks);
            _agents.push(dog);
            _blocks.update();
            assertEquals(1, _blocks.countWith(_turtle, "wolves", "hunger", 10));
            assertEquals(0, _blocks.countWith(_turtle, "wolves", "hunger", undefined));
            assertNull(_blocks.nearestWith(_turtle, "wolves", "hunger", null));
        }

        [Test]
        public function othersAreWhereTheFrameBegan():void
        {
            assertEquals(1, _blocks.countWithin(_turtle, "wolves", 3));
            _agents[2].x = 50;
            assertEquals(1, _blocks.countWithin(_turtle, "wolves", 3));
            _blocks.moved(_agents[2]);
            assertEquals(0, _blocks.countWithin(_turtle, "wolves", 3));
            _turtle.x = 50;
            assertEquals(1, _blocks.countWithin(_turtle, "wolves", 3));
            _agents[2].x = 0;
            _blocks.update();
            assertEquals(0, _blocks.countWithin(_turtle, "wolves", 3));
        }

        [Test]
        public function tellsStudentsWhatIsWrong():void
        {
            assertThrows(BlockError, /"count within" needs an agent, but got nothing/, _blocks.countWithin, null, "wolves", 1);
            assertThrows(BlockError, /"count within" needs the name of a breed/, _blocks.countWithin, _turtle, "", 1);
            assertThrows(BlockError, /"count within" needs a distance of 0 or more, but got -1/, _blocks.countWithin, _turtle, "wolves", -1);
            assertThrows(BlockError, /"nearest within" needs a distance of 0 or more, but got NaN/, _blocks.nearestWithin, _turtle, "wolves", NaN);
            assertThrows(BlockError, /"count with" does not know the trait "colour": no agent of the breed "wolves" has it\. Check how it is spelled\. An agent has breed, shape, size, /, _blocks.countWith, _turtle, "wolves", "colour", 1);
            assertThrows(BlockError, /"nearest with" does not know the trait nothing/, _blocks.nearestWith, _turtle, "wolves", null, 1);
            assertThrows(BlockError, /"touching\?" needs an agent or a breed, but got nothing/, _blocks.isTouching, _turtle, null);
            assertThrows(BlockError, /"can see\?" needs an agent, but got nothing/, _blocks.canSee, null, _turtle);
            assertThrows(BlockError, /"can see\?" needs another agent, but got nothing/, _blocks.canSee, _turtle, null);
            assertThrows(BlockError, /"can see\?" needs another agent, but got the same/, _blocks.canSee, _turtle, _turtle);
            assertThrows(BlockError, /"distance to" needs another agent, but got nothing/, _blocks.distanceTo, _turtle, null);
            assertThrows(BlockError, /"distance to" needs another agent, but got the same/, _blocks.distanceTo, _turtle, _turtle);
            assertThrows(ArgumentError, /collisions must not be null/, create, DetectionBlocks, null);
        }

        private function add(breed:String, x:Number):Agent
        {
            var agent:Agent = new Agent("cube", breed);
            agent.x = x;
            _agents.push(agent);
            return agent;
        }
    }
}

import starlogo.agents.Agent;
import starlogo.blocks.DetectionBlocks;

class AskingAgent extends Agent
{
    public var asked:int = 0;
    private var _blocks:DetectionBlocks;

    public function AskingAgent(shape:String, breed:String, blocks:DetectionBlocks)
    {
        super(shape, breed);
        _blocks = blocks;
    }

    public function get hunger():Number
    {
        asked++;
        return 10 * _blocks.countWith(this, "turtles", "color", 10);
    }
}
