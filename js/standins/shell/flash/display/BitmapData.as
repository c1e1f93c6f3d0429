package flash.display
{
    import flash.geom.Rectangle;

    /** Pixels. They are not drawn. */
    public class BitmapData
    {
        public function BitmapData(width:int, height:int, transparent:Boolean = true, fillColor:uint = 0xffffffff)
        {
        }

        public function fillRect(rect:Rectangle, color:uint):void
        {
        }

        public function scroll(x:int, y:int):void
        {
        }
    }
}
