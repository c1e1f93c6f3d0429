package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import flash.errors.IllegalOperationError;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.diagnostics.CollisionRecorder;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;
    import support.EachCollider;
    import support.Effort;
    import support.MoodyBins;
    import support.OwnVectorSystem;
    import support.SolidModels;
    import support.assertThrows;
    import support.landOf;

    public class SnapshotTest
    {
        private static const FRAMES:int = 40;

        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube(), SolidModels.crossed());

        [Test]
        public function afterItTheFramesAreTheSame():void
        {
            var sweptCalls:int = 0;
            for each (var name:String in EachCollider.NAMES)
            {
                for (var seed:int = 1; seed <= Effort.choose(2, 100); seed++)
                {
                    var game:SnapshotGame = new SnapshotGame(EachCollider.make(name, _greatLand), seed);
                    game.turnsFreely = seed % 2 == 0;
                    game.run(10 + seed % 7);
                    var random:uint = game.random.nextUint();
                    game.random = new SeededRandom(random);
                    var bytes:ByteArray = game.collision.snapshot(game.turnsFreely);
                    var list:Vector.<Agent> = game.listed.concat();
                    var traits:Array = game.traitsOf(list);
                    var alive:Vector.<Boolean> = game.alive(list);
                    var expected:String = game.run(FRAMES);
                    sweptCalls += game.calls;

                    // the same Collision and agents
                    if (!game.turnsFreely)
                    {
                        game.setTraits(list, traits);
                    }
                    game.setAlive(list, alive);
                    game.random = new SeededRandom(random);
                    game.collision.restore(bytes, list);
                    assertSame(name + ", seed " + seed + ": again", expected, game.run(FRAMES));

                    // others, created in another order, in a new Collision
                    var other:SnapshotGame = new SnapshotGame(EachCollider.make(name, _greatLand), 1);
                    var agents:Vector.<Agent> = new Vector.<Agent>();
                    for (var i:int = 0; i < list.length; i++)
                    {
                        agents.splice((7 * i + seed) % (i + 1), 0, new Agent("sphere"));
                    }
                    other.turnsFreely = game.turnsFreely;
                    if (!game.turnsFreely)
                    {
                        other.setTraits(agents, traits);
                    }
                    other.setAlive(agents, alive);
                    other.random = new SeededRandom(random);
                    other.collision.restore(bytes, agents);
                    assertSame(name + ", seed " + seed + ": elsewhere", expected, other.run(FRAMES));
                }
            }
            assertTrue("calls " + sweptCalls, sweptCalls > 2000);
        }

        [Test]
        public function badBytesChangeNothing():void
        {
            var game:SnapshotGame = new SnapshotGame(EachCollider.make("tightest fits", _greatLand), 5);
            game.run(12);
            var random:uint = game.random.nextUint();
            game.random = new SeededRandom(random);
            var list:Vector.<Agent> = game.listed.concat();
            var traits:Array = game.traitsOf(list);
            var alive:Vector.<Boolean> = game.alive(list);
            var bytes:ByteArray = game.collision.snapshot();
            var expected:String = game.run(FRAMES);
            game.setTraits(list, traits);
            game.setAlive(list, alive);
            game.random = new SeededRandom(random);
            game.collision.restore(bytes, list);

            // the number of standings comes after the pairs
            var pairsEnd:int = bytes.length - 4;
            var damage:SeededRandom = new SeededRandom(77);
            var refused:int = 0;
            for (var i:int = 0; i < 300; i++)
            {
                var broken:ByteArray = new ByteArray();
                broken.writeBytes(bytes, 0, i % 3 == 0 ? damage.integer(0, bytes.length - 1) : bytes.length);
                if (i % 3 == 1)
                {
                    broken.writeByte(0);
                }
                else if (i % 3 == 2)
                {
                    // a mark, what is in it, counts, a pair: what has few values
                    broken[[0, 4, 5, 9, pairsEnd + 1, pairsEnd - 1, pairsEnd - 2][int(i / 3) % 7]] ^= 1 << damage.integer(1, 7);
                }
                try
                {
                    game.collision.restore(broken, list);
                }
                catch (error:ArgumentError)
                {
                    refused++;
                }
            }
            assertEquals("all refused", 300, refused);
            // the last pair is the one before again
            var doubled:ByteArray = new ByteArray();
            doubled.writeBytes(bytes, 0, pairsEnd - 17);
            doubled.writeBytes(bytes, pairsEnd - 34, 17);
            doubled.writeInt(0);
            assertThrows(ArgumentError, /no snapshot/, game.collision.restore, doubled, list);
            doubled.clear();
            assertThrows(ArgumentError, /no snapshot: they do not begin/, game.collision.restore, doubled, list);
            doubled.writeUTFBytes("v 0 0 0\nv 1 0 0\n");
            assertThrows(ArgumentError, /no snapshot: they do not begin/, game.collision.restore, doubled, list);
            assertThrows(ArgumentError, /bytes must not be null/, game.collision.restore, null, list);
            assertThrows(ArgumentError, /agents must not be null/, game.collision.restore, bytes, null);
            assertThrows(ArgumentError, /no snapshot of 0 agents/, game.collision.restore, bytes, new Vector.<Agent>());
            var twice:Vector.<Agent> = list.concat();
            twice[1] = twice[0];
            assertThrows(ArgumentError, /twice/, game.collision.restore, bytes, twice);
            assertSame("as if nothing had been tried", expected, game.run(FRAMES));
        }

        [Test]
        public function notWhileHandlersRun():void
        {
            var collision:Collision = new Collision(new BinCollider(_greatLand));
            var a:Agent = new Agent("sphere");
            var b:Agent = new Agent("sphere");
            var agents:Vector.<Agent> = new <Agent>[a, b];
            var bytes:ByteArray = collision.snapshot();
            collision.restore(bytes, new Vector.<Agent>());
            var calls:int = 0;
            collision.onCollision("turtles", "turtles", function(collider:Agent, collidee:Agent):void
                {
                    assertThrows(IllegalOperationError, /snapshot must not be called from a handler/, collision.snapshot);
                    assertThrows(IllegalOperationError, /restore must not be called from a handler/, collision.restore, bytes, agents);
                    calls++;
                });
            collision.update(agents);
            assertEquals(2, calls);
            assertThrows(ArgumentError, /twice/, collision.update, new <Agent>[a, a]);
            assertThrows(IllegalOperationError, /refused its list/, collision.snapshot);
        }

        [Test]
        public function aFrameWhoseContactsFailHasNone():void
        {
            var system:MoodyBins = new MoodyBins(_greatLand);
            var collision:Collision = new Collision(system);
            var agents:Vector.<Agent> = new <Agent>[new Agent("sphere"), new Agent("sphere")];
            collision.onCollisionStart("turtles", "turtles", function(collider:Agent, collidee:Agent, contact:Contact):void
                {
                });
            collision.update(agents);
            system.refuses = true;
            assertThrows(Error, /no contact/, collision.update, new <Agent>[new Agent("sphere"), new Agent("sphere")]);
            assertThrows(IllegalOperationError, /failed/, collision.snapshot);
            system.refuses = false;
            collision.update(agents);
            collision.restore(collision.snapshot(), agents);
        }

        [Test]
        public function aFrameOfAnotherKindOfSystemHasNone():void
        {
            var agents:Vector.<Agent> = new <Agent>[new Agent("sphere"), new Agent("sphere")];
            var collision:Collision = new Collision(new OwnVectorSystem(new <Agent>[]));
            collision.update(agents);
            collision.collisionSystem = new BinCollider(_greatLand);
            assertThrows(IllegalOperationError, /another list since the last frame/, collision.snapshot);
            collision.update(agents);
            collision.restore(collision.snapshot(), agents);
        }

        [Test]
        public function anAgentThatAHandlerTakesOutComesBack():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var collision:Collision = new Collision(EachCollider.make(name, _greatLand));
                var log:Array = [];
                var agents:Vector.<Agent> = new <Agent>[new Agent("sphere", "bears"), new Agent("sphere", "balls"), new Agent("cube", "balls")];
                agents[1].moveTo(9, 0, 0);
                agents[2].moveTo(0, 0.5, 0);
                agents[2].sweeps = true;
                collision.onCollision("balls", "bears", function(ball:Agent, bear:Agent):void
                    {
                        log.push("hit " + ball.id);
                        agents.splice(agents.indexOf(ball), 1);
                    });
                collision.onCollisionEnd("balls", "bears", function(ball:Agent, bear:Agent):void
                    {
                        log.push("end " + ball.id + " " + bear.id);
                    });
                collision.update(agents);
                var listed:Vector.<Agent> = collision.lastAgents.concat();
                assertEquals(3, listed.length);
                assertEquals(2, agents.length);
                var after:Vector.<Agent> = agents.concat();
                var bytes:ByteArray = collision.snapshot();
                var first:String = goOn(collision, agents, log);
                assertTrue(first, first.indexOf("end " + listed[2].id) >= 0);
                listed[1].jumpTo(9, 0, 0);
                agents = after.concat();
                collision.restore(bytes, listed);
                assertEquals(3, collision.lastAgents.length);
                assertEquals(name, first, goOn(collision, agents, log));
            }
        }

        private static function goOn(collision:Collision, agents:Vector.<Agent>, log:Array):String
        {
            log.length = 0;
            agents[1].moveTo(8.5, 0, 0);
            collision.update(agents);
            agents[1].moveTo(0, 0.25, 0);
            collision.update(agents.concat());
            return log.join();
        }

        [Test]
        public function anotherListOfTheSameLengthIsRefused():void
        {
            var collision:Collision = new Collision(new BinCollider(_greatLand));
            var a:Agent = new Agent("sphere");
            var b:Agent = new Agent("sphere");
            var older:Agent = new Agent("sphere");
            var agents:Vector.<Agent> = new <Agent>[a, b];
            collision.update(agents);
            var bytes:ByteArray = collision.snapshot();
            var wanted:RegExp = new RegExp("but of the 2 that .*lastAgents had: those with the ids " + a.id + ", " + b.id + "; at place ([01]) .*agent ");
            assertThrows(ArgumentError, wanted, collision.restore, bytes, new <Agent>[b, a]);
            assertThrows(ArgumentError, wanted, collision.restore, bytes, new <Agent>[a, older]);
            assertThrows(ArgumentError, wanted, collision.restore, bytes, new <Agent>[a, new Agent("sphere")]);
            var three:RegExp = new RegExp("no snapshot of 3 agents, but of the 2 that .*: those with the ids " + a.id + ", " + b.id);
            assertThrows(ArgumentError, three, collision.restore, bytes, new <Agent>[a, b, older]);
            assertStrictlyEquals(a, collision.lastAgents[0]);
            // those that were read from a file
            collision.restore(bytes, new <Agent>[new Agent("sphere"), new Agent("sphere")]);
            collision.restore(bytes, agents);
            // another Collision has agents of its own
            new Collision(new BinCollider(_greatLand)).restore(bytes, new <Agent>[older, a]);
        }

        [Test]
        public function onlyTheLastSnapshotsAreRemembered():void
        {
            var collision:Collision = new Collision(new BinCollider());
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < 300; i++)
            {
                agents.push(new Agent("sphere"));
            }
            var all:Array = [];
            for (i = 0; i < 300; i++)
            {
                agents[0].x = i;
                collision.update(agents);
                all.push(collision.snapshot());
            }
            var turned:Vector.<Agent> = agents.concat().reverse();
            assertThrows(ArgumentError, /at place 0/, collision.restore, all[299], turned);
            assertThrows(ArgumentError, /at place 0/, collision.restore, all[299 - 200], turned);
            // the same bytes of another list are right too
            agents[0].x = 299;
            collision.update(turned);
            collision.update(agents);
            collision.restore(all[299], agents);
            collision.restore(all[0], turned);
        }

        [Test]
        public function machinesInStepWriteTheSameBytes():void
        {
            var games:Array = [];
            for (var i:int = 0; i < 2; i++)
            {
                games.push(new SnapshotGame(EachCollider.make("tightest fits", _greatLand), 5));
                // the second one's agents have other ids
                new Agent("sphere");
            }
            for (var frame:int = 0; frame < 30; frame++)
            {
                var first:ByteArray = null;
                for each (var game:SnapshotGame in games)
                {
                    game.run(1);
                    var bytes:ByteArray = game.collision.snapshot();
                    first ||= bytes;
                    assertEquals(first.length, bytes.length);
                    var others:int = 0;
                    for (var at:int = 0; at < bytes.length; at++)
                    {
                        others += first[at] == bytes[at] ? 0 : 1;
                    }
                    assertEquals(0, others);
                }
            }
        }

        [Test]
        public function theListOfManyIsNotWrittenOut():void
        {
            var collision:Collision = new Collision(new BinCollider());
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < 1000; i++)
            {
                agents.push(new Agent("sphere"));
            }
            collision.update(agents);
            assertThrows(ArgumentError, /of the 1000 that .{0,200} and 990 more$/, collision.restore, collision.snapshot(), new Vector.<Agent>());
        }

        [Test]
        public function aRecorderAroundTheSystemChangesNothing():void
        {
            for each (var isRecorded:Boolean in [false, true])
            {
                var collision:Collision = new Collision(recorded(new BinCollider(), isRecorded));
                var agents:Vector.<Agent> = new <Agent>[new Agent("sphere", "balls"), new Agent("sphere", "walls"), new Agent("sphere", "ghosts")];
                agents[0].sweeps = agents[2].sweeps = true;
                agents[1].moveTo(5, 0, 0);
                var hits:Array = [];
                collision.onCollision(Collision.ANY_BREED, "walls", function(collider:Agent, collidee:Agent):void
                    {
                        hits.push(collider.breed);
                    });
                var filter:AgentFilter = new AgentFilter();
                filter.exceptBreeds = new <String>["ghosts"];
                collision.filter = filter;
                collision.update(agents);
                var bytes:ByteArray = collision.snapshot();
                agents[0].moveTo(20, 0, 0);
                agents[2].moveTo(20, 0, 0);
                collision.filter = null;
                collision.update(agents);
                var first:String = hits.join();
                assertEquals("as it moved since the last frame", "balls,ghosts", hits.sort().join());
                agents[0].jumpTo(0, 0, 0);
                agents[2].jumpTo(0, 0, 0);
                collision.restore(bytes, agents);
                agents[0].moveTo(20, 0, 0);
                agents[2].moveTo(20, 0, 0);
                hits.length = 0;
                collision.update(agents);
                assertEquals(first, hits.join());
                var queries:AgentQueries = new AgentQueries(collision);
                queries.update(agents);
                assertEquals(1, queries.touching(agents[0]).length);
            }
        }

        private static function recorded(system:CollisionSystem, isRecorded:Boolean):CollisionSystem
        {
            return isRecorded ? new CollisionRecorder(new CollisionRecorder(system)) : system;
        }

        // The first line that differs is enough to see.
        private static function assertSame(message:String, expected:String, found:String):void
        {
            var lines:Array = expected.split("\n");
            var others:Array = found.split("\n");
            for (var i:int = 0; i < lines.length; i++)
            {
                assertEquals(message + ", line " + i, lines[i], others[i]);
            }
            assertEquals(message, lines.length, others.length);
        }
    }
}

