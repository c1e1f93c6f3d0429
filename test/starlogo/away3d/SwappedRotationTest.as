package starlogo.away3d
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.geometry.Placement;

    public class SwappedRotationTest
    {
        private static const ANGLES:Array = [0, 90, -90, 180, -180, 270, 360, 450, 89.99999999, 90.00000001, 1e-9, 45];

        private var _rotation:SwappedRotation = new SwappedRotation();

        [Test]
        public function itIsTheRotationWithYAndZSwapped():void
        {
            var random:SeededRandom = new SeededRandom(8);
            for (var i:int = 0; i < 2000; i++)
            {
                var heading:Number = random.chance() ? random.pick(ANGLES) : random.between(-400, 400);
                var pitch:Number = random.chance() ? random.pick(ANGLES) : random.between(-400, 400);
                var roll:Number = random.chance() ? random.pick(ANGLES) : random.between(-400, 400);
                var here:Placement = new Placement();
                here.setRotation(heading, pitch, roll);
                var angles:Vector3D = _rotation.setAngles(heading, pitch, roll);
                var there:Placement = new Placement();
                there.setRotation(angles.z, angles.y, angles.x);
                var off:Number = Math.max(Math.abs(there.r00 - here.r00), Math.abs(there.r01 - here.r02), Math.abs(there.r02 - here.r01),
                        Math.abs(there.r10 - here.r20), Math.abs(there.r11 - here.r22), Math.abs(there.r12 - here.r21), Math.abs(there.r20 - here.r10),
                        Math.abs(there.r21 - here.r12), Math.abs(there.r22 - here.r11));
                assertTrue([heading, pitch, roll] + " is off by " + off, off < 1e-14);
            }
        }

        [Test]
        public function turnsOneWayGoOverAsTheyAre():void
        {
            assertNumbers("0,-725,0", _rotation.setAngles(725, 0, 0));
            assertNumbers("-30,0,-725", _rotation.setAngles(0, 725, 30));
        }

        [Test]
        public function pointsAreTurned():void
        {
            _rotation.setAngles(90, 0, 0);
            assertNumbers("-2,1,3", _rotation.rotate(1, 2, 3));
            _rotation.setAngles(90, 90, 90);
            assertNumbers("3,2,-1", _rotation.rotate(1, 2, 3));
        }

        private static function assertNumbers(expected:String, vector:Vector3D):void
        {
            assertEquals(expected, [vector.x, vector.y, vector.z].join());
        }
    }
}
