package flash.display
{
    /** Would draw. */
    public class Shape extends DisplayObject
    {
        private var _graphics:Graphics = new Graphics();

        public function get graphics():Graphics
        {
            return _graphics;
        }
    }
}