import evaluation.pairs.SeededRandom;
import flash.utils.ByteArray;
import starlogo.agents.Agent;
import starlogo.collision.Collision;
import starlogo.collision.CollisionSystem;
import starlogo.collision.Contact;

/** A game of chance, whose agents move, jump, turn, are born and die; it writes down what its handlers are told. */
internal class SnapshotGame
{
    public var collision:Collision;
    public var random:SeededRandom;
    public var calls:int = 0;

    // Whether agents are turned by quaternions and matrices too, and have all their traits changed.
    public var turnsFreely:Boolean = false;

    // The last frame's list, and who is alive of it.
    public var listed:Vector.<Agent> = new Vector.<Agent>();
    private var _alive:Vector.<Agent> = new Vector.<Agent>();
    private var _log:Array = [];
    private var _numbers:Object = {};
    private var _named:int = 0;

    public function SnapshotGame(system:CollisionSystem, seed:int)
    {
        collision = new Collision(system);
        random = new SeededRandom(seed);
        for each (var breed:String in ["bears", "balls"])
        {
            collision.onCollision(breed, "balls", log("hit"));
            collision.onCollisionStart(breed, Collision.ANY_BREED, log("start"));
            collision.onCollisionEnd(breed, "bears", logEnd);
        }
        for (var i:int = 0; i < 25; i++)
        {
            _alive.push(born());
        }
    }

