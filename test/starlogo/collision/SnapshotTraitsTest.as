package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.Footing;
    import starlogo.terrain.Terrain;
    import support.EachCollider;
    import support.Effort;
    import support.agentAt;
    import support.assertThrows;
    import support.ignore;
    import support.landOf;

    /** Snapshots with the agents' traits: one call writes a game, one brings it back. */
    public class SnapshotTraitsTest
    {
        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder());

        [Test]
        public function traitsComeBackToTheBit():void
        {
            var random:SeededRandom = new SeededRandom(51);
            for (var round:int = 0; round < Effort.choose(20, 200); round++)
            {
                var collision:Collision = new Collision(new CombinationCollider(_greatLand));
                var agents:Vector.<Agent> = new Vector.<Agent>();
                for (var i:int = 0; i < 12; i++)
                {
                    agents.push(randomAgent(random));
                }
                collision.update(agents);
                var bytes:ByteArray = collision.snapshot(true);
                var expected:String = textOf(agents);
                for (i = 0; i < agents.length; i++)
                {
                    change(agents[i], random);
                }
                assertFalse(expected == textOf(agents));
                collision.restore(bytes, agents);
                assertEquals("the same agents", expected, textOf(agents));
                var others:Vector.<Agent> = new Vector.<Agent>();
                for (i = 0; i < agents.length; i++)
                {
                    others.push(randomAgent(random));
                }
                new Collision(new CombinationCollider(_greatLand)).restore(bytes, others);
                assertEquals("others", expected, textOf(others));
                for (i = 0; i < agents.length; i++)
                {
                    agents[i].pitch += 0.5;
                    others[i].pitch += 0.5;
                }
                assertEquals("and what follows", textOf(agents), textOf(others));
            }
        }

        // A frame after a snapshot came back has the collisions that it had without the change, whichever trait alone had changed.
        [Test]
        public function eachTraitThatComesBackDecides():void
        {
            var changes:Object = {
                    x: function(a:Agent):void
                    {
                        a.x += 0.6;
                    },
                    y: function(a:Agent):void
                    {
                        a.y += 0.6;
                    },
                    z: function(a:Agent):void
                    {
                        a.z += 0.6;
                    },
                    size: function(a:Agent):void
                    {
                        a.size *= 1.5;
                    },
                    shape: function(a:Agent):void
                    {
                        a.shape = "cube";
                    },
                    breed: function(a:Agent):void
                    {
                        a.breed = "stones";
                    },
                    sweeps: function(a:Agent):void
                    {
                        a.sweeps = true;
                    },
                    hierarchical: function(a:Agent):void
                    {
                        a.hierarchical = true;
                    },
                    collideAs: function(a:Agent):void
                    {
                        a.collideAs = "box";
                    },
                    traversalDepth: function(a:Agent):void
                    {
                        a.traversalDepth = 1;
                    }
                };
            for (var trait:String in changes)
            {
                var random:SeededRandom = new SeededRandom(53);
                var agents:Vector.<Agent> = new Vector.<Agent>();
                for (var i:int = 0; i < 120; i++)
                {
                    var agent:Agent = agentAt(i % 2 == 0 ? "sphere" : "cylinder", 4 * random.next(), 4 * random.next(), 4 * random.next());
                    agent.size = 0.6;
                    // the depth decides only about trees
                    agent.hierarchical = trait == "traversalDepth";
                    agents.push(agent);
                }
                var pairs:Array = [];
                var collision:Collision = new Collision(new CombinationCollider(_greatLand));
                collision.onCollision("turtles", "turtles", function(a:Agent, b:Agent):void
                    {
                        pairs.push(agents.indexOf(a) + " " + agents.indexOf(b));
                    });
                collision.update(agents);
                var bytes:ByteArray = collision.snapshot(true);
                var expected:String = pairsAfterMoves(collision, agents, pairs);
                collision.restore(bytes, agents);
                changeSome(agents, changes[trait]);
                assertFalse(trait + " decides", expected == pairsAfterMoves(collision, agents, pairs));
                collision.restore(bytes, agents);
                changeSome(agents, changes[trait]);
                collision.update(agents);
                collision.restore(bytes, agents);
                assertEquals(trait + " came back", expected, pairsAfterMoves(collision, agents, pairs));
            }
        }

        private static function changeSome(agents:Vector.<Agent>, change:Function):void
        {
            for (var i:int = 0; i < agents.length; i += 3)
            {
                change(agents[i]);
            }
        }

        // Few move, so that the others are not tested again unless they have changed.
        private static function pairsAfterMoves(collision:Collision, agents:Vector.<Agent>, pairs:Array):String
        {
            collision.update(agents);
            pairs.length = 0;
            for (var i:int = 0; i < agents.length; i += 4)
            {
                agents[i].x += 1.5;
            }
            collision.update(agents);
            return pairs.join(", ");
        }

        // Two games in step, of which one was brought back: they write the same bytes, whatever sign their zeros once had.
        [Test]
        public function zerosHaveNoSign():void
        {
            var negativeZero:Number = -1 / Infinity;
            var first:Collision = new Collision(new TightestFitCollider(_greatLand));
            first.terrain = new Terrain(4, 4);
            first.terrain.setHeights(0, 0, 4, 1, new <Number>[1, negativeZero, negativeZero, 2]);
            var agents:Vector.<Agent> = new <Agent>[agentAt("cube", 1, 1, 1), agentAt("cube", 1, 1, 1)];
            agents[0].moveTo(negativeZero, negativeZero, negativeZero);
            agents[1].jumpTo(negativeZero, negativeZero, negativeZero);
            for each (var angle:Number in [5, negativeZero])
            {
                agents[0].heading = agents[0].pitch = agents[0].roll = angle;
            }
            first.update(agents);
            var bytes:ByteArray = first.snapshot(true);

            var other:Collision = new Collision(new TightestFitCollider(_greatLand));
            other.terrain = new Terrain(4, 4);
            var others:Vector.<Agent> = new <Agent>[new Agent("cube"), new Agent("cube")];
            other.restore(bytes, others);
            assertEquals("the same agents", textOf(agents), textOf(others));
            assertEquals("the same bytes", hexOf(bytes), hexOf(other.snapshot(true)));
            first.terrain.setHeight(1, 0, 5);
            other.terrain.setHeight(1, 0, 5);
            assertEquals("the same ground", hexOf(first.snapshot()), hexOf(other.snapshot()));
            assertEquals("a place", Infinity, 1 / agents[0].x);
            assertEquals("an angle", Infinity, 1 / agents[0].heading);
        }

        [Test]
        public function whatCarriesAWalkerComesBack():void
        {
            for each (var withTraits:Boolean in [true, false])
            {
                var first:PlatformGame = new PlatformGame(_greatLand);
                first.run(5);
                var bytes:ByteArray = first.collision.snapshot(withTraits);
                var places:Array = first.traits();
                var expected:String = first.run(6);
                assertTrue(expected, first.carried > 5 * 0.1 && first.touches > 0);

                // others, created in another order
                var other:PlatformGame = new PlatformGame(_greatLand);
                other.frame = 5;
                other.agents.reverse();
                other.agents.unshift(other.agents.pop());
                if (!withTraits)
                {
                    other.putBack(places);
                }
                other.collision.restore(bytes, other.agents);
                assertEquals("elsewhere " + withTraits, expected, other.run(6));

                // the same, in the middle of a game
                first.frame = 5;
                if (!withTraits)
                {
                    first.putBack(places);
                }
                first.collision.restore(bytes, first.agents);
                assertEquals("again " + withTraits, expected, first.run(6));
            }
        }

        // A handler or a shaking camera may move a walker, and put it back before the next walk.
        [Test]
        public function whatCarriesAWalkerThatIsElsewhereForAMomentComesBack():void
        {
            var logs:Array = [];
            for each (var goesBack:Boolean in [false, true])
            {
                var game:PlatformGame = new PlatformGame(_greatLand);
                game.run(5);
                game.agents[0].x += 0.25;
                var bytes:ByteArray = game.collision.snapshot(true);
                if (goesBack)
                {
                    game.collision.restore(bytes, game.agents);
                }
                game.agents[0].x -= 0.25;
                logs.push(game.run(6));
            }
            assertEquals(logs[0], logs[1]);
        }

        [Test]
        public function methodsOfAGamesOwnAreNotCalled():void
        {
            var tile:Tile = new Tile();
            tile.size = 3;
            tile.hierarchical = tile.sweeps = true;
            tile.setQuaternion(0, 0, 1, 1);
            tile.place(2.25, 0.5, 0);
            var agents:Vector.<Agent> = new <Agent>[tile];
            var collision:Collision = new Collision(new TightestFitCollider(_greatLand));
            collision.update(agents);
            var bytes:ByteArray = collision.snapshot(true);
            tile.place(9, 9, 9);
            tile.size = 0.5;
            tile.setQuaternion(1, 0, 0, 0);
            tile.calls = 0;
            collision.restore(bytes, agents);
            assertEquals(0, tile.calls);
            assertEquals("2.25 0.5 3 90", [tile.x, tile.y, tile.size, tile.heading].join(" "));
            assertEquals(hexOf(bytes), hexOf(collision.snapshot(true)));
            assertThrows(ArgumentError, /no snapshot any more/, collision.restore, cutOff(bytes), agents);
            assertEquals(0, tile.calls);
            assertEquals(hexOf(bytes), hexOf(collision.snapshot(true)));
        }

        private static function cutOff(bytes:ByteArray):ByteArray
        {
            var short:ByteArray = new ByteArray();
            short.writeBytes(bytes, 0, bytes.length - 1);
            return short;
        }

        [Test]
        public function theGroundIsThereIfItIsAskedFor():void
        {
            var collision:Collision = new Collision(new TightestFitCollider(_greatLand));
            collision.terrain = new Terrain(20, 20);
            collision.terrain.setHeight(3, 3, 2);
            var agents:Vector.<Agent> = new <Agent>[agentAt("cube", 3, 3, 1)];
            var ends:int = 0;
            collision.onCollisionEnd("turtles", Collision.TERRAIN, function(agent:Agent, ground:Agent):void
                {
                    ends++;
                });
            collision.update(agents);
            var withGround:ByteArray = collision.snapshot(true);
            var without:ByteArray = collision.snapshot(true, false);
            assertTrue(without.length + " " + withGround.length, without.length < withGround.length - 8);
            collision.terrain.setHeight(3, 3, 5);
            agents[0].z = 9;
            collision.restore(without, agents);
            assertEquals(5, collision.terrain.heightAt(3, 3));
            assertEquals(1, agents[0].z);
            agents[0].z = 9;
            collision.update(agents);
            assertEquals("it touched the ground", 1, ends);
            collision.restore(withGround, agents);
            assertEquals(2, collision.terrain.heightAt(3, 3));
            collision.terrain = null;
            assertThrows(ArgumentError, /no snapshot of a Collision without ground/, collision.restore, without, agents);
        }

        [Test]
        public function roundingFollowsTheListAndNotTheAge():void
        {
            var turned:int = 0;
            for (var seed:int = 1; seed <= Effort.choose(60, 600); seed++)
            {
                var expected:Number = timeOfMeeting(seed, false, false);
                assertEquals("seed " + seed, expected, timeOfMeeting(seed, true, false));
                turned += expected == timeOfMeeting(seed, false, true) ? 0 : 1;
            }
            assertTrue("the other list rounds otherwise: " + turned, turned > 3);
        }

        // When two trees meet, or -1. Either may be the older one, and the first in the list.
        private function timeOfMeeting(seed:int, isSecondOlder:Boolean, isTurned:Boolean):Number
        {
            var random:SeededRandom = new SeededRandom(seed);
            var second:Agent = isSecondOlder ? new Agent("cylinder") : null;
            var first:Agent = new Agent("sphere");
            second ||= new Agent("cylinder");
            first.sweeps = true;
            for each (var agent:Agent in [first, second])
            {
                agent.setQuaternion(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
                agent.moveTo(random.between(-0.1, 0.1), random.between(-0.1, 0.1), random.between(-0.1, 0.1));
            }
            first.x -= 5;
            var collision:Collision = new Collision(EachCollider.make("triangles", _greatLand));
            var time:Number = -1;
            collision.onCollision("turtles", "turtles", function(a:Agent, b:Agent, contact:Contact):void
                {
                    time = contact.time;
                });
            var list:Vector.<Agent> = isTurned ? new <Agent>[second, first] : new <Agent>[first, second];
            collision.update(list);
            first.x += 5;
            collision.update(list);
            return time;
        }

        [Test]
        public function aShapeChangedAfterTheFrameHasNoMotion():void
        {
            var collision:Collision = new Collision(new BinCollider());
            var agents:Vector.<Agent> = new <Agent>[new Agent("sphere", "balls"), agentAt("sphere", 5, 0, 0)];
            agents[0].sweeps = true;
            var hits:int = 0;
            collision.onCollision("balls", "turtles", function(ball:Agent, wall:Agent):void
                {
                    hits++;
                });
            collision.update(agents);
            agents[0].shape = "cube";
            var bytes:ByteArray = collision.snapshot(true);
            agents[0].x = 20;
            collision.update(agents);
            assertEquals(0, hits);
            collision.restore(bytes, agents);
            agents[0].x = 20;
            collision.update(agents);
            assertEquals("after going back", 0, hits);
        }

        [Test]
        public function afterGoingBackAContactIsOfAgentsAsTheyAreNow():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var collider:BaseCollider = BaseCollider(EachCollider.make(name, _greatLand));
                var collision:Collision = new Collision(collider);
                var agents:Vector.<Agent> = new <Agent>[new Agent("sphere", "balls"), agentAt("sphere", 0.8, 0, 0)];
                collision.onCollision("balls", "turtles", ignore);
                collision.update(agents);
                agents[0].size = 3;
                agents[0].moveTo(5, 0, 0);
                collision.restore(collision.snapshot(true), agents);
                var contact:Contact = collider.contactOf(agents[0], agents[1]);
                assertEquals(name, EachCollider.make(name, _greatLand).contactOf(agents[0], agents[1]).toString(), contact.toString());
                assertEquals(name, 0, contact.depth);
            }
        }

        [Test]
        public function afterGoingBackAContactIsOfAgentsThatStand():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var collider:BaseCollider = BaseCollider(EachCollider.make(name, _greatLand));
                var collision:Collision = new Collision(collider);
                var agents:Vector.<Agent> = new <Agent>[new Agent("sphere", "balls"), agentAt("sphere", 0.9, 0, 0)];
                agents[0].sweeps = true;
                collision.onCollision("balls", "turtles", function(ball:Agent, wall:Agent):void
                    {
                    });
                collision.update(agents);
                var expected:Contact = collider.contactOf(agents[0], agents[1]);
                assertTrue(name + ": " + expected.depth, expected.depth > 0.09);
                var bytes:ByteArray = collision.snapshot(true);
                agents[0].x = -7;
                collision.update(agents);
                agents[0].x = 8;
                collision.update(agents);
                assertTrue(name + ": it comes from afar", collider.contactOf(agents[0], agents[1]).time > 0);
                collision.restore(bytes, agents);
                var contact:Contact = collider.contactOf(agents[0], agents[1]);
                assertEquals(name, expected.depth, contact.depth);
                assertEquals(name, 0, contact.approachSpeed);
                assertEquals(name, 1, contact.time);
            }
        }

        [Test]
        public function badBytesChangeNothing():void
        {
            var game:PlatformGame = new PlatformGame(_greatLand);
            game.run(5);
            var bytes:ByteArray = game.collision.snapshot(true);
            var random:SeededRandom = new SeededRandom(7);
            game.run(3);
            var now:String = stateOf(game);
            var refused:int = 0;
            var taken:int = 0;
            for (var i:int = 0; i < Effort.choose(120, 20000); i++)
            {
                var broken:ByteArray = new ByteArray();
                broken.writeBytes(bytes, 0, i % 4 == 0 ? random.integer(0, bytes.length - 1) : bytes.length);
                if (i % 4 == 1)
                {
                    broken.writeByte(random.integer(0, 255));
                }
                else if (i % 4 >= 2)
                {
                    var at:int = random.integer(0, bytes.length - 1);
                    broken[at] ^= random.integer(1, 255);
                    // the exponent of a number too
                    broken[Math.min(bytes.length - 1, at + 1)] = random.pick([0x7F, 0xFF, 0]);
                }
                try
                {
                    game.collision.restore(broken, game.agents);
                    taken++;
                    game.collision.restore(bytes, game.agents);
                    game.frame = 5;
                    game.run(3);
                }
                catch (error:ArgumentError)
                {
                    refused++;
                }
                assertEquals("try " + i, now, stateOf(game));
            }
            assertTrue("refused " + refused + ", taken " + taken, refused > 60 && taken > 2);
        }

        [Test]
        public function aModelThatIsNotThereChangesNothing():void
        {
            var game:PlatformGame = new PlatformGame(_greatLand);
            game.run(5);
            var bytes:ByteArray = game.collision.snapshot(true);
            var land:GreatLand = landOf(BuiltInModel.sphere());
            var other:Collision = new Collision(new TightestFitCollider(land));
            var agents:Vector.<Agent> = new Vector.<Agent>();
            var random:SeededRandom = new SeededRandom(3);
            for (var i:int = 0; i < game.agents.length; i++)
            {
                agents.push(randomAgent(random));
                agents[i].shape = "sphere";
            }
            other.update(agents);
            var before:String = textOf(agents) + hexOf(other.snapshot(true));
            assertThrows(ArgumentError, /no model "cube"/, other.restore, bytes, agents);
            assertEquals(before, textOf(agents) + hexOf(other.snapshot(true)));
        }

        // All that the game's next frames depend on.
        private static function stateOf(game:PlatformGame):String
        {
            return textOf(game.agents) + hexOf(game.collision.snapshot(true));
        }

        private static function randomAgent(random:SeededRandom):Agent
        {
            var agent:Agent = new Agent(random.pick(["sphere", "cube", "cylinder"]), random.pick(["bears", "balls", "hasOwnProperty"]));
            for (var i:int = 0; i < 6; i++)
            {
                change(agent, random);
            }
            return agent;
        }

        private static function change(agent:Agent, random:SeededRandom):void
        {
            var q:Vector.<Number> = agent.getQuaternion();
            switch (random.integer(0, 13))
            {
                case 0:
                    agent.setQuaternion(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
                    break;
                case 1:
                    agent.setQuaternion(q[0], q[1], q[2], q[3]);
                    break;
                case 2:
                    agent.setQuaternion(-q[0], -q[1], -q[2], -q[3]);
                    break;
                case 3:
                    agent.setMatrix(agent.transform);
                    break;
                case 4:
                    agent.heading = random.between(-400, 400);
                    break;
                case 5:
                    agent.roll = random.between(-400, 400);
                    break;
                case 6:
                    agent.size = random.logBetween(1e-6, 1e6);
                    break;
                case 7:
                    agent.color = random.pick([0, -0.5, 0xFFFFFF, 1e300]);
                    break;
                case 8:
                    agent.sweeps = !agent.sweeps;
                    agent.hierarchical = !agent.hierarchical;
                    agent.isOneWay = !agent.isOneWay;
                    break;
                case 9:
                    agent.collideAs = random.pick(["tightest", "sphere", "box", "capsule", "hull"]);
                    break;
                case 10:
                    agent.traversalDepth = random.integer(0, 9);
                    break;
                case 11:
                    agent.breed = random.pick(["bears", "\u0436\u00e9", "x"]);
                    break;
                default:
                    agent.moveTo(random.normal() * 1e3, random.between(-1e9, 1e9), random.normal());
            }
        }

        private static function textOf(agents:Vector.<Agent>):String
        {
            var lines:Array = [];
            for each (var a:Agent in agents)
            {
                lines.push([a.shape, a.breed, a.x, a.y, a.z, a.heading, a.pitch, a.roll, a.size, a.color, a.sweeps, a.hierarchical, a.isOneWay, a.traversalDepth,
                            a.collideAs, a.getQuaternion(), a.transform.rawData].join(" "));
            }
            return lines.join("\n");
        }

        private static function hexOf(bytes:ByteArray):String
        {
            var text:Array = [];
            for (var i:int = 0; i < bytes.length; i++)
            {
                text.push(bytes[i].toString(16));
            }
            return text.join();
        }
    }
}

