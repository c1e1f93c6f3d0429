package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.Garbage;
    import support.MemoryGrowth;
    import support.landOf;

    /**
     * Steady frames allocate nothing. The player collects no garbage while a test runs, so that whatever a frame allocates
     * makes the player's memory grow; see MemoryGrowth. Adobe's VM is asked with its collector off, and
     * tells every page of 4,096 bytes.
     */
    public class AllocationTest
    {
        private static const AGENTS:int = 200;

        // In bytes, for a frame and all agents together: four for each agent, where the smallest object takes more than
        // twenty. A call of a function that has closures allocates its scope: some 370 bytes a frame in Ruffle.
        private static const NOTHING:Number = 4 * AGENTS;

        // Adobe's VM: some pages in all, which are less than one object a frame, of 16 bytes; and for update what it tells the handlers
        private static const PAGES:Number = 3 * 4096;
        private static const UPDATE:Number = 256;

        // frames in which all turn about once, an even number: then they are where they were
        private static const TURN:int = 12;

        private var _frames:int = Garbage.isCounted ? 1000 : 4 * TURN;
        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder());
        private var _agents:Vector.<Agent> = new Vector.<Agent>();

        [Before]
        public function makeGame():void
        {
            var random:SeededRandom = new SeededRandom(41);
            for (var i:int = 0; i < AGENTS; i++)
            {
                var agent:Agent = new Agent(random.pick(["sphere", "cube", "cylinder"]), random.pick(["bears", "balls", "walls"]));
                agent.moveTo(random.between(-8, 8), random.between(-8, 8), random.between(0, 1));
                agent.size = random.pick([0.25, 1, 1, 3]);
                _agents.push(agent);
            }
        }

        [Test]
        public function theMeasureSeesOneSmallObjectAnAgent():void
        {
            var grown:Number = growth(function(i:int):void
                {
                    MemoryGrowth.makeObjects(AGENTS);
                });
            assertTrue("one object an agent and frame: " + grown + " bytes", grown > 20 * AGENTS * _frames);
        }

        [Test]
        public function binColliderAllocatesNothing():void
        {
            assertAllocatesNothing(new BinCollider(_greatLand));
        }

        [Test]
        public function tightestFitColliderAllocatesNothing():void
        {
            assertAllocatesNothing(new TightestFitCollider(_greatLand));
        }

        [Test]
        public function hullsAllocateNothing():void
        {
            _agents.length = 100;
            for (var i:int = 0; i < _agents.length; i++)
            {
                _agents[i].collideAs = i % 5 == 0 ? Agent.TIGHTEST : Agent.HULL;
                _agents[i].sweeps = i % 7 == 0;
                _agents[i].hierarchical = i % 11 == 0;
            }
            assertAllocatesNothing(new CombinationCollider(_greatLand));
        }

        [Test]
        public function hierarchicalColliderAllocatesNothing():void
        {
            _agents.length = 80;
            assertAllocatesNothing(new HierarchicalCollider(_greatLand));
        }

        [Test]
        public function exactHierarchicalColliderAllocatesNothing():void
        {
            _agents.length = 30;
            var collider:HierarchicalCollider = new HierarchicalCollider(_greatLand);
            collider.exact = true;
            assertAllocatesNothing(collider);
        }

        [Test]
        public function combinationColliderAllocatesNothing():void
        {
            _agents.length = 100;
            for (var i:int = 0; i < _agents.length; i += 7)
            {
                _agents[i].hierarchical = true;
            }
            assertAllocatesNothing(new CombinationCollider(_greatLand));
        }

        [Test]
        public function sweepingAllocatesNothing():void
        {
            _agents.length = 100;
            for (var i:int = 0; i < _agents.length; i++)
            {
                _agents[i].sweeps = i % 3 == 0;
                _agents[i].hierarchical = i % 10 == 0;
            }
            assertAllocatesNothing(new CombinationCollider(_greatLand));
        }

        [Test]
        public function contactsStartsAndEndsAllocateNothing():void
        {
            var collision:Collision = new Collision(new TightestFitCollider(_greatLand));
            var calls:int = 0;
            collision.onCollision("bears", "balls", takeContact);
            collision.onCollisionStart("bears", "walls", takeContact);
            collision.onCollisionEnd("bears", "walls", takeContact);
            var grown:Number = growth(function(i:int):void
                {
                    moveAll();
                    // an agent comes and goes in every frame
                    _agents[0].z = _agents[0].z == 0 ? 100 : 0;
                    collision.update(_agents);
                });
            assertTrue("handlers were called", calls > _frames);
            assertTrue(Math.round(grown) + " bytes in " + _frames + " frames", grown <= NOTHING * _frames);

            function takeContact(a:Agent, b:Agent, contact:Contact):void
            {
                calls++;
            }
        }

        [Test]
        public function framesOnTheGroundAllocateNothing():void
        {
            var worst:Number = 0;
            _agents.length = 60;
            for (var i:int = 0; i < _agents.length; i++)
            {
                _agents[i].sweeps = i % 3 == 0;
                _agents[i].hierarchical = i % 10 == 0;
            }
            for each (var system:CollisionSystem in [new BinCollider(_greatLand), new TightestFitCollider(_greatLand),
                        new HierarchicalCollider(_greatLand), new CombinationCollider(_greatLand)])
            {
                var collision:Collision = new Collision(system);
                collision.terrain = new Terrain(21, 21, 1, -10, -10);
                collision.terrain.raiseMound(2, 1, 12, 1);
                collision.bounds = new WorldBounds(-8, -8, -Infinity, 8, 8, Infinity);
                collision.onCollision("balls", Collision.EDGE, count);
                collision.onCollision("bears", Collision.TERRAIN, count);
                collision.onCollision("balls", Collision.TERRAIN, count);
                var calls:int = 0;
                var grown:Number = growth(function(i:int):void
                    {
                        moveAll();
                        collision.update(_agents);
                    });
                assertTrue("handlers were called: " + calls, calls > _frames);
                worst = Math.max(worst, grown);
            }

            assertTrue(Math.round(worst) + " bytes in " + _frames + " frames", worst <= _frames * (Garbage.isCounted ? UPDATE : NOTHING));

            function count(a:Agent, b:Agent):void
            {
                calls++;
            }
        }

        private function assertAllocatesNothing(collider:CollisionSystem):void
        {
            var collision:Collision = new Collision(collider);
            var calls:int = 0;
            collision.onCollision("bears", "bears", count);
            collision.onCollision("balls", "walls", count);
            var grown:Number = growth(function(i:int):void
                {
                    moveAll();
                    collision.update(_agents);
                });
            assertTrue("handlers were called", calls > _frames);
            assertTrue(Math.round(grown) + " bytes in " + _frames + " frames", grown <= _frames * (Garbage.isCounted ? UPDATE : NOTHING));
            if (Garbage.isCounted)
            {
                assertSearchAllocatesNothing(collider);
            }

            function count(a:Agent, b:Agent):void
            {
                calls++;
            }
        }

        private function assertSearchAllocatesNothing(collider:CollisionSystem):void
        {
            var found:Vector.<Agent> = new Vector.<Agent>();
            var grown:Number = growth(function(i:int):void
                {
                    moveAll();
                    collider.findCollisions(_agents, found);
                });
            assertTrue("some collide", found.length > 0);
            assertTrue(Math.round(grown) + " bytes in " + _frames + " searches", grown <= PAGES);
        }

        // Back and forth, so that the crowd stays as it is.
        private function moveAll():void
        {
            for (var i:int = 0; i < _agents.length; i++)
            {
                var agent:Agent = _agents[i];
                agent.heading += 360 / TURN;
                agent.moveTo(-agent.x, agent.y, agent.z);
            }
        }

        // How much the player's memory grows in the frames, warm-up apart.
        private function growth(frame:Function):Number
        {
            Garbage.assumeKept();
            // after a whole turn of all agents no list has to grow
            return MemoryGrowth.during(_frames, TURN, frame);
        }
    }
}
