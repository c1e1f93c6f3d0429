package docs
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;

    /** For docs/terrain.md: a bear in a hill, and a ball that comes down on it. */
    public class TerrainPage extends Page
    {
        public static const FIXTURES:Array = [];

        public function TerrainPage()
        {
            ball.moveTo(-2, 1, 8);
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            assertTrue("the bear has come out", Math.abs(bear.z - shown.terrain.heightAt(bear.x, bear.y)) < 0.1);
            assertTrue("two for each cell, and walls", shown.triangles > 2 * 100 * 100);
            assertTrue(shown.lines.length > 0 && shown.lines.length % 6 == 0);
            assertEquals(shown.terrain.agent, shown.hit.agent);
            assertEquals(6, shown.hit.distance);
            assertTrue("the ball was stopped: " + shown.free, shown.free > 0.4 && shown.free < 0.6);
            assertTrue("it went on along the hill: " + ball.x, ball.x > -1);
            // the hill falls away below the plane along which the ball slides
            assertTrue("it stays near: " + shown.height, shown.height < 0.6);
            assertEquals(0, shown.others.length);
            assertFalse(shown.terrain.isUnder(ball));
        }
    }
}
