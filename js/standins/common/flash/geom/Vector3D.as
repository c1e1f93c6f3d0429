package flash.geom
{
    /** A point or vector. It has a fourth number, w, which only project, equals and nearEquals use. */
    public class Vector3D
    {
        /** (1, 0, 0). */
        public static const X_AXIS:Vector3D = new Vector3D(1, 0, 0);

        /** (0, 1, 0). */
        public static const Y_AXIS:Vector3D = new Vector3D(0, 1, 0);

        /** (0, 0, 1). */
        public static const Z_AXIS:Vector3D = new Vector3D(0, 0, 1);

        public var x:Number;
        public var y:Number;
        public var z:Number;
        public var w:Number;

        public function Vector3D(x:Number = 0, y:Number = 0, z:Number = 0, w:Number = 0)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        /** The angle between two vectors in radians; NaN if one has no length. */
        public static function angleBetween(a:Vector3D, b:Vector3D):Number
        {
            return Math.acos(a.dotProduct(b) / (a.length * b.length));
        }

        /** The distance between two points. */
        public static function distance(pt1:Vector3D, pt2:Vector3D):Number
        {
            var x:Number = pt2.x - pt1.x;
            var y:Number = pt2.y - pt1.y;
            var z:Number = pt2.z - pt1.z;
            return Math.sqrt(x * x + y * y + z * z);
        }

        public function get length():Number
        {
            return Math.sqrt(x * x + y * y + z * z);
        }

        public function get lengthSquared():Number
        {
            return x * x + y * y + z * z;
        }

        /** The sum of two vectors, with w = 0. */
        public function add(a:Vector3D):Vector3D
        {
            return new Vector3D(x + a.x, y + a.y, z + a.z);
        }

        /** The difference of two vectors, with w = 0. */
        public function subtract(a:Vector3D):Vector3D
        {
            return new Vector3D(x - a.x, y - a.y, z - a.z);
        }

        /** Adds a vector to this one; w stays. */
        public function incrementBy(a:Vector3D):void
        {
            x += a.x;
            y += a.y;
            z += a.z;
        }

        /** Subtracts a vector from this one; w stays. */
        public function decrementBy(a:Vector3D):void
        {
            x -= a.x;
            y -= a.y;
            z -= a.z;
        }

        /** Multiplies by a number; w stays. */
        public function scaleBy(s:Number):void
        {
            x *= s;
            y *= s;
            z *= s;
        }

        /** Reverses the vector; w stays. */
        public function negate():void
        {
            x = -x;
            y = -y;
            z = -z;
        }

        public function dotProduct(a:Vector3D):Number
        {
            return x * a.x + y * a.y + z * a.z;
        }

        /** The cross product, with w = 1. */
        public function crossProduct(a:Vector3D):Vector3D
        {
            return new Vector3D(y * a.z - z * a.y, z * a.x - x * a.z, x * a.y - y * a.x, 1);
        }

        /** Scales the vector to length 1. A vector of length 0 stays. Returns the old length. */
        public function normalize():Number
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (length == 0)
            {
                x = y = z = 0;
            }
            else
            {
                x /= length;
                y /= length;
                z /= length;
            }
            return length;
        }

        /** Divides x, y and z by w; w stays. */
        public function project():void
        {
            x /= w;
            y /= w;
            z /= w;
        }

        public function equals(toCompare:Vector3D, allFour:Boolean = false):Boolean
        {
            return x == toCompare.x && y == toCompare.y && z == toCompare.z && (!allFour || w == toCompare.w);
        }

        /**
         * Whether each coordinate differs by less than the tolerance. With allFour, the other vector's w must be less than the tolerance
         * too. As in Flash, this vector's own w is overwritten by the other's: not a slip of the pen.
         */
        public function nearEquals(toCompare:Vector3D, tolerance:Number, allFour:Boolean = false):Boolean
        {
            return Math.abs(x - toCompare.x) < tolerance && Math.abs(y - toCompare.y) < tolerance
                && Math.abs(z - toCompare.z) < tolerance && (!allFour || Math.abs(w = toCompare.w) < tolerance);
        }

        /** Copies x, y and z; w stays. */
        public function copyFrom(sourceVector3D:Vector3D):void
        {
            x = sourceVector3D.x;
            y = sourceVector3D.y;
            z = sourceVector3D.z;
        }

        /** Sets x, y and z; w stays. */
        public function setTo(xa:Number, ya:Number, za:Number):void
        {
            x = xa;
            y = ya;
            z = za;
        }

        public function clone():Vector3D
        {
            return new Vector3D(x, y, z, w);
        }

        public function toString():String
        {
            return "Vector3D(" + x + ", " + y + ", " + z + ")";
        }
    }
}
