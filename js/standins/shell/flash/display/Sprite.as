package flash.display
{
    import flash.geom.Rectangle;

    /** A container that would draw. */
    public class Sprite extends DisplayObjectContainer
    {
        public var buttonMode:Boolean = false;

        private var _graphics:Graphics = new Graphics();

        public function get graphics():Graphics
        {
            return _graphics;
        }

        public function startDrag(lockCenter:Boolean = false, bounds:Rectangle = null):void
        {
        }

        public function stopDrag():void
        {
        }
    }
}
