package flash.display
{
    /** The places of the stage in its window. */
    public final class StageAlign
    {
        public static const TOP_LEFT:String = "TL";
    }
}
