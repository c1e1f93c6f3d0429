package evaluation.literal
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.fitting.CapsuleFitter;
    import starlogo.fitting.MinimalSphereFitter;
    import starlogo.fitting.OrientedBoxFitter;
    import support.PointSets;

    public class LiteralFitsTest
    {
        // The order of the vertices does not matter to a capsule that grows at the nearer end only.
        [Test]
        public function grownCapsuleIsTheFittersOne():void
        {
            var random:SeededRandom = new SeededRandom(53);
            for (var i:int = 0; i < 12; i++)
            {
                var cloud:Vector.<Number> = PointSets.turned(PointSets.cloud(random, 50, 1, 0.4, 0.3), random);
                var box:OrientedBoxFitter = new OrientedBoxFitter(15);
                var grown:Capsule = grownCapsule(cloud, Box(box.fit(cloud)));
                var fitted:Number = new CapsuleFitter(box).fit(cloud).volume;
                assertTrue(grown.volume + " instead of " + fitted, Math.abs(grown.volume / fitted - 1) < 1e-6);
            }
        }

        [Test]
        public function ritterSphereEnclosesAllAndDependsOnItsFirstVertex():void
        {
            var cloud:Vector.<Number> = PointSets.cloud(new SeededRandom(59), 60, 1, 0.8, 0.7);
            var least:Number = new MinimalSphereFitter().fit(cloud).volume;
            var volumes:Object = {};
            var others:int = 0;
            for (var first:int = 0; first < 60; first++)
            {
                var sphere:Sphere = ritterSphere(cloud, first);
                for (var i:int = 0; i < cloud.length; i += 3)
                {
                    var x:Number = cloud[i] - sphere.center.x;
                    var y:Number = cloud[i + 1] - sphere.center.y;
                    var z:Number = cloud[i + 2] - sphere.center.z;
                    assertTrue("vertex " + i / 3, Math.sqrt(x * x + y * y + z * z) <= sphere.radius * (1 + 1e-12));
                }
                assertTrue(sphere.volume + " is at least " + least, sphere.volume >= least * (1 - 1e-9));
                others += sphere.volume.toFixed(6) in volumes ? 0 : 1;
                volumes[sphere.volume.toFixed(6)] = true;
            }
            assertTrue(others + " volumes", others > 1);
            assertEquals("two vertices", 0.5, ritterSphere(new <Number>[0, 0, 0, 1, 0, 0], 1).radius);
        }
    }
}
