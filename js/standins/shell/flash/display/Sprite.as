package flash.display
{
    /** A container that would draw. */
    public class Sprite extends DisplayObjectContainer
    {
        private var _graphics:Graphics = new Graphics();

        public function get graphics():Graphics
        {
            return _graphics;
        }

        public function startDrag():void
        {
        }

        public function stopDrag():void
        {
        }
    }
}
