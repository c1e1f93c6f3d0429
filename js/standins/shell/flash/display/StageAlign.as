package flash.display
{
    /** Where the stage is in its window. */
    public final class StageAlign
    {
        public static const TOP_LEFT:String = "TL";
    }
}