    public function run(frames:int):String
    {
        _log = [];
        for (var frame:int = 0; frame < frames; frame++)
        {
            play();
            listed = _alive.concat();
            // an agent is known by its place in the first list of the run
            if (frame == 0)
            {
                _numbers = {};
                _named = 0;
            }
            for each (var agent:Agent in listed)
            {
                numberOf(agent);
            }
            collision.update(listed);
            _log.push("frame " + frame + ": " + collision.statistics.collisions);
            if (random.chance(0.5))
            {
                _alive.splice(random.integer(0, _alive.length - 1), 1);
            }
        }
        return _log.join("\n");
    }

    public function alive(list:Vector.<Agent>):Vector.<Boolean>
    {
        var are:Vector.<Boolean> = new Vector.<Boolean>();
        for (var i:int = 0; i < list.length; i++)
        {
            are[i] = _alive.indexOf(list[i]) >= 0;
        }
        return are;
    }

    public function setAlive(list:Vector.<Agent>, are:Vector.<Boolean>):void
    {
        _alive.length = 0;
        for (var i:int = 0; i < list.length; i++)
        {
            if (are[i])
            {
                _alive.push(list[i]);
            }
        }
    }

    public function traitsOf(list:Vector.<Agent>):Array
    {
        var all:Array = [];
        for each (var a:Agent in list)
        {
            all.push([a.x, a.y, a.z, a.heading, a.pitch, a.size, a.shape, a.breed, a.sweeps, a.hierarchical]);
        }
        return all;
    }

