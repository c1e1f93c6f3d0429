package flash.display
{
    /** Draws nothing. */
    public final class Graphics
    {
        public function clear():void
        {
        }

        public function beginFill(color:uint, alpha:Number = 1):void
        {
        }

        public function endFill():void
        {
        }

        public function lineStyle(thickness:Number = NaN, color:uint = 0):void
        {
        }

        public function drawRect(x:Number, y:Number, width:Number, height:Number):void
        {
        }

        public function drawRoundRect(x:Number, y:Number, width:Number, height:Number, ellipseWidth:Number, ellipseHeight:Number = NaN):void
        {
        }

        public function drawCircle(x:Number, y:Number, radius:Number):void
        {
        }
    }
}
