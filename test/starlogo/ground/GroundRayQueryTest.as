package starlogo.ground
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import flash.utils.getTimer;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.engine;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.RayHit;
    import starlogo.terrain.Terrain;
    import support.Complaints;
    import support.Effort;
    import support.RandomGround;
    import support.landOf;

    use namespace engine;

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

        // The last border of 22 blocks of 0.37 is not at the same place by (columns - 1) * width + width / 2 as by -width / 2 + columns * width.
        [Test]
        public function aRayThatBeginsOnABorderDoesNotPassTheGround():void
        {
            var random:SeededRandom = new SeededRandom(771);
            var query:GroundRayQuery = new GroundRayQuery();
            for each (var first:Number in [0, -20.5, 13.7])
            {
                for each (var width:Number in [0.1, 0.37, 0.7])
                {
                    for (var count:int = 5; count < 40; count++)
                    {
                        var terrain:Terrain = new Terrain(count, count, width, first, first);
                        terrain.isBlocky = count % 3 > 0;
                        terrain.raiseMound(first, first, 1000 * count * width, 1);
                        var half:Number = terrain.isBlocky ? width / 2 : 0;
                        for each (var side:int in [-1, 1])
                        {
                            var from:Vector3D = new Vector3D(side < 0 ? first - half : first + (count - 1) * width + half, first + 2.2 * width, 0.5);
                            var ray:Ray = new Ray();
                            var out:RayCrossing = new RayCrossing();
                            ray.aim(from, new Vector3D(-side, random.between(-0.5, 0.5), random.between(0, 0.2)));
                            assertTrue(terrain + " from " + from, query.find(terrain.grid, ray, out) && out.distance < 1e-9);
                        }
                    }
                }
            }
        }

        // What is far from a short ray does not count, and no rounding of distances that it cannot reach.
        [Test(timeout="60000")]
        public function aShortRayOverTinyCellsIsQuick():void
        {
            var terrain:Terrain = new Terrain(501, 501, 1e-6);
            var query:GroundRayQuery = new GroundRayQuery();
            var ray:Ray = new Ray();
            var start:int = getTimer();
            for (var i:int = 0; i < 30; i++)
            {
                ray.aim(new Vector3D(2.5e-4, 2.5e-4, 3e-6), new Vector3D(0.1 * (i % 3), 0.2 * (i % 3), -1));
                assertTrue(query.find(terrain.grid, ray, new RayCrossing()));
            }
            assertTrue(getTimer() - start < 1000);
        }

        // A ray may begin far from its point.
        [Test]
        public function aRayBeginsInTheGroundWhereItsPartBegins():void
        {
            var terrain:Terrain = new Terrain(9, 9, 1, 0, 0);
            terrain.setHeight(4, 4, 2);
            var query:GroundRayQuery = new GroundRayQuery();
            for each (var from:Number in [0, 2, 3, 4, 6])
            {
                var ray:Ray = new Ray();
                ray.aim(new Vector3D(1, 4, 1), Vector3D.X_AXIS);
                ray.from = from;
                var out:RayCrossings = new RayCrossings();
                query.findAll(terrain.grid, ray, out);
                // the hill is from 2.5 to 3.5 of the ray
                assertEquals(from + ", inside", from > 2.5 && from < 3.5, out.count > 0 && out.items[0].side == RayCrossing.INSIDE);
            }
        }

        // The margin of a triangle is relative to its height too, not only to the width of its cell.
        [Test]
        public function raysTowardsTheEdgesOfANeedleMeetIt():void
        {
            var random:SeededRandom = new SeededRandom(8123);
            var query:GroundRayQuery = new GroundRayQuery();
            var missed:int = 0;
            var count:int = Effort.choose(1000, 20000, 300);
            for (var i:int = 0; i < count; i++)
            {
                var terrain:Terrain = new Terrain(5, 5, 0.1, 0, 0);
                var high:Number = random.between(500, 1000);
                terrain.setHeight(2, 2, high);
                // a point of the edge from the top to the foot that is on the needle's outline as seen along y
                var down:Number = random.between(0.1, 0.9);
                var to:Vector3D = new Vector3D(0.2 - 0.1 * down, 0.2, high * (1 - down));
                var direction:Vector3D = new Vector3D(0, random.pick([-1, 1]), random.between(-1, 1));
                direction.normalize();
                var ray:Ray = new Ray();
                var entry:RayCrossing = new RayCrossing();
                ray.aim(new Vector3D(to.x - high * direction.x, to.y - high * direction.y, to.z - high * direction.z), direction);
                missed += query.find(terrain.grid, ray, entry) && Math.abs(entry.distance - high) < 1 ? 0 : 1;
            }
            assertEquals(missed + " of " + count, 0, missed);
        }

        private static function textOf(hit:RayHit):String
        {
            return hit.distance + " at " + hit.point + " towards " + hit.normal;
        }
    }
}