import starlogo.GreatLand;
import starlogo.agents.Agent;
import starlogo.collision.Collision;
import starlogo.collision.TightestFitCollider;
import starlogo.queries.AgentQueries;
import starlogo.queries.Footing;

/** An agent with methods of its own: it stays on whole places. */
internal class Tile extends Agent
{
    public var calls:int = 0;

    public function Tile()
    {
        super("cube", "tiles");
    }

    override public function moveTo(x:Number, y:Number, z:Number):void
    {
        calls++;
        super.moveTo(Math.round(x), Math.round(y), z);
    }

    override public function setQuaternion(x:Number, y:Number, z:Number, w:Number):void
    {
        calls++;
        super.setQuaternion(x, y, z, w);
    }

    /** Puts it anywhere. */
    public function place(x:Number, y:Number, z:Number):void
    {
        super.moveTo(x, y, z);
    }
}

/** A ball on a platform that moves and turns, and one on the floor. */
internal class PlatformGame
{
    public var collision:Collision;
    public var agents:Vector.<Agent>;
    public var frame:int = 0;
    public var touches:int = 0;

    // How far the ball on the platform has come along x.
    public var carried:Number = 0;
    private var _queries:AgentQueries;

    public function PlatformGame(greatLand:GreatLand)
    {
        collision = new Collision(new TightestFitCollider(greatLand));
        _queries = new AgentQueries(collision);
        agents = new <Agent>[new Agent("sphere", "walkers"), new Agent("cube", "platforms"), new Agent("sphere", "walkers"), new Agent("cube", "floors")];
        agents[1].moveTo(0, 0, -0.1);
        agents[1].size = 1.5;
        agents[0].moveTo(0.3, 0.2, 2);
        agents[2].moveTo(9, 0.1, 0);
        agents[3].size = 40;
        agents[3].moveTo(0, 0, -40);
        collision.onCollisionStart("platforms", Collision.ANY_BREED, countTouch);
    }

