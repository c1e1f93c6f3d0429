package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.intersection.intersects;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.BruteForce;
    import support.RandomWorlds;
    import support.TransformedStructure;
    import support.agentAt;
    import support.assertThrows;
    import support.landOf;

    public class TightestFitColliderTest
    {
        private static const SHAPES:Array = ["ball", "wall", "pole", "brick"];

        private var _greatLand:GreatLand = landOf(new Model("ball", BuiltInModel.sphere().vertices), box("wall", 1, 0.05, 2), pole(), box("brick", 1, 0.6, 0.4));

        [Test]
        public function eachKindIsTheTightestFitOfSomeModel():void
        {
            assertEquals(BoundingStructure.SPHERE, _greatLand.boundingStructures.tightestFit("ball").kind);
            assertEquals(BoundingStructure.BOX, _greatLand.boundingStructures.tightestFit("wall").kind);
            assertEquals(BoundingStructure.CAPSULE, _greatLand.boundingStructures.tightestFit("pole").kind);
        }

        [Test]
        public function worldsOfManyKindsAreLikeBruteForce():void
        {
            for each (var kind:String in ["scattered", "mixed sizes", "on borders", "wide and sparse"])
            {
                compareWithBruteForce(_greatLand, kind, 201);
            }
        }

        [Test]
        public function farOutIsLikeBruteForce():void
        {
            compareWithBruteForce(_greatLand, "far out", 203);
        }

        [Test]
        public function countsTestsByTheirKinds():void
        {
            var agents:Vector.<Agent> = new <Agent>[agentAt("ball", 0, 0, 0), agentAt("ball", 0.1, 0, 0), agentAt("wall", 0, 0.04, 0), agentAt("pole", 0, 0, 0.1), agentAt("wall", 0, 0, 0)];
            var collider:TightestFitCollider = new TightestFitCollider(_greatLand);
            collider.areColliding(agents[2], agents[4]);
            collider.findCollisions(agents);
            var statistics:CollisionStatistics = collider.statistics;
            assertEquals("1 2 4 0 2 1", [statistics.sphereSphereTests, statistics.sphereCapsuleTests, statistics.sphereBoxTests, statistics.capsuleCapsuleTests, statistics.capsuleBoxTests, statistics.boxBoxTests].join(" "));
            assertEquals(10, statistics.tests);
        }

        [Test]
        public function aSweptPairThatMissesIsOneTest():void
        {
            var ball:Agent = agentAt("ball", 0.95, 0.45, 0);
            var agents:Vector.<Agent> = new <Agent>[ball, agentAt("wall", 0, 0, 0)];
            var collider:TightestFitCollider = new TightestFitCollider(_greatLand);
            ball.sweeps = true;
            collider.findCollisions(agents);
            ball.z = 0.5;
            assertEquals(0, collider.findCollisions(agents).length);
            assertEquals(1, collider.statistics.sweptPairs);
            assertEquals(1, collider.statistics.sphereBoxTests);
        }

        [Test]
        public function withoutTheFlagTheErrorSaysWhatToDo():void
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.loadTightestFit = false;
            greatLand.addModel(BuiltInModel.cube());
            var agents:Vector.<Agent> = new <Agent>[agentAt("cube", 0, 0, 0), agentAt("cube", 0, 0, 0)];
            assertThrows(ArgumentError, /agent \d+ .*cube.*loadTightestFit.*again/, new TightestFitCollider(greatLand).findCollisions, agents);
            assertEquals("the BinCollider needs no flag", 2, new BinCollider(greatLand).findCollisions(agents).length);
            greatLand.loadTightestFit = true;
            greatLand.addModel(BuiltInModel.cube());
            assertEquals(2, new TightestFitCollider(greatLand).findCollisions(agents).length);
        }

        // The reference puts clones through scale, rotate and translate, one pair at a time, and has no bins.
        private function compareWithBruteForce(greatLand:GreatLand, kind:String, seed:uint):void
        {
            var random:SeededRandom = new SeededRandom(seed);
            var collider:TightestFitCollider = new TightestFitCollider(greatLand);
            var collisions:int = 0;
            var possible:int = 0;
            var boxTests:int = 0;
            for (var world:int = 0; world < 60; world++)
            {
                var count:int = random.logBetween(2, 101);
                var agents:Vector.<Agent> = RandomWorlds.make(kind, count, "ball", random);
                var structures:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
                for each (var agent:Agent in agents)
                {
                    agent.shape = random.pick(SHAPES);
                    agent.heading = random.pick([0, 45, 90, random.between(0, 360)]);
                    agent.pitch = random.pick([0, 0, random.between(-90, 90)]);
                    agent.roll = random.pick([0, 0, random.between(-90, 90)]);
                    structures.push(worldStructure(greatLand, agent));
                }
                var expected:Vector.<Agent> = new Vector.<Agent>();
                for (var i:int = 0; i < count; i++)
                {
                    for (var j:int = i + 1; j < count; j++)
                    {
                        if (intersects(structures[i], structures[j]))
                        {
                            expected.push(agents[i], agents[j]);
                        }
                    }
                }
                assertEquals(kind + ", world " + world, "", BruteForce.difference(expected, collider.findCollisions(agents)));
                assertEquals(kind + ", asked by pair", "", BruteForce.difference(expected, BruteForce.ask(collider, agents)));
                collisions += expected.length / 2;
                possible += count * (count - 1) / 2;
                boxTests += collider.statistics.boxBoxTests;
            }
            trace("  " + kind + ": " + possible + " pairs, " + collisions + " collide, " + boxTests + " tests of boxes");
            assertTrue("some collide, some don't", collisions > 10 && collisions < possible);
        }

        private static function worldStructure(greatLand:GreatLand, agent:Agent):BoundingStructure
        {
            return TransformedStructure.of(greatLand.boundingStructures.tightestFit(agent.shape), agent);
        }

        private static function box(name:String, x:Number, y:Number, z:Number):Model
        {
            var corners:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < 8; i++)
            {
                corners.push(i & 1 ? x : 0, i & 2 ? y : 0, i & 4 ? z : 0);
            }
            return new Model(name, corners);
        }

        // A rod with round ends: what a capsule fits best.
        private static function pole():Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            for (var ring:int = 0; ring <= 8; ring++)
            {
                var angle:Number = Math.PI / 2 * ring / 8;
                for (var i:int = 0; i < 24; i++)
                {
                    var x:Number = Math.cos(angle) * Math.cos(i * Math.PI / 12);
                    var y:Number = Math.cos(angle) * Math.sin(i * Math.PI / 12);
                    vertices.push(x, y, 2 + Math.sin(angle), x, y, -2 - Math.sin(angle));
                }
            }
            return new Model("pole", vertices);
        }
    }
}
