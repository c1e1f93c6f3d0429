package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Effort;
    import support.EveryDepth;
    import support.EveryTriangle;
    import support.Fixtures;
    import support.SolidAngles;
    import support.SolidModels;

    /**
     * Models in models: what the exact collider reports is reported by all others but the BinCollider, and no greater depth
     * ever reports more. What is exact is found out with every triangle, and the solid angles around every vertex.
     */
    public class HierarchyNestingTest
    {
        public static const FIXTURES:Array = ["/assets/kelp.obj", "/assets/fortress.obj", "/assets/bear.obj", "/assets/spaceship.obj", "/assets/tree.obj"];

        private static const FULL:int = 40;
        private static const DEPTHS:Array = [1, 2, 3, 5, 8, FULL];

        private static var sModels:Object;
        private static var sGreatLand:GreatLand;

        [BeforeClass]
        public static function load():void
        {
            sModels = {};
            for each (var model:Model in SolidModels.all().concat(BuiltInModel.cylinder()))
            {
                sModels[model.name] = model;
            }
            for each (var address:String in FIXTURES)
            {
                sModels[address] = new ObjModel(address, Fixtures.text(address));
            }
            sGreatLand = new GreatLand();
            sGreatLand.orientedBoxDegIncrement = 45;
            sGreatLand.hierarchies.maxDepth = FULL;
            for each (model in sModels)
            {
                sGreatLand.addModel(model);
            }
        }

        [Test]
        public function nests():void
        {
            checkNests(901);
        }

        private static function checkNests(seed:uint):void
        {
            var random:SeededRandom = new SeededRandom(seed);
            var exact:HierarchicalCollider = new HierarchicalCollider(sGreatLand);
            exact.exact = true;
            var tightest:TightestFitCollider = new TightestFitCollider(sGreatLand);
            var everyDepth:EveryDepth = new EveryDepth(sGreatLand, DEPTHS);
            var inside:int = 0;
            var meeting:int = 0;
            var count:int = Effort.choose(70, 300);
            for (var i:int = 0; i < count; i++)
            {
                var a:Agent = outerAgent(random);
                var b:Agent = innerAgent(random, a);
                if (random.chance())
                {
                    // colliders take the older agent first
                    a = copyOf(a);
                }
                var pair:String = "pair " + i + ", " + a.shape + " and " + b.shape;
                var doMeet:Boolean = EveryTriangle.meet(a, sModels[a.shape], b, sModels[b.shape]);
                var isHit:Boolean = doMeet || SolidAngles.isOneInside(a, sModels[a.shape], b, sModels[b.shape]);
                assertEquals(pair + ", exact", isHit, exact.areColliding(a, b));
                assertEquals(pair + ", exact, the other way round", isHit, exact.areColliding(b, a));
                assertTrue(pair + ", tightest fit", !isHit || tightest.areColliding(a, b));
                everyDepth.check(pair, a, b, isHit);
                meeting += doMeet ? 1 : 0;
                inside += isHit && !doMeet ? 1 : 0;
            }
            assertTrue("inside: " + inside + ", meeting: " + meeting, inside > count / 8 && meeting > count / 6 && inside + meeting < 0.85 * count);
        }

        private static function outerAgent(random:SeededRandom):Agent
        {
            var agent:Agent = new Agent(shapeOf(random));
            agent.size = random.logBetween(1, 4);
            agent.heading = random.between(0, 360);
            if (random.chance(0.6))
            {
                agent.pitch = random.between(0, 360);
                agent.roll = random.between(0, 360);
            }
            agent.moveTo(random.between(-9, 9), random.between(-9, 9), random.between(-2, 2));
            return agent;
        }

        // About where a point of the outer one's model is that is drawn from its middle towards a vertex.
        private static function innerAgent(random:SeededRandom, outer:Agent):Agent
        {
            var model:Model = sModels[outer.shape];
            var vertex:int = 3 * random.integer(0, model.vertices.length / 3 - 1);
            var share:Number = random.between(0, 1.2);
            var at:Vector.<Number> = outer.transform.rawData;
            var x:Number = share * model.vertices[vertex];
            var y:Number = share * model.vertices[vertex + 1];
            var z:Number = 0.5 + share * (model.vertices[vertex + 2] - 0.5);
            var agent:Agent = new Agent(shapeOf(random));
            agent.size = outer.size * random.logBetween(0.02, 0.6);
            agent.heading = random.between(0, 360);
            if (random.chance(0.6))
            {
                agent.pitch = random.between(0, 360);
                agent.roll = random.between(0, 360);
            }
            agent.moveTo(at[0] * x + at[4] * y + at[8] * z + at[12], at[1] * x + at[5] * y + at[9] * z + at[13],
                    at[2] * x + at[6] * y + at[10] * z + at[14]);
            if (random.chance(0.3))
            {
                agent.z = outer.z;
            }
            return agent;
        }

        private static function copyOf(agent:Agent):Agent
        {
            var copy:Agent = new Agent(agent.shape);
            copy.size = agent.size;
            copy.heading = agent.heading;
            copy.pitch = agent.pitch;
            copy.roll = agent.roll;
            copy.moveTo(agent.x, agent.y, agent.z);
            return copy;
        }

        private static function shapeOf(random:SeededRandom):String
        {
            var names:Array = ["sphere", "cube", "cylinder"].concat(SolidModels.NAMES, FIXTURES);
            return random.pick(names);
        }
    }
}
