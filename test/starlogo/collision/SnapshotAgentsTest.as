package starlogo.collision
{
    import starlogo.agents.Agent;
    import support.assertThrows;

    /** A Collision remembers which agents its last snapshots belong to. */
    public class SnapshotAgentsTest
    {
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
    }
}
