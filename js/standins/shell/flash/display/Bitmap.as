package flash.display
{
    /** Would show pixels. */
    public class Bitmap extends DisplayObject
    {
        public var bitmapData:BitmapData;

        public function Bitmap(bitmapData:BitmapData = null, pixelSnapping:String = "auto", smoothing:Boolean = false)
        {
            this.bitmapData = bitmapData;
        }
    }
}
