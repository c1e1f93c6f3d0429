package flash.display
{
    /** The ways in which the stage fills its window. */
    public final class StageScaleMode
    {
        public static const NO_SCALE:String = "noScale";
    }
}
