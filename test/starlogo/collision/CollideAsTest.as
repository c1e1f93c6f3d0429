package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.fitting.Fitter;
    import starlogo.fitting.NaiveSphereFitter;
    import starlogo.intersection.intersects;
    import starlogo.libraries.BoundingStructuresLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ObjModel;
    import support.CountingFitter;
    import support.Fixtures;
    import support.TransformedStructure;
    import support.assertThrows;
    import support.assign;

    /** Agents that say which structure stands for them (thesis §7.3). */
    public class CollideAsTest
    {
        public static const FIXTURES:Array = ["/assets/kelp.obj"];

        private static const KINDS:Array = [Agent.TIGHTEST, Agent.SPHERE, Agent.BOX, Agent.CAPSULE, Agent.HULL];
        private static const SHAPES:Array = ["sphere", "cube", "kelp"];

        private static var sSparing:GreatLand;
        private static var sThorough:GreatLand;

        [BeforeClass]
        public static function load():void
        {
            sSparing = new GreatLand();
            sThorough = new GreatLand();
            sThorough.loadAllBoundingStructures = sThorough.loadHulls = true;
            for each (var greatLand:GreatLand in [sSparing, sThorough])
            {
                addModels(greatLand);
            }
        }

        [Test]
        public function everyKindCollidesAsItsStructure():void
        {
            var random:SeededRandom = new SeededRandom(73);
            var colliders:Array = [new TightestFitCollider(sSparing), new TightestFitCollider(sThorough), new CombinationCollider(sSparing)];
            var a:Agent = new Agent("cube");
            var b:Agent = new Agent("sphere");
            var hits:int = 0;
            for (var i:int = 0; i < 600; i++)
            {
                change(a, random);
                change(b, random);
                var expected:Boolean = intersects(TransformedStructure.of(structureOf(a), a), TransformedStructure.of(structureOf(b), b));
                hits += expected ? 1 : 0;
                for each (var collider:CollisionSystem in colliders)
                {
                    assertEquals(i + ": " + a + " as " + a.collideAs + ", " + b + " as " + b.collideAs, expected, collider.areColliding(a, b));
                }
            }
            assertTrue("some hit and some do not: " + hits, hits > 100 && hits < 500);
        }

        [Test]
        public function whatWasFoundForTheModelIsNotFoundAgainAndNothingElseChanges():void
        {
            var greatLand:GreatLand = new GreatLand();
            var fitter:CountingFitter = new CountingFitter();
            greatLand.boundingStructures.fitters.push(fitter);
            addModels(greatLand);
            var before:int = fitter.count;
            var tightest:BoundingStructure = greatLand.boundingStructures.tightestFit("kelp");
            var collider:TightestFitCollider = new TightestFitCollider(greatLand);
            var kelp:Agent = new Agent("kelp");
            for (var i:int = 0; i < 6; i++)
            {
                kelp.collideAs = i % 2 == 0 ? Agent.SPHERE : Agent.HULL;
                collider.areColliding(kelp, new Agent("kelp"));
                kelp.size += 0.1;
            }
            assertEquals(before, fitter.count);
            assertEquals(tightest, greatLand.boundingStructures.tightestFit("kelp"));
            assertFalse(greatLand.boundingStructures.hasAll("kelp"));
        }

        [Test]
        public function aKindThatNoFitterFindsIsAnErrorUntilItIsGivenUp():void
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.boundingStructures.fitters = new <Fitter>[new NaiveSphereFitter()];
            addModels(greatLand);
            var collider:TightestFitCollider = new TightestFitCollider(greatLand);
            var cube:Agent = new Agent("cube");
            var other:Agent = new Agent("cube");
            collider.areColliding(cube, other);
            cube.collideAs = Agent.BOX;
            for (var i:int = 0; i < 2; i++)
            {
                assertThrows(ArgumentError, /^shape "cube": it cannot be a box: no fitter found one when its model was added$/, collider.areColliding, cube, other);
            }
            cube.collideAs = Agent.SPHERE;
            assertTrue(collider.areColliding(cube, other));
        }

        [Test]
        public function otherKindsAreRefused():void
        {
            var agent:Agent = new Agent("cube");
            agent.collideAs = Agent.CAPSULE;
            for each (var name:String in ["ball", "", null, "Sphere"])
            {
                // in JavaScript null is no string
                assertThrows(ArgumentError, /collideAs must be ("tightest", "sphere", "box", "capsule" or "hull", not |a string, not null)/, assign, agent, "collideAs", name);
            }
            assertEquals(Agent.CAPSULE, agent.collideAs);
        }

        private static function addModels(greatLand:GreatLand):void
        {
            greatLand.addModel(BuiltInModel.sphere());
            greatLand.addModel(BuiltInModel.cube());
            greatLand.addModel(new ObjModel("kelp", Fixtures.text(FIXTURES[0])));
        }

        private static function change(agent:Agent, random:SeededRandom):void
        {
            agent.shape = random.pick(SHAPES);
            agent.collideAs = random.pick(KINDS);
            agent.moveTo(random.between(-0.7, 0.7), random.between(-0.7, 0.7), random.between(-0.7, 0.7));
            agent.heading = random.between(0, 360);
            agent.pitch = random.chance() ? 0 : random.between(0, 360);
            agent.size = random.between(0.5, 1.5);
        }

        private static function structureOf(agent:Agent):BoundingStructure
        {
            var kept:BoundingStructuresLibrary = sThorough.boundingStructures;
            switch (agent.collideAs)
            {
                case Agent.SPHERE:
                    return kept.sphere(agent.shape);
                case Agent.BOX:
                    return kept.box(agent.shape);
                case Agent.CAPSULE:
                    return kept.capsule(agent.shape);
                case Agent.HULL:
                    return kept.hull(agent.shape);
                default:
                    return kept.tightestFit(agent.shape);
            }
        }
    }
}
