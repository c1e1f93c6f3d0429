package starlogo.intersection.ray
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    /** From which side a ray crosses a triangle: its normal says it. And rays that begin on a triangle. */
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

        [Test]
        public function aRayThatBeginsOnATriangleMeetsItThere():void
        {
            var random:SeededRandom = new SeededRandom(5106);
            var shapes:RandomStructures = new RandomStructures(random);
            var sheared:ShearedRay = new ShearedRay();
            var atStart:int = 0;
            for (var i:int = 0; i < 3000; i++)
            {
                var a:Vector3D = shapes.position(1);
                var u:Vector3D = shapes.position(1).subtract(a);
                var v:Vector3D = shapes.position(1).subtract(a);
                var normal:Vector3D = u.crossProduct(v);
                if (normal.length < 0.01)
                {
                    continue;
                }
                normal.normalize();
                var s:Number = random.between(0.01, 0.5);
                var t:Number = random.between(0.01, 0.48);
                var start:Vector3D = new Vector3D(a.x + s * u.x + t * v.x, a.y + s * u.y + t * v.y, a.z + s * u.z + t * v.z);
                // every third is nearly along the triangle
                var direction:Vector3D = shapes.direction();
                var across:Number = direction.dotProduct(normal) * (i % 3 == 0 ? 0.999 : 0);
                direction.decrementBy(new Vector3D(across * normal.x, across * normal.y, across * normal.z));
                direction.normalize();
                var slope:Number = direction.dotProduct(normal);
                if (Math.abs(slope) < 1e-4)
                {
                    continue;
                }
                var ray:Ray = new Ray();
                ray.direction.copyFrom(direction);
                ray.from = random.between(-2, 2);
                var corners:Vector.<Number> = new <Number>[a.x, a.y, a.z, a.x + u.x, a.y + u.y, a.z + u.z, a.x + v.x, a.y + v.y, a.z + v.z];
                for each (var behind:Number in [0, 5e-15, 1e-12])
                {
                    var ahead:Number = behind / Math.abs(slope) - ray.from;
                    ray.origin.setTo(start.x + ahead * direction.x, start.y + ahead * direction.y, start.z + ahead * direction.z);
                    var crossings:RayCrossings = new RayCrossings();
                    sheared.setTo(ray, 2);
                    sheared.addCrossing(corners, -1, crossings);
                    assertEquals("triangle " + i + ", begun " + behind + " behind it", behind < 1e-13 ? 1 : 0, crossings.count);
                    if (crossings.count > 0)
                    {
                        atStart += crossings.items[0].distance == ray.from ? 1 : 0;
                        assertTrue("triangle " + i, Math.abs(crossings.items[0].distance - ray.from) <= 1e-14 / Math.abs(slope));
                    }
                }
            }
            assertTrue("begun behind the plane: " + atStart, atStart > 2000);
        }

        [Test]
        public function aRayNearlyAlongATriangleThatBeginsBesideItDoesNotMeetIt():void
        {
            var sheared:ShearedRay = new ShearedRay();
            var corners:Vector.<Number> = new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0];
            for each (var slope:Number in [1e-12, 1e-11, 1e-10])
            {
                for each (var x:Number in [0.79, 0.805])
                {
                    // the line crosses the plane 0.009 to 0.00009 before the ray begins
                    var ray:Ray = new Ray();
                    ray.origin.setTo(x, 0.2, 0.9e-14);
                    ray.direction.setTo(1, 0, slope);
                    var crossings:RayCrossings = new RayCrossings();
                    sheared.setTo(ray, 1);
                    sheared.addCrossing(corners, -1, crossings);
                    assertEquals("from " + x + ", slope " + slope, x < 0.8 ? 1 : 0, crossings.count);
                }
            }
        }
    }
}
