package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import flash.errors.IllegalOperationError;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.diagnostics.CollisionRecorder;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.WalkOptions;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.EachCollider;
    import support.MoodyBins;
    import support.OwnVectorSystem;
    import support.agentAt;
    import support.assertThrows;
    import support.landOf;

    public class SnapshotTest
    {
        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube());

        [Test]
        public function afterItTheFramesAreTheSame():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var crowd:Crowd = new Crowd(EachCollider.make(name, _greatLand));
                crowd.play(1, 12);
                var bytes:ByteArray = crowd.collision.snapshot();
                var expected:String = crowd.play(13, 40);
                assertTrue(name, expected.split("start").length > 50 && expected.split("end").length > 50);
                for each (var again:Crowd in [crowd, new Crowd(EachCollider.make(name, _greatLand))])
                {
                    again.move(12);
                    again.collision.restore(bytes, again.agents);
                    assertEquals(name, expected, again.play(13, 40));
                }
            }
        }

        [Test]
        public function badBytesChangeNothing():void
        {
            var crowd:Crowd = new Crowd(new TightestFitCollider(_greatLand));
            crowd.play(1, 12);
            var bytes:ByteArray = crowd.collision.snapshot();
            var expected:String = crowd.play(13, 40);
            crowd.move(12);
            crowd.collision.restore(bytes, crowd.agents);

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
                    crowd.collision.restore(broken, crowd.agents);
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
            assertThrows(ArgumentError, /no snapshot/, crowd.collision.restore, doubled, crowd.agents);
            doubled.clear();
            assertThrows(ArgumentError, /no snapshot: they do not begin/, crowd.collision.restore, doubled, crowd.agents);
            doubled.writeUTFBytes("v 0 0 0\nv 1 0 0\n");
            assertThrows(ArgumentError, /no snapshot: they do not begin/, crowd.collision.restore, doubled, crowd.agents);
            assertThrows(ArgumentError, /\bbytes must (not be null|be an ArrayBuffer, a view of one, or a ByteArray, not null)/, crowd.collision.restore, null, crowd.agents);
            assertThrows(ArgumentError, /agents must/, crowd.collision.restore, bytes, null);
            assertThrows(ArgumentError, /no snapshot of 0 agents/, crowd.collision.restore, bytes, new Vector.<Agent>());
            var twice:Vector.<Agent> = crowd.agents.concat();
            twice[1] = twice[0];
            assertThrows(ArgumentError, /twice/, crowd.collision.restore, bytes, twice);
            assertEquals("as if nothing had been tried", expected, crowd.play(13, 40));
        }

        [Test]
        public function bytesOfOlderVersionsHaveANameTwice():void
        {
            var agents:Vector.<Agent> = new <Agent>[agentAt("sphere", 0, 0, 0, "sphere"), agentAt("sphere", 1, 0, 0, "sphere")];
            var collision:Collision = new Collision(new BinCollider());
            collision.update(agents);
            // after the mark, what is in it, and the number of agents: the names. The breed's name is the model's
            var bytes:ByteArray = collision.snapshot(true);
            bytes.position = 9;
            assertEquals(1, bytes.readInt());
            var length:int = bytes.readInt();
            var older:ByteArray = new ByteArray();
            older.endian = bytes.endian;
            older.writeBytes(bytes, 0, 9);
            older.writeInt(2);
            older.writeBytes(bytes, 13, 4 + length);
            older.writeBytes(bytes, 13);
            agents[1].x = 9;
            collision.restore(older, agents);
            assertEquals(1, agents[1].x);
            assertEquals("sphere", agents[1].breed);
        }

        [Test]
        public function anotherKindOfSystemIsRefused():void
        {
            var systems:Array = ["bins", "BinCollider", "tightest fits", "TightestFitCollider", "hierarchies", "HierarchicalCollider", "combinations", "CombinationCollider"];
            for (var i:int = 0; i < systems.length; i += 2)
            {
                var crowd:Crowd = new Crowd(EachCollider.make(systems[i], _greatLand));
                crowd.play(1, 3);
                var bytes:ByteArray = crowd.collision.snapshot();
                for (var j:int = 0; j < systems.length; j += 2)
                {
                    crowd.collision.collisionSystem = EachCollider.make(systems[j], _greatLand);
                    if (i == j)
                    {
                        crowd.collision.restore(bytes, crowd.agents);
                        continue;
                    }
                    assertThrows(ArgumentError, new RegExp("with a " + systems[j + 1] + ".*had a " + systems[i + 1]), crowd.collision.restore, bytes, crowd.agents);
                }
            }
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
        public function aTouchThatEndedInAFrameThatFailedIsInNoSnapshot():void
        {
            var system:MoodyBins = new MoodyBins(_greatLand);
            var collision:Collision = new Collision(system);
            var cat:Agent = agentAt("sphere", 0, 0, 0, "cats");
            var dog:Agent = agentAt("sphere", 0.5, 0, 0, "dogs");
            var cow:Agent = agentAt("sphere", 9, 0, 0, "cows");
            var pig:Agent = agentAt("sphere", 9.5, 0, 0, "cows");
            var agents:Vector.<Agent> = new <Agent>[cat, dog, cow, pig];
            var end:Function = function(collider:Agent, collidee:Agent):void
            {
                // only now the pair of pigs needs a contact
                cow.breed = pig.breed = "pigs";
                system.refuses = true;
            };
            collision.onCollisionEnd("cats", "dogs", end);
            collision.onCollision("cows", "cows", function(collider:Agent, collidee:Agent):void
                {
                });
            collision.onCollision("pigs", "pigs", function(collider:Agent, collidee:Agent, contact:Contact):void
                {
                });
            collision.update(agents);
            cat.moveTo(5, 0, 0);
            assertThrows(Error, /no contact/, collision.update, agents);
            system.refuses = false;
            collision.removeHandler("cats", "dogs", end);
            collision.update(agents);
            var again:Collision = new Collision(new BinCollider(_greatLand));
            var ends:int = 0;
            again.onCollisionEnd("cats", "dogs", function(collider:Agent, collidee:Agent):void
                {
                    ends++;
                });
            again.restore(collision.snapshot(), agents);
            again.update(agents);
            assertEquals(0, ends);
        }

        [Test]
        public function aFrameOfAnotherKindOfSystemHasNone():void
        {
            var agents:Vector.<Agent> = new <Agent>[new Agent("sphere"), new Agent("sphere")];
            var collision:Collision = new Collision(new OwnVectorSystem(new <Agent>[]));
            collision.update(agents);
            collision.collisionSystem = new BinCollider(_greatLand);
            assertThrows(IllegalOperationError, /the last frame .* had a collision system of the game's own/, collision.snapshot);
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
            var wanted:RegExp = new RegExp("but of the 2 that .*lastAgents had, of which a game keeps a copy: those with the ids " + a.id + ", " + b.id + "; at place ([01]) .*agent ");
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
        public function whereAFormerGroundWasIsKnownOnlyToTheCollisionThatWroteIt():void
        {
            for each (var breed:String in [Collision.TERRAIN, Collision.EDGE])
            {
                var agents:Vector.<Agent> = new <Agent>[agentAt("sphere", 0, 0, -0.1, "balls")];
                var answers:Array = [];
                var writer:Collision = worldWith(breed, answers);
                writer.update(agents);
                exchangeWorld(writer);
                var bytes:ByteArray = writer.snapshot();
                for each (var reader:Collision in [writer, worldWith(breed, answers)])
                {
                    reader.restore(bytes, agents);
                    reader.update(agents);
                }
                assertEquals(2, answers.length);
                assertEquals("true", answers[0]);
                assertTrue(answers[1], /is not known: it was exchanged/.test(answers[1]));
            }
        }

        [Test]
        public function eachSnapshotKeepsTheGroundThatWasExchangedBefore():void
        {
            for each (var breed:String in [Collision.TERRAIN, Collision.EDGE])
            {
                var agents:Vector.<Agent> = new <Agent>[agentAt("sphere", 0, 0, -0.1, "balls")];
                var collision:Collision = worldWith(breed, []);
                var ended:Array = [];
                collision.onCollisionEnd("balls", breed, function(ball:Agent, former:Agent):void
                    {
                        ended.push(former);
                    });
                var worlds:Array = [];
                var snapshots:Array = [];
                for (var i:int = 0; i < 3; i++)
                {
                    agents[0].x = i;
                    collision.update(agents);
                    worlds.push(breed == Collision.TERRAIN ? collision.terrain.agent : collision.bounds.agent);
                    exchangeWorld(collision);
                    snapshots.push(collision.snapshot());
                }
                for each (i in [1, 0, 2])
                {
                    ended.length = 0;
                    collision.restore(snapshots[i], agents);
                    collision.update(agents);
                    assertEquals(1, ended.length);
                    assertStrictlyEquals(breed + " " + i, worlds[i], ended[0]);
                }
            }
        }

        [Test]
        public function thePartnerOfATouchHasABreedThatItCanHave():void
        {
            var agents:Vector.<Agent> = new <Agent>[agentAt("sphere", 0, 0, -0.1, "balls"), agentAt("sphere", 0, 0, -0.2, "balls")];
            var collision:Collision = worldWith(Collision.TERRAIN, []);
            collision.onCollisionStart("balls", "balls", function(ball:Agent, other:Agent):void
                {
                });
            collision.update(agents);
            // the touches come last, before the number of standings: two balls, and each with the ground
            var bytes:ByteArray = collision.snapshot(false, false);
            var touches:uint = bytes.length - 4 - 3 * 17;
            assertEquals(3, bytes[touches - 4]);
            // the second of a pair, and the names of the breeds: balls and the ground
            for each (var change:Array in [[21, 3], [21, 5], [21, 1], [25, 1], [29, 0], [8, 1], [12, 1]])
            {
                var forged:ByteArray = new ByteArray();
                forged.writeBytes(bytes);
                assertFalse(change.join(), forged[touches + change[0]] == change[1]);
                forged[touches + change[0]] = change[1];
                assertThrows(ArgumentError, /something in them was changed/, collision.restore, forged, agents);
            }
            assertEquals("as before", bytes.length, collision.snapshot(false, false).length);
        }

        // Handlers for ends ask about the ground or the edges that were touched.
        private static function worldWith(breed:String, answers:Array):Collision
        {
            var collision:Collision = new Collision(new BinCollider());
            exchangeWorld(collision);
            collision.onCollisionEnd("balls", breed, function(ball:Agent, former:Agent):void
                {
                    try
                    {
                        answers.push(String(collision.collisionSystem.areColliding(ball, former)));
                    }
                    catch (error:ArgumentError)
                    {
                        answers.push(error.message);
                    }
                });
            return collision;
        }

        private static function exchangeWorld(collision:Collision):void
        {
            collision.terrain = new Terrain(11, 11, 1, -5, -5);
            collision.bounds = new WorldBounds(-9, -9, -9, 9, 9, 0.5);
        }

        [Test]
        public function machinesInStepWriteTheSameBytes():void
        {
            // the agents of the second one have other ids
            var first:Crowd = new Crowd(new TightestFitCollider(_greatLand));
            var second:Crowd = new Crowd(new TightestFitCollider(_greatLand));
            for (var frame:int = 1; frame <= 30; frame++)
            {
                assertEquals(first.play(frame, frame), second.play(frame, frame));
                var bytes:ByteArray = first.collision.snapshot();
                var others:ByteArray = second.collision.snapshot();
                assertEquals(bytes.length, others.length);
                for (var at:int = 0; at < bytes.length; at++)
                {
                    assertEquals(frame + ", byte " + at, bytes[at], others[at]);
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
        public function whatStandsSweepsAsItDidInTheFrame():void
        {
            for each (var isSweeping:Boolean in [false, true])
            {
                var hits:Array = [];
                var bullet:Agent = agentAt("sphere", -10, 0, 0);
                var other:Agent = agentAt("sphere", 0, 90, 0);
                var agents:Vector.<Agent> = new <Agent>[new Agent("sphere"), bullet, other];
                other.sweeps = true;
                agents[0].sweeps = isSweeping;
                var collision:Collision = collisionThatNotes(hits);
                collision.update(agents);
                var bytes:ByteArray = collision.snapshot(true);
                agents[0].sweeps = !isSweeping;
                collision.update(agents);
                collision.update(agents);
                for each (var again:Collision in [collision, collisionThatNotes(hits)])
                {
                    again.restore(bytes, agents);
                    bullet.moveTo(10, 0, 0);
                    again.update(agents);
                    assertEquals("a wall that sweeps: " + isSweeping, isSweeping ? 2 : 0, hits.length);
                    hits.length = 0;
                }
            }
        }

        [Test]
        public function aGrowingPlatformCarriesAsItWouldHave():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var collision:Collision = new Collision(EachCollider.make(name, _greatLand));
                var platform:Agent = new Agent("sphere");
                var walker:Agent = agentAt("sphere", 0.3, 0, 2.6);
                var agents:Vector.<Agent> = new <Agent>[platform, walker];
                var options:WalkOptions = new WalkOptions();
                var queries:AgentQueries = new AgentQueries(collision);
                platform.size = 4;
                options.fall = Infinity;
                options.slopeDegrees = 80;
                collision.update(agents);
                queries.update(agents);
                queries.walk(walker, 0, 0, options);
                var bytes:ByteArray = collision.snapshot(true);
                var places:Array = [];
                for (var i:int = 0; i < 2; i++)
                {
                    platform.size = 4.4;
                    queries.update(agents);
                    queries.walk(walker, 0, 0, options);
                    places.push(walker.x + " " + walker.z);
                    collision.restore(bytes, agents);
                }
                assertEquals(name, places[0], places[1]);
            }
        }

        private static function collisionThatNotes(hits:Array):Collision
        {
            var collision:Collision = new Collision(new BinCollider());
            collision.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, function(collider:Agent, collidee:Agent):void
                {
                    hits.push(collider);
                });
            return collision;
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
    }
}

import evaluation.pairs.SeededRandom;
import starlogo.agents.Agent;
import starlogo.collision.Collision;
import starlogo.collision.CollisionSystem;
import starlogo.collision.Contact;

/** Agents that are elsewhere in every frame, some of which sweep. It writes down which touches start and end, and how. */
internal class Crowd
{
    public var collision:Collision;
    public var agents:Vector.<Agent> = new Vector.<Agent>();
    private var _log:Array;

    public function Crowd(system:CollisionSystem)
    {
        collision = new Collision(system);
        for (var i:int = 0; i < 25; i++)
        {
            agents.push(new Agent(["sphere", "cube"][i % 2], ["bears", "balls", "trees"][i % 3]));
            agents[i].sweeps = i % 5 == 0;
            agents[i].hierarchical = i % 4 == 0;
        }
        collision.onCollisionStart("bears", Collision.ANY_BREED, log("start"));
        collision.onCollisionEnd(Collision.ANY_BREED, "balls", log("end"));
    }

    /** Plays some frames, and tells what was called in them. */
    public function play(first:int, last:int):String
    {
        _log = [];
        for (var frame:int = first; frame <= last; frame++)
        {
            move(frame);
            collision.update(agents);
        }
        return _log.join();
    }

    /** Moves the agents to where they are in a frame. */
    public function move(frame:int):void
    {
        var random:SeededRandom = new SeededRandom(frame);
        for each (var agent:Agent in agents)
        {
            agent.moveTo(random.between(-4, 4), random.between(-4, 4), 0);
        }
    }

    private function log(what:String):Function
    {
        return function(a:Agent, b:Agent, contact:Contact):void
        {
            _log.push([what, agents.indexOf(a), agents.indexOf(b)].concat(contact == null ? [] : [contact.time, contact.depth, contact.normal.x, contact.point.y]).join(" "));
        };
    }
}
