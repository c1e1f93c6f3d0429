package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import flash.utils.getTimer;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.RayHit;
    import support.EachCollider;
    import support.Fixtures;

    /** What the first hit of a ray costs at one model, by each collision system, and how long the first such question takes. */
    public class RayBenchmark
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/dragon.dae"];

        private static const ROUNDS:int = 7;
        private static const RAYS:int = 500;
        private static const RINGS:int = 1000;
        private static const SIDES:int = 200;

        private var _all:Vector.<Measurement> = new Vector.<Measurement>();
        private var _names:Array = [];
        private var _triangles:Array = [];
        private var _firsts:Array = [];
        private var _hits:Array = [];

        /** The table. */
        public function run():String
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.orientedBoxDegIncrement = 45;
            for each (var model:Model in [new ObjModel("bear", Fixtures.text(FIXTURES[0])), new ColladaModel("dragon", Fixtures.text(FIXTURES[1])), torus()])
            {
                greatLand.addModel(model);
                for each (var system:String in ["tightest fits", "hierarchies", "triangles"])
                {
                    add(model, system, EachCollider.make(system, greatLand));
                }
            }
            Measurement.runAll(_all, ROUNDS);
            var table:Table = new Table("first hits of rays", "triangles", "ns a ray", "first ray ms", "hits of " + RAYS);
            for (var i:int = 0; i < _all.length; i++)
            {
                table.add(_names[i], _triangles[i], _all[i].nanoseconds.toFixed(0), _firsts[i], _hits[i]);
            }
            return String(table);
        }

        private function add(model:Model, system:String, collider:Collider):void
        {
            var random:SeededRandom = new SeededRandom(2241);
            var origins:Vector.<Vector3D> = new Vector.<Vector3D>();
            var directions:Vector.<Vector3D> = new Vector.<Vector3D>();
            for (var i:int = 0; i < RAYS; i++)
            {
                var origin:Vector3D = new Vector3D(random.normal(), random.normal(), random.normal());
                origin.normalize();
                origin.scaleBy(2);
                origin.z += 0.4;
                origins.push(origin);
                directions.push(new Vector3D(random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(0, 0.7)).subtract(origin));
            }
            var queries:AgentQueries = new AgentQueries(collider);
            queries.update(new <Agent>[new Agent(model.name)]);
            var hit:RayHit = new RayHit();
            var hits:int = 0;
            var start:int = getTimer();
            queries.cast(new Vector3D(-3, 0.1, 0.1), Vector3D.X_AXIS);
            _firsts.push(getTimer() - start);
            for (i = 0; i < RAYS; i++)
            {
                hits += queries.cast(origins[i], directions[i]) == null ? 0 : 1;
            }
            _hits.push(hits);
            _names.push(model.name + ", " + system);
            _triangles.push(model.triangles.length / 3);
            _all.push(new Measurement(model.name, function():void
                    {
                        for (var j:int = 0; j < RAYS; j++)
                        {
                            queries.cast(origins[j], directions[j], Infinity, null, hit);
                        }
                    }, RAYS));
        }

        private static function torus():Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < RINGS; i++)
            {
                for (var j:int = 0; j < SIDES; j++)
                {
                    var around:Number = 2 * Math.PI * i / RINGS;
                    var across:Number = 2 * Math.PI * j / SIDES;
                    var radius:Number = 0.35 + 0.15 * Math.cos(across);
                    vertices.push(radius * Math.cos(around), radius * Math.sin(around), 0.15 + 0.15 * Math.sin(across));
                    var next:int = (i + 1) % RINGS * SIDES;
                    var up:int = (j + 1) % SIDES;
                    triangles.push(i * SIDES + j, next + j, next + up, i * SIDES + j, next + up, i * SIDES + up);
                }
            }
            return new Model("torus", vertices, triangles);
        }
    }
}
