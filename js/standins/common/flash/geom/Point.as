package flash.geom
{
    /** A point of the plane. */
    public class Point
    {
        public var x:Number;
        public var y:Number;

        public function Point(x:Number = 0, y:Number = 0)
        {
            this.x = x;
            this.y = y;
        }

        /** The distance of two points. */
        public static function distance(pt1:Point, pt2:Point):Number
        {
            return pt2.subtract(pt1).length;
        }

        /** The point between two: f = 1 is the first, 0 the second. */
        public static function interpolate(pt1:Point, pt2:Point, f:Number):Point
        {
            return new Point(pt2.x + (pt1.x - pt2.x) * f, pt2.y + (pt1.y - pt2.y) * f);
        }

        /** The point at a distance from the origin in a direction, in radians. */
        public static function polar(len:Number, angle:Number):Point
        {
            return new Point(len * Math.cos(angle), len * Math.sin(angle));
        }

        public function get length():Number
        {
            return Math.sqrt(x * x + y * y);
        }

        public function add(v:Point):Point
        {
            return new Point(x + v.x, y + v.y);
        }

        public function subtract(v:Point):Point
        {
            return new Point(x - v.x, y - v.y);
        }

        public function offset(dx:Number, dy:Number):void
        {
            x += dx;
            y += dy;
        }

        /** Gives the vector from the origin this length; the origin stays where it is. */
        public function normalize(thickness:Number):void
        {
            var length:Number = this.length;
            if (length > 0)
            {
                x *= thickness / length;
                y *= thickness / length;
            }
        }

        public function equals(toCompare:Point):Boolean
        {
            return x == toCompare.x && y == toCompare.y;
        }

        public function copyFrom(sourcePoint:Point):void
        {
            x = sourcePoint.x;
            y = sourcePoint.y;
        }

        public function setTo(xa:Number, ya:Number):void
        {
            x = xa;
            y = ya;
        }

        public function clone():Point
        {
            return new Point(x, y);
        }

        public function toString():String
        {
            return "(x=" + x + ", y=" + y + ")";
        }
    }
}
