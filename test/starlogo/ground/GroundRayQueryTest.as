package starlogo.ground
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.RayHit;
    import starlogo.terrain.Terrain;
    import support.Complaints;
    import support.Effort;
    import support.RandomGround;
    import support.landOf;

    /** Rays that meet the ground. */
    public class GroundRayQueryTest
    {
        [Test]
        public function theDistanceDoesNotDependOnWhereTheRayEnds():void
        {
            var random:SeededRandom = new SeededRandom(4170);
            var wrong:Complaints = new Complaints();
            var collision:Collision = new Collision(new BinCollider(landOf(BuiltInModel.sphere())));
            var queries:AgentQueries = new AgentQueries(collision);
            var met:int = 0;
            var walls:int = 0;
            var count:int = Effort.choose(90, 2000, 18);
            for (var i:int = 0; i < count; i++)
            {
                var kind:String = RandomGround.KINDS[i % RandomGround.KINDS.length];
                var terrain:Terrain = RandomGround.make(kind, random);
                collision.terrain = terrain;
                queries.update(new <Agent>[]);
                for (var k:int = 0; k < 30; k++)
                {
                    var width:Number = terrain.cellWidth * Math.min(terrain.columns, terrain.rows);
                    var origin:Vector3D = new Vector3D(terrain.x + random.between(-0.3, 1.3) * width, terrain.y + random.between(-0.3, 1.3) * width, random.between(-1, 2) * width);
                    var direction:Vector3D = new Vector3D(random.normal(), random.normal(), random.pick([0, random.normal(), -1]));
                    var whole:RayHit = queries.cast(origin, direction);
                    if (whole == null || whole.distance == 0)
                    {
                        continue;
                    }
                    met++;
                    walls += whole.normal.z == 0 ? 1 : 0;
                    for each (var part:Number in [1, 1 + 1e-15, 1.5, 100])
                    {
                        var hit:RayHit = queries.cast(origin, direction, part * whole.distance);
                        wrong.addIf(hit == null || textOf(hit) != textOf(whole), kind + " up to " + part, textOf(whole) + " and " + (hit && textOf(hit)));
                    }
                }
            }
            wrong.assertNone();
            assertTrue(met + " met, " + walls + " walls", met > 3 * count && walls > met / 8 && walls < met / 1.2);
        }

        private static function textOf(hit:RayHit):String
        {
            return hit.distance + " at " + hit.point + " towards " + hit.normal;
        }
    }
}
