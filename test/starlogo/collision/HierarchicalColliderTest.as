package starlogo.collision
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.HierarchyReference;
    import support.SolidAngles;
    import evaluation.pairs.SeededRandom;
    import support.assertThrows;

    public class HierarchicalColliderTest
    {
        private static const KINDS:Array = [BoundingStructure.BOX, BoundingStructure.SPHERE, BoundingStructure.CAPSULE];
        private static const SHAPES:Array = ["sphere", "cube", "cylinder", "blades"];

        private var _greatLand:GreatLand;
        private var _collider:HierarchicalCollider;

        [Before]
        public function makeGame():void
        {
            _greatLand = new GreatLand();
            _greatLand.loadTightestFit = false;
            addModels();
            _collider = new HierarchicalCollider(_greatLand);
        }

        [Test]
        public function visitsFiveLevelsAtFirst():void
        {
            assertEquals(5, _collider.maxDepth);
            assertFalse(_collider.exact);
            assertThrows(RangeError, /maxDepth.*0/, function():void
                {
                    _collider.maxDepth = 0;
                });
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
        public function spheresMissNothing():void
        {
            _greatLand.hierarchies.boundsKind = BoundingStructure.SPHERE;
            addModels();
            compareWithSurfaces(300, 303);
        }

        [Test]
        public function capsulesMissNothing():void
        {
            _greatLand.hierarchies.boundsKind = BoundingStructure.CAPSULE;
            addModels();
            compareWithSurfaces(300, 304);
        }

        [Test]
        public function differentStructuresMissNothing():void
        {
            for (var i:int = 0; i < SHAPES.length; i++)
            {
                _greatLand.hierarchies.boundsKind = KINDS[i % 3];
                _greatLand.addModel(modelOf(SHAPES[i]));
            }
            compareWithSurfaces(300, 305);
        }

        [Test]
        public function aWallOfTwoTrianglesIsHitInItsMiddle():void
        {
            _greatLand.addModel(new Model("wall", new <Number>[0, -0.5, 0, 0, 0.5, 0, 0, 0.5, 1, 0, -0.5, 1], new <uint>[0, 1, 2, 0, 2, 3]));
            // so that the two triangles are two leaves
            _greatLand.hierarchies.minVerticesToSplit = 1;
            _greatLand.addModel(new Model("finer wall", new <Number>[0, -0.5, 0, 0, 0.5, 0, 0, 0.5, 1, 0, -0.5, 1], new <uint>[0, 1, 2, 0, 2, 3]));
            _greatLand.hierarchies.minVerticesToSplit = 5;
            for each (var shape:String in ["wall", "finer wall"])
            {
                for each (var isExact:Boolean in [false, true])
                {
                    for (var depth:int = 1; depth <= 12; depth++)
                    {
                        _collider.exact = isExact;
                        _collider.maxDepth = depth;
                        assertEquals(shape + " at depth " + depth, 3, whereItStops(shape));
                    }
                }
            }
        }

        [Test]
        public function theThesissHierarchyOfVerticesLetsItThrough():void
        {
            // a wall of many vertices at its border, none in its middle
            var border:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i <= 20; i++)
            {
                border.push(0, i / 20 - 0.5, 0, 0, i / 20 - 0.5, 1, 0, -0.5, i / 20, 0, 0.5, i / 20);
            }
            _greatLand.addModel(new Model("wall", border));
            _collider.maxDepth = 5;
            assertEquals(-1, whereItStops("wall"));
        }

        [Test]
        public function touchingCountsAtEveryDepth():void
        {
            var a:Agent = new Agent("cube");
            var b:Agent = new Agent("cube");
            for each (var heading:Number in [0, 90, 180, 270])
            {
                for each (var size:Number in [0.1, 1, 3])
                {
                    for (var depth:int = 1; depth <= 10; depth += 3)
                    {
                        _collider.maxDepth = depth;
                        b.heading = heading;
                        b.size = size;
                        b.moveTo(0.5 + size / 2, 0.3, 0.2);
                        assertTrue(_collider.areColliding(a, b));
                        b.moveTo(0.5 + size / 2 + 1e-9, 0.3, 0.2);
                        assertFalse(_collider.areColliding(a, b));
                        b.moveTo(0, 0.2, 1);
                        assertTrue("on top", _collider.areColliding(a, b));
                        b.moveTo(0, 0.2, 1 + 1e-9);
                        assertFalse("over it", _collider.areColliding(a, b));
                    }
                }
            }
        }

        [Test]
        public function touchingCountsFarOutAndAtAnySize():void
        {
            var a:Agent = new Agent("cube");
            var b:Agent = new Agent("cube");
            for each (var far:Number in [0, 1024, 1048576])
            {
                for each (var size:Number in [1 / 1024, 1, 1024])
                {
                    // binary fractions, so that the sums are exact
                    a.moveTo(far, -far, 3);
                    b.size = size;
                    b.moveTo(far + 0.5 + size / 2, -far + 0.25, 3);
                    assertTrue(far + ", " + size, _collider.areColliding(a, b) && _collider.areColliding(b, a));
                    assertEquals(2, _collider.findCollisions(new <Agent>[a, b]).length);
                    b.x += 1e-6;
                    assertFalse(far + ", " + size, _collider.areColliding(a, b));
                }
            }
        }

        [Test]
        public function exactDoesNotDependOnTheStructures():void
        {
            var answers:Array = ["", "", ""];
            for (var i:int = 0; i < 3; i++)
            {
                _greatLand.hierarchies.boundsKind = KINDS[i];
                addModels();
                var collider:HierarchicalCollider = new HierarchicalCollider(_greatLand);
                collider.exact = true;
                var random:SeededRandom = new SeededRandom(313);
                for (var k:int = 0; k < 200; k++)
                {
                    answers[i] += collider.areColliding(randomAgent(random, k % 2 == 0), randomAgent(random, k % 2 == 0)) ? "1" : "0";
                }
            }
            assertEquals(answers[0], answers[1]);
            assertEquals(answers[0], answers[2]);
            assertTrue(answers[0].split("1").length > 40 && answers[0].split("0").length > 40);
        }

        [Test]
        public function deeperNeverFindsMore():void
        {
            var random:SeededRandom = new SeededRandom(310);
            for (var i:int = 0; i < 300; i++)
            {
                var a:Agent = randomAgent(random, false);
                var b:Agent = randomAgent(random, false);
                var wasHit:Boolean = true;
                for (var depth:int = 1; depth <= 10; depth++)
                {
                    _collider.maxDepth = depth;
                    var isHit:Boolean = _collider.areColliding(a, b);
                    assertTrue("a hit at depth " + depth + " that was none before", wasHit || !isHit);
                    wasHit = isHit;
                }
            }
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
            assertThrows(RangeError, /traversalDepth/, function():void
                {
                    a.traversalDepth = -1;
                });
        }

        [Test]
        public function findsWhatIsColliding():void
        {
            var random:SeededRandom = new SeededRandom(311);
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < 120; i++)
            {
                var agent:Agent = randomAgent(random, i % 2 == 0);
                agent.moveTo(random.between(-6, 6), random.between(-6, 6), random.between(0, 2));
                agents.push(agent);
            }
            var found:Vector.<Agent> = _collider.findCollisions(agents);
            var next:int = 0;
            var expected:int = 0;
            for (i = 0; i < agents.length; i++)
            {
                for (var j:int = i + 1; j < agents.length; j++)
                {
                    expected += _collider.areColliding(agents[i], agents[j]) ? 1 : 0;
                }
            }
            assertEquals(expected, found.length / 2);
            assertTrue("some do", expected > 20);
            for (i = 0; i < found.length; i += 2)
            {
                assertTrue(_collider.areColliding(found[i], found[i + 1]));
            }
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
            _collider.exact = true;
            agents[1].heading = 10;
            _collider.findCollisions(agents);
            assertTrue("down to the leaves", statistics.nodeVisits > 5);
            assertTrue(statistics.triangleTests > 0);
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
        public function exactSurfacesMeetOrNot():void
        {
            _collider.exact = true;
            var a:Agent = new Agent("blades");
            var b:Agent = new Agent("blades");
            // the blades are planes through the axis, at right angles: turned by 45 degrees they meet on it
            b.heading = 45;
            assertTrue(_collider.areColliding(a, b));
            b.heading = 0;
            b.moveTo(0.1, 0.1, 0);
            assertTrue("they cross", _collider.areColliding(a, b));
            b.moveTo(0.1, 0.1, 1.001);
            assertFalse("over it", _collider.areColliding(a, b));
            b.moveTo(0.1, 0.1, 1);
            assertTrue("on it", _collider.areColliding(a, b));
            b.moveTo(0, 1, 0);
            assertTrue("edge to edge", _collider.areColliding(a, b));
            b.moveTo(0, 1 + 1e-9, 0);
            assertFalse(_collider.areColliding(a, b));
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

        [Test]
        public function aSolidInsideOfAClosedOneCounts():void
        {
            addOpenCube();
            _collider.exact = true;
            var inner:Agent = new Agent("sphere");
            inner.size = 0.4;
            inner.moveTo(0.1, 0.05, 0.3);
            for each (var pair:Vector.<Agent> in [new <Agent>[new Agent("cube"), inner], new <Agent>[inner, new Agent("cube")]])
            {
                assertTrue(_collider.areColliding(pair[0], pair[1]));
            }
            assertFalse("an open cube has no inside", _collider.areColliding(new Agent("open cube"), inner));
            assertFalse(_collider.areColliding(inner, new Agent("open cube")));
            inner.moveTo(0.8, 0.05, 0.3);
            assertFalse("beside it", _collider.areColliding(inner, new Agent("cube")));
        }

        [Test]
        public function anInsideIsFoundWhereRaysGraze():void
        {
            _collider.exact = true;
            var outer:Agent = new Agent("cube");
            var inner:Agent = new Agent("cube");
            var random:SeededRandom = new SeededRandom(312);
            for (var i:int = 0; i < 500; i++)
            {
                // corners on diagonals and grid lines of the outer one
                inner.size = random.pick([0.125, 0.25, 0.5]);
                inner.moveTo(random.integer(-1, 1) / 16, random.integer(-1, 1) / 16, random.integer(1, 3) / 16);
                inner.heading = 90 * random.integer(0, 3);
                assertTrue(_collider.areColliding(outer, inner));
                inner.moveTo(random.integer(-1, 1) / 16, random.integer(-1, 1) / 16, 1.0625 + random.integer(0, 1) / 16);
                assertFalse(_collider.areColliding(outer, inner));
            }
        }

        // Where an agent that walks along x is stopped by a wall at x = 3.5, or -1.
        private function whereItStops(shape:String):int
        {
            var wall:Agent = new Agent(shape);
            wall.size = 10;
            wall.moveTo(3.5, 0, 0);
            var walker:Agent = new Agent("cube");
            for (var x:int = 0; x < 8; x++)
            {
                walker.moveTo(x, 0.1, 4.6);
                if (_collider.findCollisions(new <Agent>[walker, wall]).length > 0)
                {
                    return x;
                }
            }
            return -1;
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

        // A child's sphere may reach out of its parent's, and what meets it there need not be found.
        private function compareWithSurfaces(count:int, seed:uint):void
        {
            var random:SeededRandom = new SeededRandom(seed);
            var reference:HierarchyReference = new HierarchyReference(_greatLand);
            var surfaces:HierarchicalCollider = surfaceCollider();
            var hits:int = 0;
            var hitsOfSurfaces:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var a:Agent = randomAgent(random, i % 3 == 0);
                var b:Agent = randomAgent(random, i % 3 == 0);
                var depth:int = random.integer(1, 6);
                _collider.maxDepth = depth;
                var isHit:Boolean = _collider.areColliding(a, b);
                assertTrue("pair " + i + " has ends that meet", !isHit || reference.areColliding(a, depth, b, depth)
                        || SolidAngles.isOneInside(a, modelOf(a.shape), b, modelOf(b.shape)));
                hits += isHit ? 1 : 0;
                _collider.maxDepth = 10;
                if (surfaces.areColliding(a, b))
                {
                    hitsOfSurfaces++;
                    assertTrue("pair " + i + " meets", isHit && _collider.areColliding(a, b));
                }
            }
            assertTrue("hits: " + hits + " of " + count, hits > 0.2 * count && hits < 0.9 * count && hitsOfSurfaces > 0.15 * count);
        }

        // Exact, but without insides: a triangle that is there twice leaves a surface as it is, and not closed.
        private static function surfaceCollider():HierarchicalCollider
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.loadTightestFit = false;
            for each (var shape:String in SHAPES)
            {
                var model:Model = modelOf(shape);
                var triangles:Vector.<uint> = model.triangles.slice();
                triangles.push(triangles[0], triangles[1], triangles[2]);
                greatLand.addModel(new Model(shape, model.vertices, triangles));
            }
            var collider:HierarchicalCollider = new HierarchicalCollider(greatLand);
            collider.exact = true;
            return collider;
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

        private function addOpenCube():void
        {
            var cube:Model = BuiltInModel.cube();
            _greatLand.addModel(new Model("open cube", cube.vertices, cube.triangles.slice(0, 33)));
        }
    }
}
