package starlogo.blocks
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentFilter;
    import support.assertThrows;
    import support.create;
    import support.landOf;

    public class CollisionBlocksTest
    {
        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube());

        private var _agents:Vector.<Agent> = new <Agent>[];
        private var _blocks:CollisionBlocks = new CollisionBlocks(_greatLand, _agents);
        private var _calls:Array = [];

        [Test]
        public function collisionsCallTheirScripts():void
        {
            var bear:Agent = agentOf("cube", "bears", 0);
            var ball:Agent = agentOf("sphere", "balls", 0.5);
            agentOf("sphere", "balls", 9);
            _blocks.onCollision("bears", "balls", function(collider:Agent, collidee:Agent):void
                {
                    _calls.push(collider, collidee);
                });
            _blocks.collision.update(_agents);
            assertEquals(2, _calls.length);
            assertStrictlyEquals(bear, _calls[0]);
            assertStrictlyEquals(ball, _calls[1]);
        }

        [Test]
        public function theSystemDecides():void
        {
            // at the cube's corner: in the cube, beyond the unit sphere
            agentOf("cube", "bears", 0);
            var ball:Agent = agentOf("sphere", "balls", 0.49);
            ball.size = 0.1;
            ball.y = 0.49;
            _blocks.onCollision("bears", "balls", note("hit"));
            for each (var name:String in CollisionBlocks.systemNames)
            {
                _blocks.useCollisionSystem(name);
                _calls.length = 0;
                _blocks.collision.update(_agents);
                assertEquals(name, name == CollisionBlocks.UNIT_SPHERES ? 0 : 1, _calls.length);
                assertEquals(name, _blocks.systemName);
            }
        }

        [Test]
        public function namesStandForSystems():void
        {
            assertEquals(5, CollisionBlocks.systemNames.length);
            assertTrue(_blocks.systemNamed(CollisionBlocks.UNIT_SPHERES) is BinCollider);
            assertTrue(_blocks.systemNamed(CollisionBlocks.TIGHTEST_FITS) is TightestFitCollider);
            assertTrue(_blocks.systemNamed(CollisionBlocks.COMBINATION) is CombinationCollider);
            assertTrue(!HierarchicalCollider(_blocks.systemNamed(CollisionBlocks.HIERARCHIES)).exact);
            assertTrue(HierarchicalCollider(_blocks.systemNamed(CollisionBlocks.EXACT)).exact);
            assertStrictlyEquals(_blocks.systemNamed(CollisionBlocks.EXACT), _blocks.systemNamed(CollisionBlocks.EXACT));
        }

        [Test]
        public function theCollisionItsSystemAndItsFilterStayWhenScriptsAreForgotten():void
        {
            agentOf("cube", "bears", 0);
            agentOf("sphere", "balls", 0.5);
            agentOf("sphere", "ghosts", 0.5);
            _blocks.useCollisionSystem(CollisionBlocks.EXACT);
            var collision:Collision = _blocks.collision;
            collision.filter = AgentFilter.ofBreeds("bears", "balls");
            _blocks.whenTouchingStarts("bears", Collision.ANY_BREED, note("start"));
            _blocks.whenTouchingEnds("bears", Collision.ANY_BREED, note("end"));
            collision.update(_agents);
            assertEquals("start", _calls.join());
            _blocks.forgetScripts();
            assertStrictlyEquals(collision, _blocks.collision);
            assertStrictlyEquals(_blocks.systemNamed(CollisionBlocks.EXACT), collision.collisionSystem);
            _calls.length = 0;
            assertEquals(0, collision.lastAgents.length);
            collision.update(_agents);
            assertEquals("no script is left", 0, _calls.length);
            _blocks.forgetScripts();
            collision.restore(collision.snapshot(), new Vector.<Agent>());
            // touches begin anew, and of those of before no end is told
            _blocks.whenTouchingStarts("bears", Collision.ANY_BREED, note("again"));
            _blocks.whenTouchingEnds("bears", Collision.ANY_BREED, note("end"));
            _agents.reverse();
            collision.update(_agents);
            assertEquals("again", _calls.join());
            assertEquals(1, collision.statistics.agentsSkipped);
        }

        [Test]
        public function aScriptMayForgetAllScripts():void
        {
            agentOf("cube", "bears", 0);
            agentOf("sphere", "balls", 0.5);
            _blocks.whenTouchingStarts("bears", "balls", function(collider:Agent, collidee:Agent):void
                {
                    _calls.push("forget");
                    _blocks.forgetScripts();
                });
            _blocks.onCollision("bears", "balls", note("not any more"));
            _blocks.collision.update(_agents);
            _blocks.collision.update(_agents);
            assertEquals("forget", _calls.join());
            _blocks.whenTouchingStarts("bears", "balls", note("again"));
            _blocks.collision.update(_agents);
            assertEquals("forget,again", _calls.join());
        }

        [Test]
        public function theNameIsThatOfTheSystemInUse():void
        {
            _blocks.collision.collisionSystem = _blocks.systemNamed(CollisionBlocks.EXACT);
            assertEquals(CollisionBlocks.EXACT, _blocks.systemName);
            _blocks.collision.collisionSystem = new BinCollider();
            assertNull(_blocks.systemName);
        }

        [Test]
        public function wrongUsesSaySo():void
        {
            assertThrows(BlockError, /^The block "use collision system" does not know "sphers"\. Choose one of these: unit spheres, tight/,
                    _blocks.useCollisionSystem, "sphers");
            assertThrows(BlockError, /^The block "use collision system" does not know nothing|got nothing/, _blocks.useCollisionSystem, null);
            assertEquals(CollisionBlocks.TIGHTEST_FITS, _blocks.systemName);
            assertThrows(BlockError, /^The block "on collision with" needs the name of a breed, but got nothing\.$/, _blocks.onCollision, "", "a", note(""));
            assertThrows(BlockError, /^The block "when touching starts" needs the name/, _blocks.whenTouchingStarts, "a", null, note(""));
            assertThrows(BlockError, /^The block "when touching ends" has nothing to do: put blocks/, _blocks.whenTouchingEnds, "a", "b", null);
            assertThrows(ArgumentError, /GreatLand/, create, CollisionBlocks, null, _agents);
        }

        [Test]
        public function theErrorNamesTheBlock():void
        {
            try
            {
                _blocks.useCollisionSystem("x");
            }
            catch (error:BlockError)
            {
                assertEquals("use collision system", error.block);
                assertEquals("BlockError", error.name);
                return;
            }
            assertTrue("nothing was thrown", false);
        }

        private function note(what:String):Function
        {
            return function(collider:Agent, collidee:Agent):void
            {
                _calls.push(what);
            };
        }

        private function agentOf(shape:String, breed:String, x:Number):Agent
        {
            var agent:Agent = new Agent(shape, breed);
            agent.x = x;
            _agents.push(agent);
            return agent;
        }
    }
}
