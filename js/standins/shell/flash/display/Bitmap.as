package flash.display
{
    /** Would show pixels. */
    public class Bitmap extends DisplayObject
    {
        public function Bitmap(bitmapData:BitmapData = null)
        {
        }
    }
}
