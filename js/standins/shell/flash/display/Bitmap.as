package flash.display
{
    /** A bitmap that is not drawn. */
    public class Bitmap extends DisplayObject
    {
        public function Bitmap(bitmapData:BitmapData = null)
        {
        }
    }
}
