package starlogo.geometry
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import starlogo.engine;
    import starlogo.models.ModelTransform;

    use namespace engine;

    /** Transforms that mirror are known by signs alone, whatever the size of their numbers. */
    public class AffineTransformTest
    {
        private static const SIZES:Array = [1e-160, 1e-109, 1e-3, 1, 1e3, 1e109, 1e150];

        [Test]
        public function aMirrorIsKnownAtAnySize():void
        {
            var turn:Placement = new Placement();
            turn.setRotation(20, 40, 70);
            var turned:AffineTransform = AffineTransform.of(turn);
            for each (var size:Number in SIZES)
            {
                for each (var other:Number in SIZES)
                {
                    for (var signs:int = 0; signs < 8; signs++)
                    {
                        var x:Number = (signs & 1) != 0 ? -size : size;
                        var y:Number = (signs & 2) != 0 ? -size : size;
                        var z:Number = (signs & 4) != 0 ? -other : other;
                        var isMirror:Boolean = x < 0 != (y < 0 != z < 0);
                        var text:String = [x, y, z].join();
                        assertEquals(text, isMirror, AffineTransform.of(turn, x, y, z).isMirror);
                        assertEquals(text, isMirror, AffineTransform.of(new Placement(), x, y, z).after(turned).isMirror);
                        assertEquals(text, isMirror, new ModelTransform(null, new Vector3D(x, y, z)).isMirror);
                    }
                }
            }
        }

        [Test]
        public function whatIsFlatDoesNotMirror():void
        {
            assertFalse(new AffineTransform().isMirror);
            assertFalse(AffineTransform.of(new Placement(), -1, 0, 1).isMirror);
            assertFalse(AffineTransform.of(new Placement(), 0, 0, 0).isMirror);
        }
    }
}
