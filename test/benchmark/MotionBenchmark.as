package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.pairs.SeededRandom;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ObjModel;
    import support.EachCollider;
    import support.Fixtures;

    /**
     * What sweeping, contacts, and starts and ends of touches cost: a frame of 1,000 agents that walk about on SpaceLand, 0.3 patches a
     * frame, each pair with a handler, against the same frame without.
     */
    public class MotionBenchmark
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        private static const ROUNDS:int = 15;
        private static const COUNT:int = 1000;
        private static const STEP:Number = 0.3;
        private static const HALF_WIDTH:Number = 50;

        private var _greatLand:GreatLand = new GreatLand();

        /** The table. */
        public function run():String
        {
            _greatLand.addModel(new ObjModel("bear", Fixtures.text("/assets/bear.obj")));
            _greatLand.addModel(BuiltInModel.sphere());
            _greatLand.addModel(BuiltInModel.cube());
            var table:Table = new Table("1,000 agents", "ms", "one sweeps", "100 sweep", "all sweep", "contacts", "start, end", "all of it");
            for each (var name:String in ["bins", "tightest fits", "hierarchies", "combinations"])
            {
                addRow(table, name);
            }
            return String(table);
        }

        private function addRow(table:Table, name:String):void
        {
            var plain:Measurement = frame(name, 0, false, false);
            var all:Vector.<Measurement> = new <Measurement>[plain, frame(name, 1, false, false), frame(name, 100, false, false),
                    frame(name, COUNT, false, false), frame(name, 0, true, false), frame(name, 0, false, true),
                    frame(name, COUNT, true, true)];
            Measurement.runAll(all, ROUNDS);
            var cells:Array = [name, (plain.nanoseconds / 1e6).toFixed(3)];
            for (var i:int = 1; i < all.length; i++)
            {
                cells.push(all[i].timesAsLongAs(plain).toFixed(2));
            }
            table.add.apply(table, cells);
        }

        // Each with agents of its own, and a collider of its own: it looks through the list for agents that sweep.
        private function frame(name:String, sweeping:int, takesContacts:Boolean, tracks:Boolean):Measurement
        {
            var agents:Vector.<Agent> = walkers(sweeping);
            var collision:Collision = new Collision(EachCollider.make(name, _greatLand));
            var calls:int = 0;
            if (takesContacts)
            {
                collision.onCollision("turtles", "turtles", function(a:Agent, b:Agent, contact:Contact):void
                    {
                        calls++;
                    });
            }
            else
            {
                collision.onCollision("turtles", "turtles", count);
            }
            if (tracks)
            {
                collision.onCollisionStart("turtles", "turtles", count);
                collision.onCollisionEnd("turtles", "turtles", count);
            }
            return new Measurement("a frame", function():void
                {
                    step(agents);
                    collision.update(agents);
                }, 1);

            function count(a:Agent, b:Agent):void
            {
                calls++;
            }
        }

        private static function walkers(sweeping:int):Vector.<Agent>
        {
            var random:SeededRandom = new SeededRandom(801);
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < COUNT; i++)
            {
                var agent:Agent = new Agent(random.pick(["bear", "sphere", "cube"]));
                agent.moveTo(random.between(-HALF_WIDTH, HALF_WIDTH), random.between(-HALF_WIDTH, HALF_WIDTH), 0);
                agent.heading = random.between(0, 360);
                agent.sweeps = i < sweeping;
                agent.hierarchical = i % 20 == 0;
                agents.push(agent);
            }
            return agents;
        }

        // Straight on, and round where SpaceLand ends.
        private static function step(agents:Vector.<Agent>):void
        {
            for (var i:int = 0; i < agents.length; i++)
            {
                var agent:Agent = agents[i];
                var angle:Number = agent.heading * Math.PI / 180;
                var x:Number = agent.x + STEP * Math.cos(angle);
                var y:Number = agent.y + STEP * Math.sin(angle);
                if (x > HALF_WIDTH || x < -HALF_WIDTH || y > HALF_WIDTH || y < -HALF_WIDTH)
                {
                    agent.heading += 137.5;
                }
                else
                {
                    agent.moveTo(x, y, 0);
                }
            }
        }
    }
}
