package starlogo.search
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.Model;
    import support.agentAt;

    /** Structures that are tested first decide nothing that the structures themselves decide otherwise. */
    public class OuterStructuresTest
    {
        // The spheres and capsules have to contain the boxes and capsules that they stand for, not only the models.
        [Test]
        public function preliminaryTestsChangeNoPair():void
        {
            var random:SeededRandom = new SeededRandom(480);
            var plain:GreatLand = new GreatLand();
            var thorough:GreatLand = new GreatLand();
            plain.loadHierarchies = thorough.loadHierarchies = false;
            thorough.loadAllBoundingStructures = true;
            for (var i:int = 0; i < 24; i++)
            {
                var points:Vector.<Number> = new Vector.<Number>();
                for (var k:int = 0; k < 3 * (4 + i % 4); k += 3)
                {
                    points.push(random.normal(), (1 + i % 3) * random.normal(), 0.5 * random.normal());
                }
                plain.addModel(new Model("m" + i, points));
                thorough.addModel(new Model("m" + i, points));
            }
            var all:TightestFitCollider = new TightestFitCollider(thorough);
            var alone:TightestFitCollider = new TightestFitCollider(plain);
            var found:int = 0;
            for (i = 0; i < 1500; i++)
            {
                all.structureTests.capsulesFirst = i % 2 == 0;
                var far:Number = random.pick([0, 0, 1e3, 1e8]);
                var agents:Vector.<Agent> = new Vector.<Agent>();
                for (k = 0; k < 2; k++)
                {
                    var agent:Agent = agentAt("m" + random.integer(0, 23), far + 0.4 * random.normal(), far + 0.4 * random.normal(), 0.4 * random.normal());
                    agent.heading = random.between(0, 360);
                    agent.pitch = random.between(0, 360);
                    agent.sweeps = i % 3 == 0;
                    agents.push(agent);
                }
                for (k = 0; k < 2; k++)
                {
                    var expected:Boolean = alone.findCollisions(agents).length > 0;
                    assertEquals(agents.join(), expected, all.findCollisions(agents).length > 0);
                    assertEquals(agents.join(), alone.areColliding(agents[0], agents[1]), all.areColliding(agents[0], agents[1]));
                    assertEquals(alone.contactOf(agents[0], agents[1]).time, all.contactOf(agents[0], agents[1]).time);
                    agents[0].moveTo(far + 0.4 * random.normal(), far + 0.4 * random.normal(), 0.4 * random.normal());
                    found += expected ? 1 : 0;
                }
            }
            assertTrue(found + " collide", found > 500 && found < 2500);
        }
    }
}