    public function setTraits(list:Vector.<Agent>, traits:Array):void
    {
        for (var i:int = 0; i < list.length; i++)
        {
            var a:Agent = list[i];
            var t:Array = traits[i];
            a.shape = t[6];
            a.breed = t[7];
            a.heading = t[3];
            a.pitch = t[4];
            a.size = t[5];
            a.sweeps = t[8];
            a.hierarchical = t[9];
            a.moveTo(t[0], t[1], t[2]);
        }
    }

    private function play():void
    {
        if (random.chance(0.3))
        {
            // the order of the list is not always the agents' age
            _alive.unshift(_alive.pop());
        }
        for each (var agent:Agent in _alive)
        {
            if (turnsFreely)
            {
                change(agent);
            }
            switch (random.integer(0, 11))
            {
                case 0:
                    agent.heading = random.between(0, 360);
                    break;
                case 1:
                    agent.pitch = random.between(-40, 40);
                    break;
                case 2:
                    agent.breed = random.pick(["bears", "balls", "trees"]);
                    break;
                case 3:
                    agent.sweeps = !agent.sweeps;
                    break;
                case 4:
                    agent.size = random.between(0.5, 2);
                    break;
                case 5:
                    agent.hierarchical = !agent.hierarchical;
                    break;
                case 6:
                    break;
                default:
                    agent.moveTo(random.between(-6, 6), random.between(-6, 6), random.between(0, 1));
            }
        }
        if (_alive.length < 25)
        {
            _alive.push(born());
        }
    }

