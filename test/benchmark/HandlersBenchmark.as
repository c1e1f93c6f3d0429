package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.scenes.Scene;
    import evaluation.scenes.Scenes;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import starlogo.models.BuiltInModel;

    /**
     * What the calls of handlers cost: 100 unit spheres of two breeds in one place, so that 4,950 pairs make 9,900 calls a frame, with
     * handlers that do little, change breeds, ask for contacts or starts and ends, or take agents out of the list.
     */
    public class HandlersBenchmark
    {
        private static const ROUNDS:int = 15;
        private static const COUNT:int = 100;
        private static const BREEDS:Array = ["bears", "balls", "bees"];

        private var _greatLand:GreatLand = new GreatLand();
        private var _calls:int = 0;
        private var _agents:Vector.<Agent>;

        /** The table. */
        public function run():String
        {
            _greatLand.addModel(BuiltInModel.sphere());
            var table:Table = new Table("100 agents, 9,900 calls", "ms", "to the search alone");
            var search:Measurement = searchAlone();
            var names:Array = ["calls", "one breed changes", "100 breeds change", "every call changes a breed", "contacts", "starts and ends",
                    "10 are taken out"];
            var all:Vector.<Measurement> = new <Measurement>[search, frame(count), frame(changeOne), frame(changeSome), frame(change),
                    frame(countContacts), frame(count, true), frame(takeOut)];
            Measurement.runAll(all, ROUNDS);
            table.add("the search alone", (search.nanoseconds / 1e6).toFixed(3), "");
            for (var i:int = 1; i < all.length; i++)
            {
                table.add(names[i - 1], (all[i].nanoseconds / 1e6).toFixed(3), all[i].timesAsLongAs(search).toFixed(2));
            }
            return String(table);
        }

        private function searchAlone():Measurement
        {
            var collider:BinCollider = new BinCollider(_greatLand);
            var scene:Scene = sceneOfBreeds();
            var found:Vector.<Agent> = new Vector.<Agent>();
            return new Measurement("search", function():void
                {
                    scene.step();
                    collider.findCollisions(scene.agents, found);
                }, 1);
        }

        private function frame(handler:Function, tracks:Boolean = false):Measurement
        {
            var collision:Collision = new Collision(new BinCollider(_greatLand));
            var scene:Scene = sceneOfBreeds();
            var all:Vector.<Agent> = scene.agents.concat();
            for each (var breed:String in BREEDS)
            {
                for each (var other:String in BREEDS)
                {
                    collision.onCollision(breed, other, handler);
                    if (tracks)
                    {
                        collision.onCollisionStart(breed, other, handler);
                        collision.onCollisionEnd(breed, other, handler);
                    }
                }
            }
            return new Measurement("frame", function():void
                {
                    _calls = 0;
                    _agents = scene.agents;
                    scene.agents.length = 0;
                    for each (var agent:Agent in all)
                    {
                        scene.agents.push(agent);
                    }
                    scene.step();
                    collision.update(scene.agents);
                }, 1);
        }

        private static function sceneOfBreeds():Scene
        {
            var scene:Scene = Scenes.crowd(COUNT, "spheres");
            for (var i:int = 0; i < COUNT; i++)
            {
                scene.agents[i].breed = BREEDS[i % 2];
            }
            return scene;
        }

        private function count(collider:Agent, collidee:Agent):void
        {
            collider.color++;
        }

        private function countContacts(collider:Agent, collidee:Agent, contact:Contact):void
        {
            collider.color++;
        }

        private function changeOne(collider:Agent, collidee:Agent):void
        {
            _calls++;
            if (_calls == 1)
            {
                change(collider, collidee);
            }
        }

        private function changeSome(collider:Agent, collidee:Agent):void
        {
            _calls++;
            if (_calls % 100 == 1)
            {
                change(collider, collidee);
            }
        }

        private function change(collider:Agent, collidee:Agent):void
        {
            collider.breed = collider.breed == "bears" ? "balls" : "bears";
        }

        private function takeOut(collider:Agent, collidee:Agent):void
        {
            _calls++;
            if (_calls % 500 == 1)
            {
                _agents.splice(_agents.indexOf(collidee), 1);
            }
        }
    }
}
