package flash.display
{
    import flash.geom.Rectangle;

    /** Pixels, 0xaarrggbb each. */
    public class BitmapData
    {
        private var _width:int;
        private var _height:int;
        private var _pixels:Vector.<uint>;

        public function BitmapData(width:int, height:int, transparent:Boolean = true, fillColor:uint = 0xffffffff)
        {
            _width = width;
            _height = height;
            _pixels = new Vector.<uint>(width * height, true);
            fillRect(rect, fillColor);
        }

        public function get width():int
        {
            return _width;
        }

        public function get height():int
        {
            return _height;
        }

        public function get rect():Rectangle
        {
            return new Rectangle(0, 0, _width, _height);
        }

        public function getPixel(x:int, y:int):uint
        {
            return getPixel32(x, y) & 0xffffff;
        }

        public function getPixel32(x:int, y:int):uint
        {
            return isInside(x, y) ? _pixels[int(y * _width + x)] : 0;
        }

        public function setPixel(x:int, y:int, color:uint):void
        {
            setPixel32(x, y, 0xff000000 | color);
        }

        public function setPixel32(x:int, y:int, color:uint):void
        {
            if (isInside(x, y))
            {
                _pixels[int(y * _width + x)] = color;
            }
        }

        public function fillRect(rect:Rectangle, color:uint):void
        {
            for (var y:int = rect.top; y < rect.bottom; y++)
            {
                for (var x:int = rect.left; x < rect.right; x++)
                {
                    setPixel32(x, y, color);
                }
            }
        }

        /** Moves the picture; where nothing came from stays what was there. */
        public function scroll(x:int, y:int):void
        {
            var before:Vector.<uint> = _pixels.concat();
            for (var row:int = Math.max(0, y); row < Math.min(_height, _height + y); row++)
            {
                for (var column:int = Math.max(0, x); column < Math.min(_width, _width + x); column++)
                {
                    _pixels[int(row * _width + column)] = before[int((row - y) * _width + column - x)];
                }
            }
        }

        public function lock():void
        {
        }

        public function unlock(changeRect:Rectangle = null):void
        {
        }

        public function dispose():void
        {
            _width = _height = 0;
        }

        private function isInside(x:int, y:int):Boolean
        {
            return x >= 0 && x < _width && y >= 0 && y < _height;
        }
    }
}
