package starlogo.agents
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import starlogo.GreatLand;
    import starlogo.blocks.CollisionBlocks;
    import starlogo.blocks.DetectionBlocks;
    import starlogo.blocks.StructureBlocks;
    import starlogo.blocks.TraitBlocks;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.diagnostics.CollisionRecorder;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;
    import starlogo.search.BreedInterests;
    import starlogo.terrain.Terrain;
    import support.assertThrows;
    import support.create;
    import support.landOf;

    use namespace engine;

    /** A breed's name may be any text: what objects have as properties too, and what differs by a space. */
    public class BreedsTest
    {
        private static const NAMES:Array = ["hasOwnProperty", "toString", "constructor", "__proto__", "valueOf", "isPrototypeOf", "propertyIsEnumerable",
                "_x", " _x", "x", ":x", "::x", "length", "0", "-1", "null", "undefined", "__count__", "tr\u00e9s", "\u2603", " ", "cats"];

        private var _agents:Vector.<Agent> = new Vector.<Agent>();

        // Two of each breed, one upon the other; the breeds are far apart.
        [Before]
        public function setUp():void
        {
            for (var i:int = 0; i < 2 * NAMES.length; i++)
            {
                var agent:Agent = new Agent("sphere", NAMES[i >> 1]);
                agent.moveTo(10 * (i >> 1), 0, 0);
                _agents.push(agent);
            }
        }

        [Test]
        public function everyNameHasANumber():void
        {
            for each (var name:String in NAMES)
            {
                var number:int = Breeds.NAMES.numberOf(name);
                assertEquals(name, Breeds.NAMES.nameOf(number));
                assertEquals(name, number, Breeds.NAMES.numberOf(name));
                assertEquals(name, number, new Agent("sphere", name).breedNumber);
            }
            var agent:Agent = _agents[0];
            var count:int = Breeds.NAMES.count;
            agent.breed = "cats";
            assertEquals(_agents[_agents.length - 1].breedNumber, agent.breedNumber);
            assertEquals(count, Breeds.NAMES.count);
        }

        [Test]
        public function noLookUpMakesABreed():void
        {
            var collision:Collision = new Collision(new BinCollider());
            collision.onCollision("cats", Collision.ANY_BREED, log([]));
            collision.update(_agents);
            var interests:BreedInterests = new BreedInterests();
            interests.add("cats", BreedInterests.ANY_BREED);
            var queries:AgentQueries = new AgentQueries(collision);
            queries.update(_agents);
            var filter:AgentFilter = new AgentFilter();
            filter.exceptBreeds = new <String>["unknown to filters"];
            var count:int = Breeds.NAMES.count;
            assertFalse(collision.removeHandler("unknown", "unknown to handlers", log([])));
            assertEquals("as any other breed", Breeds.ANY_NUMBER, interests.indexOf("unknown to interests"));
            assertEquals(-1, new BreedInterests().indexOf("unknown to interests"));
            assertEquals(0, queries.countNear(_agents[0], Infinity, AgentFilter.ofBreeds("unknown to questions")));
            assertEquals(_agents.length - 1, queries.countNear(_agents[0], Infinity, filter));
            assertEquals(count, Breeds.NAMES.count);
        }

        [Test]
        public function aLookUpAddsNoName():void
        {
            var collision:Collision = new Collision(new BinCollider());
            var ground:Agent = new Terrain(2, 2).agent;
            var count:int = Breeds.NAMES.count;
            assertFalse(collision.removeHandler("a breed that nothing has", "nor this", log([])));
            assertFalse(collision.removeHandler("a breed that nothing has", Collision.ANY_BREED, log([])));
            assertThrows(ArgumentError, /breed must not be "another that nothing has"/, setBreed, ground, "another that nothing has");
            assertEquals(count, Breeds.NAMES.count);
            assertEquals(-1, Breeds.NAMES.knownNumberOf("nor this"));
            assertEquals(_agents[0].breedNumber, Breeds.NAMES.knownNumberOf(_agents[0].breed));
        }

        [Test]
        public function filtersTellThemApart():void
        {
            var queries:AgentQueries = new AgentQueries(new BinCollider());
            queries.update(_agents);
            var asker:Agent = new Agent("sphere", "askers");
            for (var i:int = 0; i < NAMES.length; i++)
            {
                var filter:AgentFilter = AgentFilter.ofBreeds(NAMES[i]);
                assertEquals(NAMES[i], 2, queries.countNear(asker, Infinity, filter));
                assertEquals(NAMES[i], _agents[2 * i], queries.nearest(asker, Infinity, filter));
                assertEquals(NAMES[i], 2, queries.castAll(asker.transform.position, _agents[_agents.length - 1].transform.position, Infinity, filter).length);
                filter = new AgentFilter();
                filter.exceptBreeds = new <String>[NAMES[i]];
                assertEquals(NAMES[i], _agents.length - 2, queries.near(asker, Infinity, filter).length);
            }
            // changed, after questions
            _agents[0].breed = "__proto__";
            assertEquals(3, queries.countNear(asker, Infinity, AgentFilter.ofBreeds("__proto__")));
            assertEquals(1, queries.countNear(asker, Infinity, AgentFilter.ofBreeds(NAMES[0])));
            assertEquals(0, queries.countNear(asker, Infinity, AgentFilter.ofBreeds("of none")));
        }

        [Test]
        public function filtersTakeNamesAlone():void
        {
            assertThrows(ArgumentError, /takes names, one after the other, not the list or object cats,dogs$/, AgentFilter.ofBreeds, ["cats", "dogs"]);
            assertThrows(ArgumentError, /not the list or object cats$/, AgentFilter.ofBreeds, new <String>["cats"]);
            assertThrows(ArgumentError, /not 5$/, AgentFilter.ofBreeds, "cats", 5);
            assertThrows(ArgumentError, /not null$/, AgentFilter.ofBreeds, null);
            assertThrows(ArgumentError, /not true$/, AgentFilter.ofBreeds, true);
            assertEquals(0, AgentFilter.ofBreeds().breeds.length);
        }

        [Test]
        public function handlersTellThemApart():void
        {
            for each (var isWithAny:Boolean in [false, true])
            {
                var recorder:CollisionRecorder = new CollisionRecorder(new BinCollider());
                var collision:Collision = new Collision(recorder);
                var called:Array = [];
                var started:Array = [];
                for each (var name:String in NAMES)
                {
                    collision.onCollision(name, name, log(called));
                    collision.onCollisionStart(name, isWithAny ? Collision.ANY_BREED : name, log(started));
                }
                collision.update(_agents);
                collision.update(_agents);
                var once:Array = [];
                var each:Array = [];
                for each (name in NAMES)
                {
                    once.push(name, name);
                    each.push(name, name);
                }
                assertEquals(each.concat(each).sort().join(), called.sort().join());
                assertEquals(once.sort().join(), started.sort().join());
                assertEquals(NAMES.length, recorder.toObject().breeds.length);
            }
        }

        [Test]
        public function blocksTellThemApart():void
        {
            var greatLand:GreatLand = landOf(BuiltInModel.sphere());
            var collisions:CollisionBlocks = new CollisionBlocks(greatLand, _agents);
            var detection:DetectionBlocks = new DetectionBlocks(collisions);
            detection.update();
            var traits:TraitBlocks = new TraitBlocks(_agents);
            var structures:StructureBlocks = new StructureBlocks(collisions);
            for (var i:int = 0; i < NAMES.length; i++)
            {
                assertEquals(NAMES[i], 1, detection.countWithin(_agents[2 * i], NAMES[i], 1000));
                traits.setCollisionDepth(NAMES[i], i + 1);
                structures.show(NAMES[i], i % 2 == 0);
            }
            for (i = 0; i < _agents.length; i++)
            {
                assertEquals(_agents[i].breed, (i >> 1) + 1, _agents[i].traversalDepth);
                assertEquals(_agents[i].breed, (i >> 1) % 2 == 0, structures.isShown(_agents[i]));
            }
        }

        [Test]
        public function aHandlerMayMakeABreed():void
        {
            var collision:Collision = new Collision(new BinCollider());
            var cats:int = 0;
            var all:int = 0;
            var three:Vector.<Agent> = new <Agent>[new Agent("sphere", "cats"), new Agent("sphere", "cats"), new Agent("sphere", "cats")];
            collision.onCollision("cats", "cats", function(collider:Agent, collidee:Agent):void
                {
                    cats++;
                    for each (var agent:Agent in three)
                    {
                        agent.breed = "new " + agent.id;
                    }
                });
            collision.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, function(collider:Agent, collidee:Agent):void
                {
                    all++;
                });
            collision.update(three);
            assertEquals("both calls of the first pair", 2, cats);
            assertEquals(6, all);
        }

        /** The names that stand for any breed and for the world are no agent's breed, and questions and handlers take them as before. */
        [Test]
        public function noAgentHasAReservedBreed():void
        {
            for each (var name:String in [Collision.ANY_BREED, Collision.TERRAIN, Collision.EDGE])
            {
                var wanted:RegExp = new RegExp("^new Agent: breed must not be \"\\" + name + "\": ");
                assertThrows(ArgumentError, wanted, create, Agent, "sphere", name);
                assertThrows(ArgumentError, /^agent \d+ .*: breed must not be/, setBreed, _agents[0], name);
                assertEquals(NAMES[0], _agents[0].breed);
            }
            assertThrows(ArgumentError, /"\*": it stands for any breed$/, setBreed, _agents[0], "*");
            var reason:RegExp = /: the ground and the edges of the world have their own breeds$/;
            assertThrows(ArgumentError, reason, setBreed, _agents[0], Collision.EDGE);
            assertThrows(ArgumentError, reason, setBreed, new Terrain(2, 2).agent, "sheep");
            var queries:AgentQueries = new AgentQueries(new BinCollider());
            queries.update(_agents);
            assertEquals("no agent is of it", 0, queries.countNear(_agents[0], Infinity, AgentFilter.ofBreeds("*")));
            assertEquals(2, new Agent("sphere", "**").breed.length);
        }

        private static function setBreed(agent:Agent, breed:String):void
        {
            agent.breed = breed;
        }

        private static function log(calls:Array):Function
        {
            return function(collider:Agent, collidee:Agent):void
            {
                calls.push(collider.breed);
            };
        }
    }
}
