package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import starlogo.search.BaseShapeChoice;
    import starlogo.search.NarrowPhase;
    import starlogo.search.pairs.StructurePairTests;
    import starlogo.search.SphereChoice;
    import starlogo.search.TightestFitChoice;
    import starlogo.search.TreeChoice;
    import support.AskedDistance;
    import support.DistanceReference;
    import support.Effort;
    import support.Fixtures;
    import support.FrameByFrame;
    import support.SolidModels;

    use namespace engine;

    /**
     * How far agents are apart in every system, against every pair of nodes or triangles; 0 where they touch, and only there; the same in either
     * order; the points, each on its shape; and never more than a greater depth says, or triangles.
     */
    public class RowDistancesTest
    {
        public static const FIXTURES:Array = ["/assets/kelp.obj", "/assets/bear.obj"];

        private static const PRECISION:Number = 1e-12;

        private static var sGreatLand:GreatLand;
        private static var sNames:Array;

        private var _random:SeededRandom = new SeededRandom(2222);
        private var _touching:int;
        private var _apart:int;

        [BeforeClass]
        public static function load():void
        {
            sNames = [];
            var models:Array = SolidModels.all().concat(BuiltInModel.cylinder());
            models.push(new ObjModel("kelp", Fixtures.text(FIXTURES[0])), new ObjModel("bear", Fixtures.text(FIXTURES[1])), cloud());
            for each (var model:Model in models)
            {
                sNames.push(model.name);
            }
            sGreatLand = new GreatLand();
            sGreatLand.orientedBoxDegIncrement = 45;
            for each (model in models)
            {
                sGreatLand.addModel(model);
            }
        }

        [Test(async, timeout="3600000")]
        public function structures():void
        {
            var systems:Array = [];
            for each (var choice:BaseShapeChoice in [new SphereChoice(sGreatLand), new TightestFitChoice(sGreatLand)])
            {
                var pairs:NarrowPhase = new NarrowPhase(choice);
                choice.addTests(pairs);
                StructurePairTests.addTo(pairs);
                systems.push(new AskedDistance(pairs));
            }
            FrameByFrame.repeat(this, Effort.choose(800, 40000), function(i:int):void
                {
                    check(systems[i % 2], agent(), agent(), "pair " + i);
                }, assertMixed);
        }

        [Test(async, timeout="3600000")]
        public function trees():void
        {
            var choice:BaseShapeChoice = new TreeChoice(sGreatLand);
            var pairs:NarrowPhase = new NarrowPhase(choice);
            choice.addTests(pairs);
            var asked:AskedDistance = new AskedDistance(pairs);
            var reference:DistanceReference = new DistanceReference(sGreatLand);
            FrameByFrame.repeat(this, Effort.choose(180, 9000), function(i:int):void
                {
                    pairs.treeLimits.maxDepth = _random.integer(1, 6);
                    var a:Agent = agent();
                    var b:Agent = agent();
                    if (_random.chance(0.3))
                    {
                        b.traversalDepth = _random.integer(1, 8);
                    }
                    check(asked, a, b, "pair " + i);
                    if (!asked.areTouching)
                    {
                        var depthB:int = b.traversalDepth || pairs.treeLimits.maxDepth;
                        var least:Number = reference.ofNodes(a, pairs.treeLimits.maxDepth, b, depthB);
                        assertNear("pair " + i, least, asked.closest.distance, a, b);
                    }
                    var slack:Number = PRECISION * sizeOf(a, b);
                    var offA:Number = reference.fromNodes(a, pairs.treeLimits.maxDepth, asked.pointA);
                    var offB:Number = reference.fromNodes(b, b.traversalDepth || pairs.treeLimits.maxDepth, asked.pointB);
                    assertTrue("pair " + i + ": points " + offA + " and " + offB + " off", arePoints(asked, offA, offB, slack));
                }, assertMixed);
        }

        [Test(async, timeout="3600000")]
        public function triangles():void
        {
            var choice:BaseShapeChoice = new TreeChoice(sGreatLand);
            var pairs:NarrowPhase = new NarrowPhase(choice);
            choice.addTests(pairs);
            pairs.treeLimits.isExact = true;
            var asked:AskedDistance = new AskedDistance(pairs);
            var reference:DistanceReference = new DistanceReference(sGreatLand);
            FrameByFrame.repeat(this, Effort.choose(60, 3000), function(i:int):void
                {
                    var a:Agent = agent(["sphere", "cube"].concat(SolidModels.NAMES));
                    var b:Agent = agent(["sphere", "cube", "cylinder", "kelp"]);
                    check(asked, a, b, "pair " + i);
                    if (!asked.areTouching)
                    {
                        assertNear("pair " + i, reference.ofTriangles(a, b), asked.closest.distance, a, b);
                    }
                    var offA:Number = reference.fromTriangles(a, asked.pointA);
                    var offB:Number = reference.fromTriangles(b, asked.pointB);
                    assertTrue("pair " + i + ": points " + offA + " and " + offB + " off", arePoints(asked, offA, offB, PRECISION * sizeOf(a, b)));
                }, assertMixed);
        }

        [Test(async, timeout="3600000")]
        public function ballsAndTreesOrTriangles():void
        {
            var choice:BaseShapeChoice = new TreeChoice(sGreatLand, new TightestFitChoice(sGreatLand));
            var pairs:NarrowPhase = new NarrowPhase(choice);
            choice.addTests(pairs);
            var asked:AskedDistance = new AskedDistance(pairs);
            var reference:DistanceReference = new DistanceReference(sGreatLand);
            var fit:BoundingStructure = sGreatLand.boundingStructures.tightestFit("sphere");
            FrameByFrame.repeat(this, Effort.choose(120, 6000), function(i:int):void
                {
                    pairs.treeLimits.isExact = i % 2 == 0;
                    pairs.treeLimits.maxDepth = _random.integer(1, 6);
                    var a:Agent = agent(["cube", "kelp"].concat(SolidModels.NAMES));
                    var ball:Agent = agent(["sphere"]);
                    a.hierarchical = true;
                    check(asked, a, ball, "pair " + i);
                    if (!asked.areTouching)
                    {
                        var placed:Sphere = Sphere(fit.place(ball.freshPlacement()));
                        var fromCenter:Number = pairs.treeLimits.isExact ? reference.fromTriangles(a, placed.center)
                            : reference.fromNodes(a, pairs.treeLimits.maxDepth, placed.center);
                        assertNear("pair " + i, fromCenter - placed.radius, asked.closest.distance, a, ball);
                    }
                }, assertMixed);
        }

        // Two orders, touching, and the points.
        private function check(asked:AskedDistance, a:Agent, b:Agent, pair:String):void
        {
            var what:String = pair + ", " + a.shape + " and " + b.shape;
            var there:Number = asked.between(b, a);
            var pointOfB:Vector3D = asked.pointA;
            var distance:Number = asked.between(a, b);
            assertEquals(what + ", in the other order", distance, there);
            assertTrue(what + ": the same points", pointOfB.equals(asked.pointB));
            assertEquals(what + ": " + distance, asked.areTouching, distance == 0);
            var slack:Number = PRECISION * sizeOf(a, b);
            if (distance == 0)
            {
                assertTrue(what + ": one point", asked.pointA.equals(asked.pointB));
                _touching++;
            }
            else
            {
                assertTrue(what + ": as far apart: " + (Vector3D.distance(asked.pointA, asked.pointB) - distance),
                        Math.abs(Vector3D.distance(asked.pointA, asked.pointB) - distance) <= slack);
                _apart++;
            }
        }

        private function assertNear(what:String, expected:Number, actual:Number, a:Agent, b:Agent):void
        {
            var slack:Number = PRECISION * sizeOf(a, b);
            assertTrue(what + ", " + a.shape + " and " + b.shape + ": " + actual + " is not " + expected,
                    Math.abs(actual - expected) <= slack);
        }

        // Each on its model; or, if one is inside of the other, on the inner one.
        private static function arePoints(asked:AskedDistance, offA:Number, offB:Number, slack:Number):Boolean
        {
            return offA <= slack && offB <= slack || asked.areTouching && (offA <= slack || offB <= slack);
        }

        private function assertMixed():void
        {
            assertTrue(_touching + " touch, " + _apart + " do not", _touching > 0.1 * _apart && _apart > 0.3 * _touching);
        }

        private static function sizeOf(a:Agent, b:Agent):Number
        {
            return 3 * (a.size + b.size) + Math.abs(a.x) + Math.abs(a.y) + Math.abs(a.z) + Math.abs(b.x) + Math.abs(b.y) + Math.abs(b.z);
        }

        // Somewhere about the origin, or about a place far away.
        private function agent(names:Array = null):Agent
        {
            var agent:Agent = new Agent(_random.pick(names || sNames));
            agent.size = _random.pick([1, 1, _random.logBetween(1e-3, 1e3)]);
            agent.heading = _random.pick([0, 90, _random.between(0, 360)]);
            if (_random.chance(0.5))
            {
                agent.pitch = _random.between(0, 360);
                agent.roll = _random.between(0, 360);
            }
            var spread:Number = _random.pick([0.3, 1, 1, 5, 100]);
            agent.moveTo(spread * _random.normal(), spread * _random.normal(), spread * _random.normal());
            return agent;
        }

        // Vertices without triangles.
        private static function cloud():Model
        {
            var random:SeededRandom = new SeededRandom(5);
            var vertices:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < 300; i++)
            {
                vertices.push(random.normal());
            }
            return new Model("cloud", vertices);
        }
    }
}
