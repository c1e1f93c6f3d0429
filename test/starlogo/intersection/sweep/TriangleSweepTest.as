package starlogo.intersection.sweep
{
    import org.flexunit.asserts.assertTrue;

    /** When moving triangles first touch, also triangles without area. */
    public class TriangleSweepTest
    {
        private static const FACE:Array = [-1, -1, 0, 1, -1, 0, 0, 2, 0];
        private static const LINE:Array = [-1, 0, 0, 1, 0, 0, 0, 0, 0];

        // the longest edge is from the second corner to the third
        private static const LAST_LONGEST:Array = [0, 0, 0, -1, 0, 0, 1, 0, 0];

        [Test]
        public function trianglesWithoutAreaTouchToo():void
        {
            // a name, two triangles of which the second goes down by 4, and the time
            var rows:Array = [
                    ["lines that cross", LINE, [0, -1, 2, 0, 1, 2, 0, 0, 2], 0.5],
                    ["the last edge is the longest", LAST_LONGEST, [0, -1, 2, 0, 1, 2, 0, 0, 2], 0.5],
                    ["of the other too", LINE, [0, 0, 2, 0, -1, 2, 0, 1, 2], 0.5],
                    ["parallel lines", LINE, [-3, 0, 2, 0, 0, 2, -1, 0, 2], 0.5],
                    ["a line through the middle of a face", FACE, [0, 0, 2, 0, 0, 3, 0, 0, 2.5], 0.5],
                    ["a face on the end of a line", [0, 0, 0, 0, 0, 1, 0, 0, 0.5], [-1, -1, 2, 1, -1, 2, 0, 2, 2], 0.25],
                    ["lines that pass", LINE, [2, -1, 2, 2, 1, 2, 2, 0, 2], RelativeMotion.NEVER],
                    ["faces", FACE, [-1, 1, 2, 1, 1, 2, 0, -2, 3], 0.5],
                    ["too far", LINE, [0, -1, 5, 0, 1, 5, 0, 0, 5], RelativeMotion.NEVER]];
            var sweep:TriangleSweep = new TriangleSweep();
            for each (var row:Array in rows)
            {
                var motion:RelativeMotion = new RelativeMotion(1);
                motion.z = -4;
                sweep.relate(Vector.<Number>(row[1]), 0, Vector.<Number>(row[2]), 0);
                sweep.findTime(motion);
                assertTrue(row[0] + ": " + motion.time, motion.time == row[3] || Math.abs(motion.time - row[3]) < 1e-9);
                motion.time = 0.2;
                sweep.findTime(motion);
                assertTrue(row[0] + ": not so soon, but " + motion.time, motion.time == RelativeMotion.NEVER);
            }
        }
    }
}
