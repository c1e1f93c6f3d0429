package starlogo.geometry
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    public class CubeRootTest
    {
        [Test]
        public function cubesHaveTheirRoots():void
        {
            for (var i:int = -2000; i <= 2000; i++)
            {
                assertEquals(i, cubeRoot(Number(i) * i * i));
            }
            assertEquals(true, Math.abs(cubeRoot(1e-300) / 1e-100 - 1) < 3e-16);
            assertTrue(isNaN(cubeRoot(NaN)));
            assertEquals(Infinity, cubeRoot(Infinity));
        }

        [Test]
        public function rootsAreWithinAUnitInTheLastPlace():void
        {
            var random:SeededRandom = new SeededRandom(2603);
            for (var i:int = 0; i < 2000; i++)
            {
                // a root of half the bits, whose cube has rounding of its own
                var root:Number = random.between(1, 2) * Math.pow(2, random.integer(-60, 60));
                assertTrue(Math.abs(cubeRoot(root * root * root) / root - 1) < 3e-16);
            }
        }
    }
}
