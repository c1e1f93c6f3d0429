package starlogo.queries.motion
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.queries.SeenAgents;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.SolidModels;
    import support.agentAt;
    import support.landOf;

    use namespace engine;

    public class ShrunkSweepTest
    {
        // A building around the mover, and small things in it.
        [Test]
        public function ofSeveralRowsTheFirstOneThatIsMetCounts():void
        {
            var random:SeededRandom = new SeededRandom(741);
            var wrong:Complaints = new Complaints();
            var seen:SeenAgents = new SeenAgents(EachCollider.make("combinations, exact", landOf(SolidModels.all())));
            var body:MovingBody = new MovingBody(seen);
            var sweep:ShrunkSweep = new ShrunkSweep(new Depenetration());
            var from:Vector3D = new Vector3D();
            var motion:Vector3D = new Vector3D();
            var ofBuilding:int = 0;
            var ofThing:int = 0;
            for (var i:int = Effort.choose(200, 5000); i > 0; i--)
            {
                var building:Agent = agentAt(random.pick(["hollow", "doll", "apart"]), 0, 0, 0);
                building.size = 12;
                building.hierarchical = true;
                var agents:Vector.<Agent> = new <Agent>[agentAt("cube", random.between(-3, 3), random.between(-3, 3), random.between(2.5, 7)), building];
                for (var k:int = 0; k < 16; k++)
                {
                    var thing:Agent = agentAt(random.pick(["cube", "sphere", "apart"]), random.between(-5, 5), random.between(-5, 5), random.between(2, 9));
                    thing.hierarchical = random.chance();
                    agents.push(thing);
                }
                seen.update(agents);
                body.setToAgent(agents[0]);
                from.setTo(agents[0].x, agents[0].y, agents[0].z);
                motion.setTo(random.between(-9, 9), random.between(-9, 9), random.between(-9, 9));
                body.aim(motion.x, motion.y, motion.z);
                new NearRows(seen).findAlong(body, null);
                sweep.shrunk.begin(body, body.rows, from, motion);
                sweep.obstacles.copyFrom(body.rows);
                var impact:Impact = sweep.findFirstImpact(from, motion);
                var found:int = impact == null ? -1 : impact.row;
                var foundAt:Number = impact == null ? Infinity : impact.time;
                var expected:int = -1;
                var expectedAt:Number = Infinity;
                var first:Number = Infinity;
                for (k = 0; k < body.rows.count; k++)
                {
                    sweep.obstacles.count = 0;
                    sweep.obstacles.add(body.rows.values[k]);
                    impact = sweep.findFirstImpact(from, motion);
                    if (impact != null && countsAt(impact, sweep, motion) < first)
                    {
                        first = countsAt(impact, sweep, motion);
                        expected = impact.row;
                        expectedAt = impact.time;
                    }
                }
                wrong.addIf(found != expected || foundAt != expectedAt, "another row", found + " at " + foundAt + ", not " + expected + " at " + expectedAt);
                ofBuilding += int(expected == seen.rowOf(building) && expectedAt > 0);
                ofThing += int(expected >= 0 && expected != seen.rowOf(building) && expectedAt > 0);
            }
            wrong.assertNone();
            assertTrue(ofBuilding + " by the building, " + ofThing + " by a thing", ofBuilding > 30 && ofThing > 30);
        }

        // When an impact counts among others.
        private static function countsAt(impact:Impact, sweep:ShrunkSweep, motion:Vector3D):Number
        {
            var time:Number = impact.time;
            return time > 0 && impact.isNormalFallback ? time + sweep.shrunk.clearance / motion.length : time;
        }
    }
}
