package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.pairs.SeededRandom;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import starlogo.models.ObjModel;
    import support.EachCollider;
    import support.Fixtures;

    /**
     * What contacts cost: 100 bears that stand close, or all in one place, each turned another way; frames with handlers that take none, and that
     * take one for each pair.
     */
    public class ContactsBenchmark
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        private static const ROUNDS:int = 9;
        private static const COUNT:int = 100;

        private var _greatLand:GreatLand = new GreatLand();
        private var _table:Table = new Table("100 bears", "pairs", "ms without", "ms with contacts", "us a pair", "us a contact", "ratio");

        /** The table. */
        public function run():String
        {
            _greatLand.prepareExact = true;
            _greatLand.addModel(new ObjModel("bear", Fixtures.text("/assets/bear.obj")));
            measure("close", 7);
            measure("in one place", 0.3);
            return String(_table);
        }

        private function measure(name:String, width:Number):void
        {
            var random:SeededRandom = new SeededRandom(2202);
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < COUNT; i++)
            {
                var bear:Agent = new Agent("bear");
                bear.heading = random.between(0, 360);
                bear.moveTo(random.between(0, width), random.between(0, width), 0);
                agents.push(bear);
            }
            for each (var system:String in EachCollider.NAMES)
            {
                var collider:Collider = EachCollider.make(system, _greatLand);
                var pairs:int = collider.findCollisions(agents).length / 2;
                var without:Measurement = frames(collider, agents, function(a:Agent, b:Agent):void
                    {
                    });
                var withContacts:Measurement = frames(collider, agents, function(a:Agent, b:Agent, contact:Contact):void
                    {
                    });
                var measurements:Vector.<Measurement> = new <Measurement>[without, withContacts];
                Measurement.runAll(measurements, ROUNDS);
                var more:Number = withContacts.nanoseconds - without.nanoseconds;
                _table.add(name + ": " + system, pairs, (without.nanoseconds / 1e6).toFixed(3), (withContacts.nanoseconds / 1e6).toFixed(3),
                        (without.nanoseconds / 1e3 / pairs).toFixed(2), (more / 1e3 / pairs).toFixed(2),
                        withContacts.timesAsLongAs(without).toFixed(1));
            }
        }

        private static function frames(collider:Collider, agents:Vector.<Agent>, handler:Function):Measurement
        {
            var collision:Collision = new Collision(collider);
            collision.onCollision("turtles", "turtles", handler);
            return new Measurement("frames", function():void
                {
                    for each (var agent:Agent in agents)
                    {
                        agent.moveTo(agent.x, agent.y, agent.z + 1e-9);
                    }
                    collision.update(agents);
                }, 1);
        }
    }
}