    private function change(agent:Agent):void
    {
        switch (random.integer(0, 12))
        {
            case 0:
                agent.setQuaternion(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
                break;
            case 1:
                agent.setMatrix(_alive[0].transform);
                break;
            case 2:
                var turn:Vector.<Number> = agent.getQuaternion();
                agent.setQuaternion(turn[0], turn[1], turn[2], turn[3]);
                break;
            case 3:
                agent.collideAs = random.pick(["tightest", "sphere", "box", "capsule"]);
                break;
            case 4:
                agent.traversalDepth = random.integer(0, 4);
                break;
            case 5:
                agent.shape = random.pick(["sphere", "cube", "crossed"]);
                break;
            case 6:
                agent.roll += 10;
                break;
            default:
                agent.color++;
        }
    }

    private function born():Agent
    {
        var agent:Agent = new Agent(random.pick(["sphere", "cube", "crossed"]), random.pick(["bears", "balls", "trees"]));
        agent.sweeps = random.chance();
        agent.moveTo(random.between(-6, 6), random.between(-6, 6), random.between(0, 1));
        return agent;
    }

    private function log(what:String):Function
    {
        return function(a:Agent, b:Agent, contact:Contact):void
        {
            calls++;
            _log.push([what, numberOf(a), numberOf(b), bits(contact.time), bits(contact.depth), bits(contact.normal.x), bits(contact.point.y)].join(" "));
        };
    }

    private function logEnd(a:Agent, b:Agent):void
    {
        calls++;
        _log.push(["end", numberOf(a), numberOf(b)].join(" "));
    }

    // Ids may differ.
    private function numberOf(agent:Agent):int
    {
        if (!_numbers.hasOwnProperty(String(agent.id)))
        {
            _numbers[agent.id] = _named++;
        }
        return _numbers[agent.id];
    }

    private static function bits(value:Number):String
    {
        var bytes:ByteArray = new ByteArray();
        // -0 is 0
        bytes.writeDouble(value + 0);
        bytes.position = 0;
        return bytes.readUnsignedInt().toString(16) + "." + bytes.readUnsignedInt().toString(16);
    }
}
