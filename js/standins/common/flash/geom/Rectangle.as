package flash.geom
{
    /** A rectangle along the axes: its corner with the smallest coordinates, and its size. One without area is empty. */
    public class Rectangle
    {
        public var x:Number;
        public var y:Number;
        public var width:Number;
        public var height:Number;

        public function Rectangle(x:Number = 0, y:Number = 0, width:Number = 0, height:Number = 0)
        {
            setTo(x, y, width, height);
        }

        public function get left():Number
        {
            return x;
        }

        /** Moves the left side alone, as the other sides' setters do. */
        public function set left(value:Number):void
        {
            width += x - value;
            x = value;
        }

        public function get right():Number
        {
            return x + width;
        }

        public function set right(value:Number):void
        {
            width = value - x;
        }

        public function get top():Number
        {
            return y;
        }

        public function set top(value:Number):void
        {
            height += y - value;
            y = value;
        }

        public function get bottom():Number
        {
            return y + height;
        }

        public function set bottom(value:Number):void
        {
            height = value - y;
        }

        public function get topLeft():Point
        {
            return new Point(x, y);
        }

        public function set topLeft(value:Point):void
        {
            left = value.x;
            top = value.y;
        }

        public function get bottomRight():Point
        {
            return new Point(x + width, y + height);
        }

        public function set bottomRight(value:Point):void
        {
            right = value.x;
            bottom = value.y;
        }

        public function get size():Point
        {
            return new Point(width, height);
        }

        public function set size(value:Point):void
        {
            width = value.x;
            height = value.y;
        }

        public function isEmpty():Boolean
        {
            return width <= 0 || height <= 0;
        }

        public function setEmpty():void
        {
            setTo(0, 0, 0, 0);
        }

        /** Moves all sides outwards, the centre staying. */
        public function inflate(dx:Number, dy:Number):void
        {
            x -= dx;
            width += 2 * dx;
            y -= dy;
            height += 2 * dy;
        }

        public function inflatePoint(point:Point):void
        {
            inflate(point.x, point.y);
        }

        public function offset(dx:Number, dy:Number):void
        {
            x += dx;
            y += dy;
        }

        public function offsetPoint(point:Point):void
        {
            offset(point.x, point.y);
        }

        /** Whether a point is inside; on the right and bottom sides it is not. */
        public function contains(x:Number, y:Number):Boolean
        {
            return x >= this.x && x < this.x + width && y >= this.y && y < this.y + height;
        }

        public function containsPoint(point:Point):Boolean
        {
            return contains(point.x, point.y);
        }

        /** Whether a rectangle is inside, its right and bottom sides perhaps on this one's. */
        public function containsRect(rect:Rectangle):Boolean
        {
            var right:Number = rect.x + rect.width;
            var bottom:Number = rect.y + rect.height;
            return contains(rect.x, rect.y) && right > x && right <= x + width && bottom > y && bottom <= y + height;
        }

        /** What two rectangles share: all 0 where they share no area. */
        public function intersection(toIntersect:Rectangle):Rectangle
        {
            var shared:Rectangle = new Rectangle();
            if (isEmpty() || toIntersect.isEmpty())
            {
                return shared;
            }
            shared.x = Math.max(x, toIntersect.x);
            shared.y = Math.max(y, toIntersect.y);
            shared.right = Math.min(x + width, toIntersect.x + toIntersect.width);
            shared.bottom = Math.min(y + height, toIntersect.y + toIntersect.height);
            if (shared.isEmpty())
            {
                shared.setEmpty();
            }
            return shared;
        }

        public function intersects(toIntersect:Rectangle):Boolean
        {
            return !intersection(toIntersect).isEmpty();
        }

        /** The smallest rectangle around both; the other if one is empty. */
        public function union(toUnion:Rectangle):Rectangle
        {
            if (isEmpty())
            {
                return toUnion.clone();
            }
            if (toUnion.isEmpty())
            {
                return clone();
            }
            var around:Rectangle = new Rectangle(Math.min(x, toUnion.x), Math.min(y, toUnion.y));
            around.right = Math.max(x + width, toUnion.x + toUnion.width);
            around.bottom = Math.max(y + height, toUnion.y + toUnion.height);
            return around;
        }

        public function equals(toCompare:Rectangle):Boolean
        {
            return x == toCompare.x && y == toCompare.y && width == toCompare.width && height == toCompare.height;
        }

        public function copyFrom(sourceRect:Rectangle):void
        {
            setTo(sourceRect.x, sourceRect.y, sourceRect.width, sourceRect.height);
        }

        public function setTo(xa:Number, ya:Number, widtha:Number, heighta:Number):void
        {
            x = xa;
            y = ya;
            width = widtha;
            height = heighta;
        }

        public function clone():Rectangle
        {
            return new Rectangle(x, y, width, height);
        }

        public function toString():String
        {
            return "(x=" + x + ", y=" + y + ", w=" + width + ", h=" + height + ")";
        }
    }
}
