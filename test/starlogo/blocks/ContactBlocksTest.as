package starlogo.blocks
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Contact;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.OwnVectorSystem;
    import support.assertClose;
    import support.assertThrows;
    import support.create;
    import support.landOf;

    public class ContactBlocksTest
    {
        private var _agents:Vector.<Agent> = new <Agent>[];
        private var _collisions:CollisionBlocks;
        private var _blocks:ContactBlocks;
        private var _bear:Agent = new Agent("cube", "bears");
        private var _wall:Agent = new Agent("cube", "walls");

        [Before]
        public function begin():void
        {
            _collisions = new CollisionBlocks(landOf(BuiltInModel.cube()), _agents);
            _blocks = new ContactBlocks(_collisions);
            _agents.push(_bear, _wall);
        }

        [Test]
        public function tellsTheSideFromTheHeading():void
        {
            var places:Array = [[0.9, 0, 0], [-0.9, 0, 0], [0, 0.9, 0], [0, -0.9, 0], [0, 0, 0.9], [0, 0, -0.9]];
            var expected:Array = ["front", "back", "left", "right", "top", "bottom"];
            for (var i:int = 0; i < 6; i++)
            {
                _wall.moveTo(places[i][0], places[i][1], places[i][2]);
                _collisions.collision.update(_agents);
                assertEquals(expected[i], _blocks.sideHit(_bear, _wall));
            }
            _bear.heading = 90;
            _wall.moveTo(0.9, 0, 0);
            _collisions.collision.update(_agents);
            assertEquals("right", _blocks.sideHit(_bear, _wall));
            assertEquals("back", _blocks.sideHit(_wall, _bear));
            assertEquals(expected.toString(), ContactBlocks.sideNames.toString());
        }

        [Test]
        public function neitherTheGroundNorTheEdgesArePushed():void
        {
            _collisions.collision.terrain = new Terrain(11, 11, 1, -5, -5);
            _collisions.collision.bounds = new WorldBounds(-5, -5, -5, 5, 5, 5);
            _bear.moveTo(0, 4.8, -0.3);
            for each (var agent:Agent in [_collisions.collision.terrain.agent, _collisions.collision.bounds.agent])
            {
                assertThrows(BlockError, /"push away from" needs an agent, but got the ground or the edges of the world\.$/, _blocks.pushAway, agent, _bear);
                assertEquals(0, agent.z);
            }
            _blocks.pushAway(_bear, _collisions.collision.terrain.agent);
            assertClose(0, _bear.z, 1e-9);
        }

        [Test]
        public function tellsTheFirstOfTwoSidesThatAreEquallyNear():void
        {
            var headings:Array = [45, -45, 135, 225];
            var expected:Array = ["front", "front", "back", "back"];
            _wall.moveTo(1.1, 0, 0);
            for (var i:int = 0; i < 4; i++)
            {
                _bear.heading = headings[i];
                _collisions.collision.update(_agents);
                assertEquals("heading " + headings[i], expected[i], _blocks.sideHit(_bear, _wall));
            }
        }

        [Test]
        public function aScriptThatExchangesTheSystemStillAsksAboutItsFrame():void
        {
            // the cubes touch, and the spheres do not
            _wall.size = 2;
            _wall.moveTo(1.4, 0.5, 0.6);
            var calls:int = 0;
            _collisions.onCollision("bears", "walls", function(bear:Agent, wall:Agent, contact:Contact):void
                {
                    calls++;
                    _collisions.useCollisionSystem(CollisionBlocks.UNIT_SPHERES);
                    assertEquals(contact.point.toString(), _blocks.touchPoint(bear, wall).toString());
                    _blocks.pushAway(bear, wall);
                    assertClose(-0.1, bear.x, 1e-9);
                });
            _collisions.collision.update(_agents);
            assertEquals(1, calls);
            _bear.moveTo(0, 0, 0);
            _collisions.collision.update(_agents);
            assertEquals("the spheres do not touch", 1, calls);
        }

        [Test]
        public function tellsPointAndSpeed():void
        {
            _bear.sweeps = true;
            _wall.moveTo(3, 0, 0);
            var speeds:Vector.<Number> = new <Number>[];
            _collisions.onCollision("bears", "walls", function(bear:Agent, wall:Agent, contact:Contact):void
                {
                    speeds.push(_blocks.touchSpeed(bear, wall), _blocks.touchPoint(bear, wall, new Vector3D()).x);
                });
            _collisions.collision.update(_agents);
            _bear.moveTo(2.5, 0, 0);
            _collisions.collision.update(_agents);
            assertEquals(2, speeds.length);
            assertClose(2.5, speeds[0], 1e-9);
            assertClose(2.5, speeds[1], 1e-6);
            assertClose(0, _blocks.touchPoint(_bear, _wall).y, 1e-6);
        }

        [Test]
        public function pushesOutByTheShortestWay():void
        {
            _wall.moveTo(0.7, 0.1, 0);
            _collisions.collision.update(_agents);
            _bear.moveTo(0, 0.9, 0);
            _blocks.pushAway(_bear, _wall);
            assertClose(0, _bear.x, 1e-9);
            assertClose(1.1, _bear.y, 1e-9, "where it is now, not where the frame saw it");
            _bear.moveTo(-5, 0, 0);
            _blocks.pushAway(_bear, _wall);
            assertEquals(-5, _bear.x);
        }

        [Test]
        public function pushesAwayWithTheSettingsOfTheGame():void
        {
            // the roots' boxes overlap, the leaves' boxes do not
            var greatLand:GreatLand = landOf(new Model("corner", cornerVertices()));
            var collisions:CollisionBlocks = new CollisionBlocks(greatLand, _agents);
            var blocks:ContactBlocks = new ContactBlocks(collisions);
            var corner:Agent = new Agent("corner");
            var other:Agent = new Agent("corner");
            other.moveTo(0.3, 0.3, 0);
            collisions.useCollisionSystem(CollisionBlocks.HIERARCHIES);
            blocks.pushAway(corner, other);
            assertEquals("no boxes touch", 0, Math.abs(corner.x) + Math.abs(corner.y));
            var system:HierarchicalCollider = HierarchicalCollider(collisions.systemNamed(CollisionBlocks.HIERARCHIES));
            system.maxDepth = 1;
            assertTrue("the roots do", system.areColliding(corner, other));
            blocks.pushAway(corner, other);
            assertTrue("so they part", Math.abs(corner.x) + Math.abs(corner.y) > 0.1);
            system.maxDepth = 5;
            corner.moveTo(0, 0, 0);
            blocks.pushAway(corner, other);
            assertEquals("at once", 0, Math.abs(corner.x) + Math.abs(corner.y));
        }

        // Points of two walls along two edges of a square, one high.
        private static function cornerVertices():Vector.<Number>
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i <= 64; i++)
            {
                vertices.push(i / 64, 0, 0, 0, i / 64, 0, i / 64, 0, 1, 0, i / 64, 1);
            }
            return vertices;
        }

        [Test]
        public function aSystemMayReturnNoContactObject():void
        {
            _wall.moveTo(0.9, 0, 0);
            _collisions.collision.collisionSystem = new NullContactBins();
            _collisions.collision.update(_agents);
            assertEquals("left", _blocks.sideHit(_bear, _wall));
            assertEquals(0, _blocks.touchSpeed(_bear, _wall));
            assertEquals(3, _blocks.touchPoint(_bear, _wall).x);
        }

        [Test]
        public function tellsStudentsWhatIsWrong():void
        {
            assertThrows(BlockError, /"side that was hit" needs another agent, but got nothing\. Remember: "collidee"/, _blocks.sideHit, _bear, null);
            assertThrows(BlockError, /"touch point" needs an agent/, _blocks.touchPoint, null, _bear);
            assertThrows(BlockError, /"touch speed" needs another agent, but got the same/, _blocks.touchSpeed, _bear, _bear);
            assertThrows(BlockError, /"push away from" needs another agent/, _blocks.pushAway, _bear, null);
            assertThrows(ArgumentError, "collisions", create, ContactBlocks, null);
            var stranger:Agent = new Agent("rabbit");
            assertThrows(BlockError, /"side that was hit" does not know the shape of an agent yet: .* there is no model "rabbit"/, _blocks.sideHit, _bear, stranger);
            assertThrows(BlockError, /"push away from" does not know the shape of an agent yet/, _blocks.pushAway, _bear, stranger);
            _collisions.collision.collisionSystem = new OwnVectorSystem(_agents);
            assertThrows(BlockError, /"push away from" does not work with a collision system of the game's own\.$/, _blocks.pushAway, _bear, _wall);
        }
    }
}

import starlogo.agents.Agent;
import starlogo.collision.BaseCollider;
import starlogo.collision.BinCollider;
import starlogo.collision.Contact;

/** Sets the contact that it gets, and returns none. */
final class NullContactBins extends BaseCollider
{
    public function NullContactBins()
    {
        super(new BinCollider());
    }

    override public function contactOf(collider:Agent, collidee:Agent, out:Contact = null):Contact
    {
        out.point.x = 3;
        out.normal.setTo(0, -1, 0);
        return null;
    }
}