    public function run(frames:int):String
    {
        var log:Array = [];
        for (var end:int = frame + frames; frame < end; frame++)
        {
            agents[1].x += 0.1;
            agents[1].heading += 3;
            _queries.update(agents);
            var from:Number = agents[0].x;
            for each (var walker:int in [0, 2])
            {
                var footing:Footing = _queries.walk(agents[walker], 0.001 * frame, 0.001);
                log.push([frame, walker, footing.stands, agents.indexOf(footing.on), footing.part, agents[walker].x, agents[walker].y, agents[walker].z,
                            agents[walker].heading].join(" "));
            }
            carried += agents[0].x - from;
            collision.update(agents);
        }
        return log.join("\n");
    }

    // Touches are kept for handlers alone.
    private function countTouch(platform:Agent, other:Agent):void
    {
        touches++;
    }

    /** The traits of the agents. */
    public function traits():Array
    {
        var all:Array = [];
        for each (var a:Agent in agents)
        {
            all.push([a.shape, a.breed, a.size, a.heading, a.x, a.y, a.z]);
        }
        return all;
    }

    /** Gives the agents these traits. */
    public function putBack(traits:Array):void
    {
        for (var i:int = 0; i < traits.length; i++)
        {
            agents[i].shape = traits[i][0];
            agents[i].breed = traits[i][1];
            agents[i].size = traits[i][2];
            agents[i].heading = traits[i][3];
            agents[i].jumpTo(traits[i][4], traits[i][5], traits[i][6]);
        }
    }
}
