package starlogo.search
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertTrue;
    import starlogo.data.textOf;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.collision.Contact;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.RandomWorlds;
    import support.SolidModels;
    import support.agentAt;
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
