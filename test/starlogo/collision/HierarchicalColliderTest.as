package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.HierarchyReference;
    import support.SolidAngles;
    import support.assertThrows;
    import support.assign;

    public class HierarchicalColliderTest
    {
        private static const SHAPES:Array = ["sphere", "cube", "cylinder", "blades"];

        private var _greatLand:GreatLand = new GreatLand();
        private var _collider:HierarchicalCollider = new HierarchicalCollider(_greatLand);

        [Before]
        public function makeGame():void
        {
            _greatLand.loadTightestFit = false;
            addModels();
        }

        [Test]
        public function visitsFiveLevelsAtFirst():void
        {
            assertEquals(5, _collider.maxDepth);
            assertFalse(_collider.exact);
            assertThrows(RangeError, /maxDepth.*0/, assign, _collider, "maxDepth", 0);
            assertEquals(5, _collider.maxDepth);
        }

        [Test]
        public function boxesAreLikeAllTheirPairs():void
        {
            compareWithReference(400, 301, false);
        }

        [Test]
        public function uprightBoxesAreLikeAllTheirPairs():void
        {
            compareWithReference(400, 302, true);
        }

        [Test]
        public function theAgentsOwnDepthCounts():void
        {
            var a:Agent = new Agent("blades");
            var b:Agent = new Agent("cube");
            // in a corner of the first box that no blade reaches
            b.size = 0.05;
            b.moveTo(0.45, 0.45, 0.5);
            assertFalse(_collider.areColliding(a, b));
            a.traversalDepth = 1;
            assertTrue("its box alone", _collider.areColliding(a, b));
            a.traversalDepth = 10;
            _collider.maxDepth = 1;
            assertFalse(_collider.areColliding(a, b));
            a.traversalDepth = 0;
            assertTrue(_collider.areColliding(a, b));
            assertThrows(RangeError, /traversalDepth/, assign, a, "traversalDepth", -1);
        }

        [Test]
        public function countsWhatItVisits():void
        {
            var agents:Vector.<Agent> = new <Agent>[new Agent("sphere"), new Agent("sphere"), new Agent("cube")];
            agents[2].moveTo(30, 30, 0);
            _collider.findCollisions(agents);
            var statistics:CollisionStatistics = _collider.statistics;
            assertEquals(1, statistics.candidatePairs);
            assertEquals(1, statistics.hierarchyTests);
            assertEquals("one a level", 5, statistics.nodeVisits);
            assertEquals(0, statistics.triangleTests);
            assertEquals(0, statistics.tests);
            assertEquals(1, statistics.collisions);
            agents[1].pitch = 30;
            _collider.findCollisions(agents);
            assertTrue("one a level at least, leaning", statistics.nodeVisits >= 5);
            _collider.exact = true;
            agents[1].heading = 10;
            _collider.findCollisions(agents);
            assertTrue("down to the leaves", statistics.nodeVisits > 5);
            assertTrue(statistics.triangleTests > 0);
            // leaning, in a corner that no blade reaches
            _collider.exact = false;
            agents[0].shape = "blades";
            agents[1].shape = "cube";
            agents[1].size = 0.05;
            agents[1].moveTo(0.45, 0.45, 0.5);
            _collider.findCollisions(agents);
            assertTrue("boxes that touch where their blades do not", statistics.nodeVisits > 1 && statistics.collisions == 0);
        }

        [Test]
        public function namesAgentsWithoutAHierarchy():void
        {
            _greatLand.loadHierarchies = false;
            _greatLand.addModel(new Model("flat", new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0]));
            var agents:Vector.<Agent> = new <Agent>[new Agent("cube"), new Agent("flat")];
            assertThrows(ArgumentError, /agent \d+.*"flat".*loadHierarchies/, _collider.findCollisions, agents);
            agents[1].shape = "unicorn";
            assertThrows(ArgumentError, /agent \d+.*"unicorn".*add it/, _collider.findCollisions, agents);
        }

        [Test]
        public function exactWithoutTrianglesIsItsLeaves():void
        {
            _greatLand.addModel(new Model("points", BuiltInModel.cube().vertices));
            _collider.exact = true;
            var a:Agent = new Agent("points");
            var b:Agent = new Agent("cube");
            b.moveTo(0, 0, 0.9);
            assertTrue(_collider.areColliding(a, b));
        }

        private function compareWithReference(count:int, seed:uint, isUpright:Boolean):void
        {
            var random:SeededRandom = new SeededRandom(seed);
            var reference:HierarchyReference = new HierarchyReference(_greatLand);
            var hits:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var a:Agent = randomAgent(random, isUpright);
                var b:Agent = randomAgent(random, isUpright);
                var depthA:int = random.integer(1, 6);
                var depthB:int = random.integer(1, 6);
                _collider.maxDepth = depthA;
                b.traversalDepth = depthB;
                var expected:Boolean = reference.areColliding(a, depthA, b, depthB)
                    || SolidAngles.isOneInside(a, modelOf(a.shape), b, modelOf(b.shape));
                hits += expected ? 1 : 0;
                assertEquals("pair " + i, expected, _collider.areColliding(a, b));
                assertEquals("pair " + i + ", the other way round", expected, _collider.areColliding(b, a));
            }
            assertTrue("hits: " + hits + " of " + count, hits > 0.2 * count && hits < 0.8 * count);
        }

        private static function randomAgent(random:SeededRandom, isUpright:Boolean):Agent
        {
            var agent:Agent = new Agent(random.pick(SHAPES));
            agent.size = random.logBetween(0.3, 5);
            agent.heading = random.between(0, 360);
            if (!isUpright)
            {
                agent.pitch = random.between(0, 360);
                agent.roll = random.between(0, 360);
            }
            var reach:Number = 0.75 * agent.size;
            agent.moveTo(random.between(-reach, reach), random.between(-reach, reach), random.between(-reach, reach));
            return agent;
        }

        private function addModels():void
        {
            for each (var shape:String in SHAPES)
            {
                _greatLand.addModel(modelOf(shape));
            }
        }

        private static function modelOf(shape:String):Model
        {
            switch (shape)
            {
                case "sphere":
                    return BuiltInModel.sphere();
                case "cube":
                    return BuiltInModel.cube();
                case "cylinder":
                    return BuiltInModel.cylinder();
                default:
                    return blades();
            }
        }

        // Two upright squares that cross, of 8 by 8 quads each: mostly holes.
        private static function blades():Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var blade:int = 0; blade < 2; blade++)
            {
                for (var row:int = 0; row <= 8; row++)
                {
                    for (var column:int = 0; column <= 8; column++)
                    {
                        var along:Number = column / 8 - 0.5;
                        vertices.push(blade == 0 ? along : 0, blade == 0 ? 0 : along, row / 8);
                        if (row < 8 && column < 8)
                        {
                            var first:int = blade * 81 + row * 9 + column;
                            triangles.push(first, first + 1, first + 10, first, first + 10, first + 9);
                        }
                    }
                }
            }
            return new Model("blades", vertices, triangles);
        }
    }
}
