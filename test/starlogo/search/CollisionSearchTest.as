package starlogo.search
{
    import evaluation.pairs.SeededRandom;
    import flash.errors.IllegalOperationError;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.data.textOf;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collider;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.RandomWorlds;
    import support.SolidModels;
    import support.agentAt;
    import support.assertThrows;
    import support.landOf;

    /** Contacts of two agents of a search, or of now. */
    public class CollisionSearchTest
    {
        [Test]
        public function contactsAreMirroredInTheOppositeOrder():void
        {
            var random:SeededRandom = new SeededRandom(77);
            var land:GreatLand = landOf(SolidModels.all());
            var wrong:Complaints = new Complaints();
            var deep:int = 0;
            var compared:int = 0;
            for (var i:int = 0; i < Effort.choose(8, 200, 3); i++)
            {
                var agents:Vector.<Agent> = RandomWorlds.mixed(8, ["cube", "sphere", "hollow", "crossed", "apart", "open cube"], 1.5, random);
                var later:Agent = agentAt("cube", random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
                var isSwept:Boolean = random.chance();
                for each (var name:String in EachCollider.ALL_NAMES)
                {
                    var collider:Collider = EachCollider.make(name, land);
                    if (isSwept)
                    {
                        move(agents, collider, i);
                    }
                    var pairs:Vector.<Agent> = collider.findCollisions(agents).concat(new <Agent>[agents[1], later, later, agents[2]]);
                    for (var k:int = 0; k < pairs.length; k += 2)
                    {
                        var one:Contact = collider.contactOf(pairs[k], pairs[k + 1]);
                        var other:Contact = collider.contactOf(pairs[k + 1], pairs[k]);
                        compared++;
                        deep += one.depth > 0 ? 1 : 0;
                        wrong.addIf(textOf(one, 1) != textOf(other, -1), name + (isSwept ? ", swept" : ""), textOf(one, 1) + " and " + textOf(other, -1));
                    }
                }
            }
            wrong.assertNone();
            assertTrue(compared + " contacts, " + deep + " deep", deep > compared / 3 && deep > 60);
        }

        /** A collider that has seen a long game computes the contacts that a new one computes which sees this frame's list alone. */
        [Test]
        public function contactsDoNotDependOnEarlierFrames():void
        {
            var random:SeededRandom = new SeededRandom(78);
            var land:GreatLand = landOf(SolidModels.all());
            var wrong:Complaints = new Complaints();
            var compared:int = 0;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                var agents:Vector.<Agent> = RandomWorlds.mixed(10, ["cube", "sphere", "hollow", "crossed", "apart", "open cube"], 1.5, random);
                var collision:Collision = new Collision(EachCollider.make(name, land));
                var found:Array = [];
                collision.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, function(collider:Agent, collidee:Agent, contact:Contact):void
                    {
                        found.push([collider, collidee, textOf(contact, 1)]);
                    });
                for (var frame:int = Effort.choose(20, 300, 5); frame > 0; frame--)
                {
                    change(agents, random);
                    found.length = 0;
                    collision.update(agents);
                    var fresh:Collider = EachCollider.make(name, land);
                    fresh.findCollisions(agents);
                    for each (var of:Array in found)
                    {
                        compared++;
                        var expected:String = textOf(fresh.contactOf(of[0], of[1]), 1);
                        wrong.addIf(of[2] != expected, name, of[2] + ", not " + expected);
                    }
                }
            }
            wrong.assertNone();
            assertTrue(compared + " contacts", compared > 400);
        }

        [Test]
        public function aSearchWithinASearchIsRefused():void
        {
            var agents:Vector.<Agent> = new <Agent>[agentAt("a", 0, 0, 0), agentAt("b", 0.5, 0, 0), agentAt("asking", 1, 0, 0)];
            var choice:AskingChoice = new AskingChoice();
            var collider:Collider = new Collider(choice);
            choice.collider = collider;
            assertThrows(IllegalOperationError, /searches/, collider.findCollisions, agents);
            var collision:Collision = new Collision(collider);
            collision.onCollision("turtles", "turtles", function(a:Agent, b:Agent):void
                {
                });
            assertThrows(IllegalOperationError, /searches/, collision.update, agents);
            choice.collider = null;
            collision.update(agents);
            assertEquals("the game goes on", 6, collision.statistics.handlerCalls);
            assertEquals(6, collider.findCollisions(agents).length);
        }

        [Test]
        public function aSearchThatThrowsVoidsAllPairs():void
        {
            var collider:Collider = new BinCollider();
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < 50; i++)
            {
                agents.push(agentAt("any", i, 0, 0));
            }
            for (i = 0; i < 4; i++)
            {
                collider.findCollisions(agents);
            }
            assertEquals("few have changed", 0, collider.statistics.candidatePairs);
            assertThrows(ArgumentError, /twice/, collider.findCollisions, agents.concat(agents));
            collider.findCollisions(agents);
            assertTrue("" + collider.statistics.candidatePairs, collider.statistics.candidatePairs >= 49);
        }

        // Two agents exchange their places in the list, and others move, turn or stay.
        private static function change(agents:Vector.<Agent>, random:SeededRandom):void
        {
            var i:int = random.integer(0, agents.length - 1);
            var k:int = random.integer(0, agents.length - 1);
            var first:Agent = agents[i];
            agents[i] = agents[k];
            agents[k] = first;
            for each (var agent:Agent in agents)
            {
                agent.sweeps = false;
                if (random.chance(0.2))
                {
                    agent.moveTo(random.between(-1.5, 1.5), random.between(-1.5, 1.5), random.between(-1.5, 1.5));
                    agent.heading += random.pick([0, 0, 30]);
                }
            }
        }

        // Lets all agents sweep, and moves them after a first search.
        private static function move(agents:Vector.<Agent>, collider:Collider, seed:int):void
        {
            var random:SeededRandom = new SeededRandom(seed);
            collider.findCollisions(agents);
            for each (var agent:Agent in agents)
            {
                agent.sweeps = true;
                agent.moveTo(agent.x + random.between(-1, 1), agent.y + random.between(-1, 1), agent.z + random.between(-1, 1));
            }
        }

        private static function textOf(contact:Contact, side:int):String
        {
            return [contact.time, contact.depth, contact.approachSpeed, contact.point, side * contact.normal.x + 0, side * contact.normal.y + 0, side * contact.normal.z + 0].join(", ");
        }
    }
}

import flash.geom.Vector3D;
import starlogo.agents.Agent;
import starlogo.bounding.Sphere;
import starlogo.collision.Collider;
import starlogo.search.ModelShape;
import starlogo.search.ShapeChoice;

/** Asks its collider while it binds the shape of one model. */
class AskingChoice extends ShapeChoice
{
    public var collider:Collider = null;

    public function AskingChoice()
    {
        super(null, false);
    }

    override public function bind(shape:ModelShape, agent:Agent):void
    {
        shape.setStructure(new Sphere(new Vector3D(), 1));
        if (agent.shape == "asking" && collider != null)
        {
            collider.findCollisions(new <Agent>[new Agent("other")]);
        }
    }
}
