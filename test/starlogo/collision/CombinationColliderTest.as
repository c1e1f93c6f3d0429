package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.fitting.CapsuleFitter;
    import starlogo.fitting.Fitter;
    import starlogo.fitting.NaiveSphereFitter;
    import starlogo.fitting.OrientedBoxFitter;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.BruteForce;
    import support.HierarchyReference;
    import support.assertThrows;
    import support.assign;

    public class CombinationColliderTest
    {
        private static const SHAPES:Array = ["ball", "post", "crate"];

        private var _greatLand:GreatLand = new GreatLand();
        private var _collider:CombinationCollider = new CombinationCollider(_greatLand);

        [Before]
        public function makeGame():void
        {
            addModels();
        }

        [Test]
        public function visitsFiveLevelsAtFirst():void
        {
            assertEquals(5, _collider.maxDepth);
            assertFalse(_collider.exact);
            assertThrows(RangeError, /maxDepth.*-2/, assign, _collider, "maxDepth", -2);
        }

        [Test]
        public function withHierarchicalAgentsOnlyItIsTheHierarchicalCollider():void
        {
            var agents:Vector.<Agent> = randomAgents(200, 402, 1);
            var hierarchical:HierarchicalCollider = new HierarchicalCollider(_greatLand);
            for each (var isExact:Boolean in [false, true])
            {
                hierarchical.exact = _collider.exact = isExact;
                hierarchical.maxDepth = _collider.maxDepth = 4;
                var expected:Vector.<Agent> = hierarchical.findCollisions(agents);
                var visits:int = hierarchical.statistics.nodeVisits;
                assertEquals("", BruteForce.difference(expected, _collider.findCollisions(agents)));
                assertTrue(expected.length > 100);
                assertEquals(visits, _collider.statistics.nodeVisits);
                assertEquals(0, _collider.statistics.tests);
            }
        }

        [Test]
        public function aHierarchyMeetsEachKind():void
        {
            compareOneHierarchical("ball", 403);
            compareOneHierarchical("post", 404);
            compareOneHierarchical("crate", 405);
        }

        [Test]
        public function needsOnlyWhatItUses():void
        {
            _greatLand.loadHierarchies = false;
            _greatLand.addModel(named("no hierarchy"));
            _greatLand.loadHierarchies = true;
            _greatLand.loadTightestFit = false;
            _greatLand.addModel(named("no fit"));
            var plain:Agent = new Agent("no hierarchy");
            var precise:Agent = new Agent("no fit");
            precise.hierarchical = true;
            assertTrue(_collider.areColliding(plain, precise));
            precise.hierarchical = false;
            assertThrows(ArgumentError, /"no fit".*loadTightestFit/, _collider.areColliding, plain, precise);
            precise.hierarchical = true;
            plain.hierarchical = true;
            assertThrows(ArgumentError, /"no hierarchy".*loadHierarchies/, _collider.areColliding, plain, precise);
            plain.hierarchical = false;
            assertTrue(_collider.areColliding(plain, precise));
        }

        // Triangles decide about a tree and a structure, so no depth counts, and some pairs are apart whose boxes touch. ExactStructuresTest has
        // the truth.
        [Test]
        public function exactKnowsNoDepth():void
        {
            var random:SeededRandom = new SeededRandom(410);
            var reference:HierarchyReference = new HierarchyReference(_greatLand);
            _collider.maxDepth = 2;
            _collider.exact = true;
            var hits:int = 0;
            var fewer:int = 0;
            for (var i:int = 0; i < 300; i++)
            {
                var a:Agent = randomAgent(random, "ball", i % 2 == 0);
                var b:Agent = randomAgent(random, random.pick(SHAPES), i % 2 == 0);
                a.hierarchical = true;
                a.traversalDepth = i % 3;
                var answer:Boolean = _collider.areColliding(a, b);
                var boxes:Boolean = reference.meetsTightestFit(a, 100, b);
                hits += answer ? 1 : 0;
                fewer += boxes && !answer ? 1 : 0;
                assertTrue("pair " + i + ": nested", boxes || !answer);
                assertEquals("pair " + i + " of a frame", answer ? 2 : 0, _collider.findCollisions(new <Agent>[b, a]).length);
                a.traversalDepth = 7 - a.traversalDepth;
                assertEquals("pair " + i + " at another depth", answer, _collider.areColliding(b, a));
            }
            assertTrue("hits: " + hits + ", fewer than boxes: " + fewer, hits > 60 && hits < 240 && fewer > 5);
        }

        private function compareOneHierarchical(shape:String, seed:uint):void
        {
            var random:SeededRandom = new SeededRandom(seed);
            var reference:HierarchyReference = new HierarchyReference(_greatLand);
            var hits:int = 0;
            for (var i:int = 0; i < 300; i++)
            {
                var a:Agent = randomAgent(random, random.pick(SHAPES), i % 2 == 0);
                var b:Agent = randomAgent(random, shape, i % 2 == 0);
                a.hierarchical = true;
                var depth:int = random.integer(1, 7);
                a.traversalDepth = depth;
                var expected:Boolean = reference.meetsTightestFit(a, depth, b);
                hits += expected ? 1 : 0;
                assertEquals("pair " + i, expected, _collider.areColliding(a, b));
                assertEquals("pair " + i + ", the other way round", expected, _collider.areColliding(b, a));
            }
            assertTrue("hits: " + hits, hits > 60 && hits < 240);
        }

        private static function randomAgents(count:int, seed:uint, share:Number):Vector.<Agent>
        {
            var random:SeededRandom = new SeededRandom(seed);
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < count; i++)
            {
                var agent:Agent = randomAgent(random, random.pick(SHAPES), i % 2 == 0);
                agent.moveTo(random.between(-6, 6), random.between(-6, 6), random.between(0, 3));
                agent.hierarchical = random.chance(share);
                agents.push(agent);
            }
            return agents;
        }

        private static function randomAgent(random:SeededRandom, shape:String, isUpright:Boolean):Agent
        {
            var agent:Agent = new Agent(shape);
            agent.size = random.logBetween(0.3, 3);
            agent.heading = random.between(0, 360);
            agent.pitch = isUpright ? 0 : random.between(0, 360);
            agent.roll = isUpright ? 0 : random.between(0, 360);
            var reach:Number = agent.size;
            agent.moveTo(random.between(-reach, reach), random.between(-reach, reach), random.between(-reach, reach));
            return agent;
        }

        // Each with the one fit that its name suggests.
        private function addModels():void
        {
            var box:OrientedBoxFitter = new OrientedBoxFitter(30);
            var sphere:Model = BuiltInModel.sphere();
            addFitted("ball", sphere.vertices, sphere.triangles, new NaiveSphereFitter());
            addFitted("post", stretched(sphere.vertices, 3), sphere.triangles, new CapsuleFitter(box));
            addFitted("crate", stretched(BuiltInModel.cube().vertices, 0.6), BuiltInModel.cube().triangles, box);
        }

        private function addFitted(name:String, vertices:Vector.<Number>, triangles:Vector.<uint>, fitter:Fitter):void
        {
            _greatLand.boundingStructures.fitters = new <Fitter>[fitter];
            _greatLand.addModel(new Model(name, vertices, triangles));
        }

        private static function stretched(vertices:Vector.<Number>, factor:Number):Vector.<Number>
        {
            var out:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < vertices.length; i++)
            {
                out.push(vertices[i] * (i % 3 == 2 ? factor : 1));
            }
            return out;
        }

        private static function named(name:String):Model
        {
            var cube:Model = BuiltInModel.cube();
            return new Model(name, cube.vertices, cube.triangles);
        }
    }
}
