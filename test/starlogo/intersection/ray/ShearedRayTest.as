package starlogo.intersection.ray
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;

    /** From which side a ray crosses a triangle: its normal says it. */
    public class ShearedRayTest
    {
        [Test]
        public function theFrontIsWhereTheCornersAreCounterClockwise():void
        {
            var random:SeededRandom = new SeededRandom(5105);
            var shapes:RandomStructures = new RandomStructures(random);
            var sheared:ShearedRay = new ShearedRay();
            for (var i:int = 0; i < 3000; i++)
            {
                var a:Vector3D = shapes.position(1);
                var b:Vector3D = shapes.position(1);
                var c:Vector3D = shapes.position(1);
                var inside:Vector3D = new Vector3D((a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3);
                var ray:Ray = new Ray();
                var direction:Vector3D = shapes.direction();
                ray.aim(inside.subtract(direction), direction);
                var crossings:RayCrossings = new RayCrossings();
                sheared.setTo(ray, 2);
                sheared.addCrossing(new <Number>[a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z], -1, crossings);
                assertEquals(1, crossings.count);
                var normal:Vector3D = b.subtract(a).crossProduct(c.subtract(a));
                assertEquals("triangle " + i, normal.dotProduct(direction) < 0 ? RayCrossing.ENTERS : RayCrossing.LEAVES, crossings.items[0].side);
            }
        }
    }
}
