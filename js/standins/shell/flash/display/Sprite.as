package flash.display
{
    /** A container. It is not drawn. */
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
