package starlogo.solid
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Box;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.engine;
    import starlogo.intersection.intersects;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.Complaints;
    import support.Effort;
    import support.SolidModels;
    import support.agentAt;
    import support.landOf;

    use namespace engine;

    /** What is wholly inside of a turned model collides: boxes say what is right. */
    public class InsideOfModelsTest
    {
        [Test]
        public function aTurnedModelOfCubesCollidesWhereOneOfItsCubesDoes():void
        {
            var parts:Array = [[0.3, 0, 0, 0, false], [0.2, 0.5, 0.1, 0.2, false], [0.1, -0.3, 0.4, 0.6, false]];
            var land:GreatLand = landOf(BuiltInModel.cube(), SolidModels.of("parts", parts, Model.AS_GIVEN));
            var collider:HierarchicalCollider = new HierarchicalCollider(land);
            collider.exact = true;
            var random:SeededRandom = new SeededRandom(743);
            var wrong:Complaints = new Complaints();
            var count:int = Effort.choose(1500, 20000, 150);
            var inside:int = 0;
            var outside:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var several:Agent = tilted("parts", random);
                var cube:Agent = tilted("cube", random);
                cube.size = random.between(1, 2.5);
                var walls:Box = boxIn(cube, 1, 0, 0, 0);
                var isTouching:Boolean = false;
                var isSurfaceCut:Boolean = false;
                for each (var part:Array in parts)
                {
                    var box:Box = boxIn(several, part[0], part[1], part[2], part[3]);
                    var overlaps:Boolean = intersects(box, walls);
                    isTouching = isTouching || overlaps;
                    isSurfaceCut = isSurfaceCut || overlaps && !isWithin(box, walls);
                }
                inside += isTouching && !isSurfaceCut ? 1 : 0;
                outside += isTouching ? 0 : 1;
                wrong.addIf(collider.areColliding(several, cube) != isTouching, "either", "pose " + i + ", " + isTouching);
                wrong.addIf(collider.areColliding(cube, several) != isTouching, "the other order", "pose " + i + ", " + isTouching);
            }
            wrong.assertNone();
            assertTrue(inside + " wholly inside, " + outside + " apart of " + count, inside > count / 100 && outside > count / 10);
        }

        /** The radius of a tree is half the diagonal of its box, so a part that is longer than the radius may be inside. */
        [Test]
        public function aPartLongerThanTheRadiusIsInside():void
        {
            for each (var size:Number in [0.6, 0.9, 0.99])
            {
                var parts:Array = [[size, 0, 0, (1 - size) / 2, false]];
                var collider:HierarchicalCollider = new HierarchicalCollider(landOf(BuiltInModel.cube(), SolidModels.of("inner", parts, Model.AS_GIVEN)));
                collider.exact = true;
                var outer:Agent = agentAt("cube", 0, 0, 0);
                var inner:Agent = agentAt("inner", 0, 0, 0);
                assertTrue("size " + size, collider.areColliding(outer, inner));
                assertTrue("size " + size + ", the other order", collider.areColliding(inner, outer));
            }
        }

        private static function tilted(shape:String, random:SeededRandom):Agent
        {
            var agent:Agent = agentAt(shape, random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
            agent.heading = random.between(0, 360);
            agent.pitch = random.between(-90, 90);
            agent.roll = random.between(-180, 180);
            return agent;
        }

        // A cube of a model that stands at x, y, z in it, in the world.
        private static function boxIn(agent:Agent, size:Number, x:Number, y:Number, z:Number):Box
        {
            var cube:Box = new Box(new Vector3D(x, y, z + size / 2), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, size / 2, size / 2, size / 2);
            return Box(cube.place(agent.freshPlacement()));
        }

        private static function isWithin(box:Box, walls:Box):Boolean
        {
            for (var i:int = 0; i < 8; i++)
            {
                var corner:Vector3D = box.center.clone();
                addScaled(corner, box.axisX, i & 1 ? box.halfX : -box.halfX);
                addScaled(corner, box.axisY, i & 2 ? box.halfY : -box.halfY);
                addScaled(corner, box.axisZ, i & 4 ? box.halfZ : -box.halfZ);
                if (!walls.contains(corner))
                {
                    return false;
                }
            }
            return true;
        }

        private static function addScaled(point:Vector3D, axis:Vector3D, length:Number):void
        {
            point.x += length * axis.x;
            point.y += length * axis.y;
            point.z += length * axis.z;
        }
    }
}
