package starlogo.blocks
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.assertClose;
    import support.assertThrows;
    import support.create;
    import support.landOf;

    public class TerrainBlocksTest
    {
        private var _terrain:Terrain = new Terrain(11, 11, 1, -5, -5);
        private var _collisions:CollisionBlocks;
        private var _detection:DetectionBlocks;
        private var _blocks:TerrainBlocks;
        private var _turtle:Agent = new Agent("cube");

        [Before]
        public function begin():void
        {
            var greatLand:GreatLand = landOf(BuiltInModel.cube());
            _collisions = new CollisionBlocks(greatLand, new <Agent>[]);
            _detection = new DetectionBlocks(_collisions);
            _blocks = new TerrainBlocks(_collisions, _detection);
            _collisions.collision.terrain = _terrain;
        }

        [Test]
        public function buildsWhereTheAgentIs():void
        {
            _turtle.moveTo(2.4, -1.4, 30);
            _blocks.buildWall(_turtle, 3);
            _blocks.buildWall(_turtle, -0.5);
            assertEquals(2.5, _terrain.heightAt(2, -1));
            assertEquals(0, _terrain.heightAt(3, -1));
            _turtle.moveTo(-2, 1, 0);
            _blocks.buildMound(_turtle, 4, 2);
            assertEquals(2, _terrain.heightAt(-2, 1));
            assertEquals("half of the way to the border", 2 * 0.75 * 0.75, _terrain.heightAt(-1, 1));
            assertEquals(0, _terrain.heightAt(0, 1));
            _blocks.resetTerrain();
            assertEquals(0, _terrain.heightAt(2, -1));
            assertEquals(0, _terrain.heightAt(-2, 1));
        }

        [Test]
        public function raisesTheGroundWithoutAnAgent():void
        {
            _blocks.raiseGround(2.4, -1.4, 3);
            _blocks.raiseGround(2, -1, -0.5);
            assertEquals(2.5, _terrain.heightAt(2, -1));
            assertEquals(0, _terrain.heightAt(3, -1));
            assertThrows(BlockError, /"raise the ground" cannot build here: a terrain's height must be .*, not NaN\.$/, _blocks.raiseGround, 0, 0, NaN);
            assertThrows(BlockError, /"raise the ground" cannot build here: .*NaN/, _blocks.raiseGround, NaN, 0, 1);
            assertThrows(BlockError, /"raise the ground" cannot build here: a wall at \(6, 0\) is outside of the terrain\.$/, _blocks.raiseGround, 6, 0, 1);
            _collisions.collision.terrain = null;
            assertThrows(BlockError, /"raise the ground" needs a terrain, but this game has none/, _blocks.raiseGround, 0, 0, 1);
        }

        [Test]
        public function tellsTheHeight():void
        {
            _terrain.setHeight(6, 5, 4);
            _turtle.moveTo(0.25, 0, 7);
            assertEquals(1, _blocks.terrainHeight(_turtle));
            _terrain.isBlocky = true;
            assertEquals(0, _blocks.terrainHeight(_turtle));
            _turtle.x = 0.75;
            assertEquals(4, _blocks.terrainHeight(_turtle));
            _turtle.x = 50;
            assertEquals("outside", 0, _blocks.terrainHeight(_turtle));
        }

        [Test]
        public function touchesTheGroundAsTheCollisionSystemSays():void
        {
            for each (var system:String in CollisionBlocks.systemNames.slice(0, 4))
            {
                _collisions.useCollisionSystem(system);
                _blocks.resetTerrain();
                _detection.update();
                _turtle.moveTo(0, 0, 0.1);
                assertFalse(system, _blocks.isTouchingGround(_turtle));
                _turtle.z = 0;
                assertTrue(system, _blocks.isTouchingGround(_turtle));
                _turtle.z = -30;
                assertTrue(system + ": in the ground", _blocks.isTouchingGround(_turtle));
                _turtle.z = 2;
                _blocks.buildWall(_turtle, 2.5);
                assertTrue(system + ": it came to the agent", _blocks.isTouchingGround(_turtle));
                // a needle comes to the corner of the cube, where there is no sphere
                _blocks.resetTerrain();
                _turtle.moveTo(-0.48, -0.48, 0.9);
                _terrain.setHeight(5, 5, 1);
                assertEquals(system, system != CollisionBlocks.UNIT_SPHERES, _blocks.isTouchingGround(_turtle));
                _turtle.moveTo(50, 0, 0);
                assertFalse(system + ": outside", _blocks.isTouchingGround(_turtle));
            }
        }

        [Test]
        public function touchesTheEdgesAsTheCollisionSystemSays():void
        {
            _turtle.moveTo(50.1, 0, 0);
            assertFalse("there are none", _blocks.isTouchingEdge(_turtle));
            _collisions.collision.bounds = new WorldBounds(-50.5, -50.5, -Infinity, 50.5, 50.5, Infinity);
            for each (var system:String in CollisionBlocks.systemNames.slice(0, 4))
            {
                _collisions.useCollisionSystem(system);
                _detection.update();
                _turtle.moveTo(49.9, 0, -1e6);
                assertFalse(system, _blocks.isTouchingEdge(_turtle));
                _turtle.x = 50;
                assertTrue(system, _blocks.isTouchingEdge(_turtle));
                _turtle.moveTo(0, -900, 0);
                assertTrue(system + ": beyond", _blocks.isTouchingEdge(_turtle));
                // its corners reach farther than a sphere
                _turtle.moveTo(49.9, 0, 0);
                _turtle.heading = 45;
                assertEquals(system, system != CollisionBlocks.UNIT_SPHERES, _blocks.isTouchingEdge(_turtle));
                _turtle.heading = 0;
            }
        }

        [Test]
        public function stopsBouncesAndWrapsAtTheEdges():void
        {
            _detection.update();
            for each (var block:Array in [["edge I touch", _blocks.edgeTouched], ["stop at the edge", _blocks.stopAtEdge], ["bounce off the edge", _blocks.bounceOffEdge],
                        ["wrap at the edge", _blocks.wrapAtEdge]])
            {
                assertThrows(BlockError, new RegExp("\"" + block[0] + "\" needs edges of the world, but this game has none\\."), block[1], _turtle);
            }
            _collisions.collision.bounds = new WorldBounds(-5, -5, -1, 5, 5, 9);
            assertNull(_blocks.edgeTouched(_turtle));
            var places:Array = [[4.8, 0, 1], [-4.8, 0, 1], [0, 4.8, 1], [0, -4.8, 1], [0, 0, 8.5], [0, 0, -1.2]];
            for (var i:int = 0; i < 6; i++)
            {
                _turtle.moveTo(places[i][0], places[i][1], places[i][2]);
                assertEquals(TerrainBlocks.edgeNames[i], _blocks.edgeTouched(_turtle));
            }
            _turtle.moveTo(4.8, -7, 1);
            _blocks.stopAtEdge(_turtle);
            assertClose(4.5, _turtle.x, 1e-9);
            assertClose(-4.5, _turtle.y, 1e-9);
            _turtle.moveTo(4.8, 0, 1);
            _turtle.heading = 30;
            _blocks.bounceOffEdge(_turtle);
            assertClose(150, _turtle.heading, 1e-9);
            _blocks.bounceOffEdge(_turtle);
            assertClose(150, _turtle.heading, 1e-9, "it is headed into the world");
            _turtle.heading = 0;
            _turtle.moveTo(5.5, -5.25, 1);
            _blocks.wrapAtEdge(_turtle);
            assertClose(-4.5, _turtle.x, 1e-9);
            assertClose(4.75, _turtle.y, 1e-9);
            assertEquals(1, _turtle.z);
        }

        // In a corner each edge mirrors the part of the heading that leads out at this edge, however deep the agent is beyond each.
        [Test]
        public function bouncesInCornersOffEachEdge():void
        {
            _detection.update();
            _collisions.collision.bounds = new WorldBounds(-5, -5, -1, 5, 5, 9);
            var places:Array = [[-4.55, -4.6, 1], [-4.6, 0, -1.2], [-4.6, 0, -1.1], [-4.6, -4.7, 1], [4.6, 4.7, 1], [4.6, -4.7, 1], [0, 0, -1.2]];
            var headings:Array = [180, 180, 180, 225, 30, 30, 77];
            var bounced:Array = [0, 0, 0, 45, 210, 150, 77];
            for (var i:int = 0; i < places.length; i++)
            {
                _turtle.moveTo(places[i][0], places[i][1], places[i][2]);
                _turtle.heading = headings[i];
                _blocks.bounceOffEdge(_turtle);
                assertClose(0, (_turtle.heading - bounced[i]) % 360, 1e-9, places[i]);
            }
        }

        [Test]
        public function aGameMayHaveNoGround():void
        {
            _detection.update();
            assertTrue(_blocks.isTouchingGround(_turtle));
            _collisions.collision.terrain = null;
            _detection.update();
            assertFalse(_blocks.isTouchingGround(_turtle));
            assertThrows(BlockError, /"build wall" needs a terrain, but this game has none/, _blocks.buildWall, _turtle, 1);
            assertThrows(BlockError, /"build mound" needs a terrain/, _blocks.buildMound, _turtle, 1, 1);
            assertThrows(BlockError, /"terrain height" needs a terrain/, _blocks.terrainHeight, _turtle);
            assertThrows(BlockError, /"reset terrain" needs a terrain/, _blocks.resetTerrain);
        }

        [Test]
        public function tellsStudentsWhatIsWrong():void
        {
            assertThrows(BlockError, /"build wall" needs an agent, but got nothing/, _blocks.buildWall, null, 1);
            assertThrows(BlockError, /"build mound" needs an agent/, _blocks.buildMound, null, 1, 1);
            assertThrows(BlockError, /"terrain height" needs an agent/, _blocks.terrainHeight, null);
            assertThrows(BlockError, /"touching ground\?" needs an agent/, _blocks.isTouchingGround, null);
            assertThrows(BlockError, /"edge I touch" needs an agent/, _blocks.edgeTouched, null);
            assertThrows(BlockError, /"stop at the edge" needs an agent/, _blocks.stopAtEdge, null);
            assertThrows(BlockError, /"bounce off the edge" needs an agent/, _blocks.bounceOffEdge, null);
            assertThrows(BlockError, /"wrap at the edge" needs an agent/, _blocks.wrapAtEdge, null);
            assertThrows(BlockError, /"touching edge\?" needs an agent/, _blocks.isTouchingEdge, null);
            assertThrows(BlockError, /"build wall" cannot build here: a terrain's height must be .*, not NaN\.$/, _blocks.buildWall, _turtle, NaN);
            assertThrows(BlockError, /"build mound" cannot build here: a mound's place and height must be .*, not Infinity\.$/, _blocks.buildMound, _turtle, 1, Infinity);
            assertThrows(BlockError, /"build mound" cannot build here: a mound's width must be more than 0, not 0\.$/, _blocks.buildMound, _turtle, 0, 1);
            assertThrows(BlockError, /"build mound" cannot build here: a mound's width must be .*, not NaN\.$/, _blocks.buildMound, _turtle, NaN, 1);
            assertThrows(BlockError, /"build wall" cannot build here: a terrain's height must be a finite number between.*, not 2000000000\.$/, _blocks.buildWall, _turtle, 2e9);
            _turtle.x = 6;
            assertThrows(BlockError, /"build wall" cannot build here: a wall at \(6, 0\) is outside of the terrain\.$/, _blocks.buildWall, _turtle, 1);
            _turtle.x = 9;
            assertThrows(BlockError, /"build mound" cannot build here: a mound of width 4 at \(9, 0\)/, _blocks.buildMound, _turtle, 4, 1);
            for each (var height:Number in [_terrain.heightAt(0, 0), _terrain.heightAt(5, 0)])
            {
                assertEquals("nothing was built", 0, height);
            }
            assertThrows(ArgumentError, /detection must not be null/, create, TerrainBlocks, _collisions, null);
        }
    }
}
