package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.EveryDepth;

    use namespace engine;

    /**
     * Surfaces that touch, or are a hair's breadth apart, along a direction askew to all axes: what is exact about them, and
     * that all others report what it does.
     */
    public class HierarchyTouchTest
    {
        private static const KINDS:Array = [BoundingStructure.BOX, BoundingStructure.SPHERE, BoundingStructure.CAPSULE];
        private static const SHAPES:Array = ["cube", "wall", "sphere"];

        private static var sGreatLands:Array;

        [BeforeClass]
        public static function load():void
        {
            sGreatLands = [];
            for each (var kind:int in KINDS)
            {
                var greatLand:GreatLand = new GreatLand();
                greatLand.hierarchies.boundsKind = kind;
                greatLand.addModel(BuiltInModel.cube());
                greatLand.addModel(BuiltInModel.sphere());
                greatLand.addModel(new Model("wall", new <Number>[0, -0.5, 0, 0, 0.5, 0, 0, 0.5, 1, 0, -0.5, 1], new <uint>[0, 1, 2, 0, 2, 3]));
                sGreatLands.push(greatLand);
            }
        }

        [AfterClass]
        public static function forget():void
        {
            sGreatLands = null;
        }

        [Test]
        public function facesThatTouchMeet():void
        {
            var random:SeededRandom = new SeededRandom(921);
            var exact:HierarchicalCollider = new HierarchicalCollider(sGreatLands[0]);
            exact.exact = true;
            for (var i:int = 0; i < 200; i++)
            {
                var a:Agent = turnedAgent(random, random.pick(["cube", "wall"]));
                var b:Agent = beside(a, random.pick(["cube", "wall"]), random.logBetween(0.1, 3), 0);
                assertTrue("pair " + i, exact.areColliding(a, b) && exact.areColliding(b, a));
                var gap:Number = 1e-9 * (a.size + b.size);
                b = beside(a, b.shape, b.size, gap);
                assertFalse("a gap of " + gap, exact.areColliding(a, b) || exact.areColliding(b, a));
            }
        }

        [Test]
        public function othersReportWhatTouches():void
        {
            checkOthers(922, 1);
        }

        [Test]
        public function othersReportWhatTouchesFarOut():void
        {
            checkOthers(923, 30);
        }

        private static function checkOthers(seed:uint, reach:Number):void
        {
            var random:SeededRandom = new SeededRandom(seed);
            var hits:int = 0;
            var count:int = 0;
            for (var i:int = 0; i < 300; i++)
            {
                var greatLand:GreatLand = sGreatLands[i % 3];
                var exact:HierarchicalCollider = new HierarchicalCollider(greatLand);
                exact.exact = true;
                var a:Agent = turnedAgent(random, random.pick(SHAPES), reach);
                for each (var gap:Number in [0, 1e-15, 4e-15, 1e-14, 2e-14, 1e-13])
                {
                    var b:Agent = beside(a, random.pick(SHAPES), random.logBetween(0.1, 3), gap);
                    count++;
                    if (exact.areColliding(a, b))
                    {
                        hits++;
                        checkPair("pair " + i + ", " + a.shape + " and " + b.shape + ", gap " + gap, greatLand, a, b);
                    }
                }
            }
            assertTrue("hits: " + hits + " of " + count, hits > count / 4 && hits < 0.9 * count);
        }

        private static function checkPair(pair:String, greatLand:GreatLand, a:Agent, b:Agent):void
        {
            // two spheres are compared to the last bit
            assertTrue(pair + ", tightest fit", a.shape == "sphere" && b.shape == "sphere" || new TightestFitCollider(greatLand).areColliding(a, b));
            new EveryDepth(greatLand, [1, 4, 10]).check(pair, a, b, true);
        }

        private static function turnedAgent(random:SeededRandom, shape:String, reach:Number = 1):Agent
        {
            var agent:Agent = new Agent(shape);
            agent.size = random.logBetween(0.1, 3);
            agent.heading = random.between(0, 360);
            agent.pitch = random.between(0, 360);
            agent.roll = random.between(0, 360);
            agent.moveTo(random.between(-reach, reach), random.between(-reach, reach), random.between(-reach, reach));
            return agent;
        }

        // Beside a model, turned like it, face to face or vertex to vertex, along its x axis.
        private static function beside(a:Agent, shape:String, size:Number, gap:Number):Agent
        {
            var b:Agent = new Agent(shape);
            b.size = size;
            b.heading = a.heading;
            b.pitch = a.pitch;
            b.roll = a.roll;
            var x:Number = halfWidth(a) + halfWidth(b) + gap;
            // so that it is as high up as the other
            var z:Number = 0.5 * (a.size - b.size);
            // not by a Matrix3D: its single precision would be a larger gap
            var at:Placement = a.worldPlacement();
            b.moveTo(a.x + at.r00 * x + at.r02 * z, a.y + at.r10 * x + at.r12 * z, a.z + at.r20 * x + at.r22 * z);
            return b;
        }

        private static function halfWidth(agent:Agent):Number
        {
            return agent.shape == "wall" ? 0 : 0.5 * agent.size;
        }
    }
}
