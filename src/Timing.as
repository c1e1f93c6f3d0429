package
{
    import flash.display.Sprite;
    import headless.Host;

    /** The timing harness: a game in the player, and what its collisions cost. */
    public class Timing extends Sprite
    {
        /** Starts the run. */
        public function Timing()
        {
            trace("timing");
            Host.exit(0);
        }
    }
}
