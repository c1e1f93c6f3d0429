package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.literal.LiteralHierarchicalCollider;
    import evaluation.scenes.Scene;
    import evaluation.scenes.Scenes;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.ColladaModel;
    import starlogo.models.ObjModel;
    import support.Fixtures;

    /**
     * The thesis's crowd of 100 bears, all colliding (§6.1), by hierarchies (§6.3.4) and with one hierarchical main character
     * (§5.1); and ten pairs of dragons whose surfaces touch, are a hair's breadth apart, or overlap, decided exactly.
     */
    public class HierarchicalCrowdBenchmark
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/dragon.dae"];

        private static const ROUNDS:int = 9;
        private static const COUNT:int = 100;
        private static const LITERAL_PAIRS:int = 100;
        private static const PAIRS:int = 10;
        private static const HAIR:Number = 0.001;

        private var _greatLand:GreatLand = new GreatLand();
        private var _scene:Scene;
        private var _found:Vector.<Agent> = new Vector.<Agent>();
        private var _table:Table = new Table("a frame", "ms", "ratio", "to", "visits a pair", "thesis ms");

        /** The table. */
        public function run():String
        {
            _greatLand.loadTightestFit = false;
            _greatLand.addModel(new ColladaModel("dragon", Fixtures.text("/assets/dragon.dae")));
            _greatLand.loadTightestFit = true;
            _greatLand.addModel(new ObjModel("bear", Fixtures.text("/assets/bear.obj")));
            _scene = Scenes.crowd(COUNT, "bears");
            measureCrowd("bears that look one way");
            for (var i:int = 0; i < COUNT; i++)
            {
                _scene.agents[i].heading = i * 137.5;
                _scene.agents[i].x += (i % 10) * 0.02;
            }
            measureCrowd("bears that look elsewhere");
            for (i = 0; i < COUNT; i++)
            {
                _scene.agents[i].pitch = i * 0.7;
            }
            measureCrowd("bears that lean");
            measureDragons();
            return String(_table);
        }

        private function measureCrowd(name:String):void
        {
            var hierarchical:HierarchicalCollider = new HierarchicalCollider(_greatLand);
            var combination:CombinationCollider = new CombinationCollider(_greatLand);
            var tightest:Measurement = crowd(new TightestFitCollider(_greatLand));
            var literally:Measurement = literalPairs();
            _scene.agents[COUNT / 2].hierarchical = true;
            var all:Vector.<Measurement> = new <Measurement>[tightest, crowd(hierarchical), crowd(combination), literally];
            Measurement.runAll(all, ROUNDS);
            _table.add(name + ": TightestFitCollider", ms(tightest), "", "", "", "1300");
            _table.add(name + ": HierarchicalCollider", ms(all[1]), ratio(all[1], tightest), "TightestFitCollider", visits(hierarchical), "7500");
            _table.add(name + ": CombinationCollider, one is hierarchical", ms(all[2]), ratio(all[2], tightest), "TightestFitCollider",
                    visits(combination), "");
            var part:Number = COUNT * (COUNT - 1) / 2 / LITERAL_PAIRS;
            _table.add(name + ": the literal traversal", (part * literally.nanoseconds / 1e6).toFixed(0),
                    (part * literally.nanoseconds / all[1].nanoseconds).toFixed(1), "HierarchicalCollider", "", "7500");
        }

        private function crowd(collider:CollisionSystem):Measurement
        {
            return new Measurement("", function():void
                {
                    _scene.step();
                    collider.findCollisions(_scene.agents, _found);
                    requireAll(_found.length / 2, COUNT * (COUNT - 1) / 2);
                }, 1);
        }

        // A part of the pairs, since the player does not collect within a call what this allocates.
        private function literalPairs():Measurement
        {
            var collider:LiteralHierarchicalCollider = new LiteralHierarchicalCollider(_greatLand.hierarchies);
            return new Measurement("", function():void
                {
                    var hits:int = 0;
                    for (var i:int = 0; i < LITERAL_PAIRS; i++)
                    {
                        hits += collider.areColliding(_scene.agents[i % 10], _scene.agents[10 + int(i / 10)]) ? 1 : 0;
                    }
                    requireAll(hits, LITERAL_PAIRS);
                }, 1);
        }

        private function measureDragons():void
        {
            var collider:HierarchicalCollider = new HierarchicalCollider(_greatLand);
            collider.exact = true;
            var apart:Vector.<Agent> = new Vector.<Agent>();
            var touching:Vector.<Agent> = new Vector.<Agent>();
            var overlapping:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < PAIRS; i++)
            {
                var reach:Number = touchingDistance(collider, i);
                apart.push(dragon(i, 0, 0), dragon(i, 1, reach + HAIR));
                touching.push(dragon(i, 0, 0), dragon(i, 1, reach - 1e-9));
                overlapping.push(dragon(i, 0, 0), dragon(i, 1, reach - 0.1));
            }
            var all:Vector.<Measurement> = new <Measurement>[dragons(collider, touching, PAIRS), dragons(collider, apart, 0),
                    dragons(collider, overlapping, PAIRS)];
            Measurement.runAll(all, ROUNDS);
            addDragons("10 exact pairs of dragons that touch", all[0], collider, touching);
            addDragons("10 exact pairs of dragons, " + HAIR + " apart", all[1], collider, apart);
            addDragons("10 exact pairs of dragons, 0.1 into each other", all[2], collider, overlapping);
        }

        private function addDragons(name:String, measurement:Measurement, collider:HierarchicalCollider, agents:Vector.<Agent>):void
        {
            collider.findCollisions(agents, _found);
            _table.add(name, ms(measurement), "", "", visits(collider) + " and " + collider.statistics.triangleTests / PAIRS + " triangles", "");
        }

        private function dragons(collider:HierarchicalCollider, agents:Vector.<Agent>, pairs:int):Measurement
        {
            return new Measurement("", function():void
                {
                    for (var i:int = 0; i < agents.length; i++)
                    {
                        agents[i].x = agents[i].x;
                    }
                    collider.findCollisions(agents, _found);
                    requireAll(_found.length / 2, pairs);
                }, 1);
        }

        // How far apart along x the two of a pair are when their surfaces just meet.
        private static function touchingDistance(collider:HierarchicalCollider, pair:int):Number
        {
            var near:Number = 0;
            var far:Number = 3;
            while (far - near > 1e-10)
            {
                var middle:Number = (near + far) / 2;
                if (collider.areColliding(dragon(pair, 0, 0), dragon(pair, 1, middle)))
                {
                    near = middle;
                }
                else
                {
                    far = middle;
                }
            }
            return near;
        }

        private static function dragon(pair:int, side:int, distance:Number):Agent
        {
            var agent:Agent = new Agent("dragon");
            agent.moveTo(10 * pair + distance, side * 0.1, side * 0.07);
            agent.heading = 41 * pair + 100 * side;
            agent.pitch = side * 13 * pair;
            return agent;
        }

        private static function requireAll(hits:int, pairs:int):void
        {
            if (hits != pairs)
            {
                throw new Error(pairs + " pairs must collide, but " + hits + " do");
            }
        }

        private static function visits(collider:CollisionSystem):String
        {
            return (collider.statistics.nodeVisits / collider.statistics.hierarchyTests).toFixed(1);
        }

        private static function ms(measurement:Measurement):String
        {
            return (measurement.nanoseconds / 1e6).toFixed(2);
        }

        private static function ratio(measurement:Measurement, to:Measurement):String
        {
            return (measurement.nanoseconds / to.nanoseconds).toFixed(2);
        }
    }
}
