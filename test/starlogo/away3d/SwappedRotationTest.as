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

        private var _turn:SwappedRotation = new SwappedRotation();

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
                _turn.setAngles(heading, pitch, roll);
                var there:Placement = new Placement();
                there.setRotation(_turn.heading, _turn.pitch, _turn.roll);
                var off:Number = Math.max(Math.abs(there.r00 - here.r00), Math.abs(there.r01 - here.r02), Math.abs(there.r02 - here.r01),
                        Math.abs(there.r10 - here.r20), Math.abs(there.r11 - here.r22), Math.abs(there.r12 - here.r21), Math.abs(there.r20 - here.r10),
                        Math.abs(there.r21 - here.r12), Math.abs(there.r22 - here.r11));
                assertTrue([heading, pitch, roll] + " is off by " + off, off < 1e-14);
            }
        }

        [Test]
        public function turnsOneWayGoOverAsTheyAre():void
        {
            _turn.setAngles(725, 0, 0);
            assertEquals("0,-725,0", [_turn.heading, _turn.pitch, _turn.roll].join());
            _turn.setAngles(0, 725, 30);
            assertEquals("-725,0,-30", [_turn.heading, _turn.pitch, _turn.roll].join());
        }

        [Test]
        public function pointsAreTurned():void
        {
            _turn.setAngles(90, 0, 0);
            assertTurned("-2,1,3", 1, 2, 3);
            _turn.setAngles(90, 90, 90);
            assertTurned("3,2,-1", 1, 2, 3);
        }

        private function assertTurned(expected:String, x:Number, y:Number, z:Number):void
        {
            var turned:Vector3D = _turn.turn(x, y, z);
            assertEquals(expected, [turned.x, turned.y, turned.z].join());
        }
    }
}
