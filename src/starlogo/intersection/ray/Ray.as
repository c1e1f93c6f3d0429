package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Placement;

    /**
     * A part of a line, which the kernels narrow to what is inside of a shape.
     *
     * <p>A place on the line is a number: how far along the direction, which is of length 1, it is from (x, y, z). That point should be close to the
     * shapes that are asked about, wherever the part begins: rounding goes with its distance. Fields, because V8 makes an object of each Number that
     * it passes.</p>
     *
     * @private
     */
    public final class Ray
    {
        // two to the power of 400, beyond which squares are not to be had, and to that of 600
        private static const LARGE:Number = 2.582249878086909e120;
        private static const SCALE:Number = 4.149515568880993e180;

        /** A point of the line. */
        public var x:Number = 0;

        /** @copy #x */
        public var y:Number = 0;

        /** @copy #x */
        public var z:Number = 0;

        /** The line's direction, of length 1. */
        public var directionX:Number = 0;

        /** @copy #directionX */
        public var directionY:Number = 0;

        /** @copy #directionX */
        public var directionZ:Number = 0;

        /** Where the part begins: at a shape's surface, or where the ray does. */
        public var from:Number = 0;

        /** Where the part ends. */
        public var to:Number = Infinity;

        /** Of length 1, out of the surface that the part begins at; against the ray if it begins where the ray does. */
        public var normalX:Number = 0;

        /** @copy #normalX */
        public var normalY:Number = 0;

        /** @copy #normalX */
        public var normalZ:Number = 0;

        /** Where the line enters a shape; see narrow. */
        public var near:Number = 0;

        /** Where the line leaves the shape. */
        public var far:Number = 0;

        /** The radius of balls; see addBall. */
        public var radius:Number = 0;

        /** Of a slab, which is between two parallel planes: how far the point of the line is from the middle; see cut. */
        public var offset:Number = 0;

        /** How far the line goes across the slab in a length of 1; may be 0. */
        public var speed:Number = 0;

        /** How far each plane is from the middle. */
        public var half:Number = 0;

        // not the constant: where one was written before, V8 makes an object of the next Number
        private var _infinity:Number = Infinity;

        /** A ray that leads nowhere. */
        public function Ray()
        {
        }

        /** Takes over the line of another ray as it is seen in the space of a model. Its part is to be set then. */
        public function bringInto(placement:Placement, line:Ray):void
        {
            scale(line, placement.size);
            var toX:Number = x;
            var toY:Number = y;
            var toZ:Number = z;
            x = placement.r00 * toX + placement.r10 * toY + placement.r20 * toZ;
            y = placement.r01 * toX + placement.r11 * toY + placement.r21 * toZ;
            z = placement.r02 * toX + placement.r12 * toY + placement.r22 * toZ;
            toX = line.directionX;
            toY = line.directionY;
            toZ = line.directionZ;
            directionX = placement.r00 * toX + placement.r10 * toY + placement.r20 * toZ;
            directionY = placement.r01 * toX + placement.r11 * toY + placement.r21 * toZ;
            directionZ = placement.r02 * toX + placement.r12 * toY + placement.r22 * toZ;
        }

        /** Takes over the line of another ray in a space whose unit is a length in the other's. */
        public function scale(line:Ray, size:Number):void
        {
            x = line.x / size;
            y = line.y / size;
            z = line.z / size;
            directionX = line.directionX;
            directionY = line.directionY;
            directionZ = line.directionZ;
        }

        /** Whether products of the line's numbers are numbers. */
        public function get isFinite():Boolean
        {
            return x * x + y * y + z * z < Infinity;
        }

        /** Makes it the ray from a point in a direction of any length. @throws ArgumentError if one is null or not finite, or the direction is 0 */
        public function aim(origin:Vector3D, direction:Vector3D):void
        {
            if (origin == null || direction == null)
            {
                throw new ArgumentError("a ray needs an origin and a direction, not " + origin + " and " + direction);
            }
            if (!(Math.abs(origin.x) + Math.abs(origin.y) + Math.abs(origin.z) < Infinity))
            {
                throw new ArgumentError("a ray's origin must be finite: " + origin);
            }
            var largest:Number = Math.max(Math.abs(direction.x), Math.abs(direction.y));
            largest = Math.max(largest, Math.abs(direction.z));
            if (!(largest > 0 && largest < Infinity))
            {
                throw new ArgumentError("a ray needs a direction, finite and not 0: " + direction);
            }
            // squares neither overflow nor vanish
            var scale:Number = 1;
            if (largest > LARGE)
            {
                scale = 1 / SCALE;
            }
            else if (largest < 1 / LARGE)
            {
                scale = SCALE;
            }
            var toX:Number = direction.x * scale;
            var toY:Number = direction.y * scale;
            var toZ:Number = direction.z * scale;
            var length:Number = Math.sqrt(toX * toX + toY * toY + toZ * toZ);
            directionX = toX / length;
            directionY = toY / length;
            directionZ = toZ / length;
            x = origin.x;
            y = origin.y;
            z = origin.z;
            from = 0;
            to = Infinity;
            faceBack();
        }

        /** Turns the normal round if it is along the ray. */
        public function turnNormal():void
        {
            if (normalX * directionX + normalY * directionY + normalZ * directionZ > 0)
            {
                normalX = -normalX;
                normalY = -normalY;
                normalZ = -normalZ;
            }
        }

        /** Makes the normal the ray's direction turned round: for where it begins inside of a shape. */
        public function faceBack():void
        {
            normalX = -directionX;
            normalY = -directionY;
            normalZ = -directionZ;
        }

        /** Makes near and far those of the whole line. */
        public function beginWhole():void
        {
            near = -_infinity;
            far = _infinity;
        }

        /** Makes near and far those of nothing. */
        public function beginEmpty():void
        {
            near = _infinity;
            far = -_infinity;
        }

        /** Narrows near and far to where the line is between the two planes of a slab; returns whether near has changed. */
        public function cut():Boolean
        {
            if (speed == 0)
            {
                if (offset > half || offset < -half)
                {
                    far = -_infinity;
                }
                return false;
            }
            var reach:Number = speed > 0 ? half : -half;
            var first:Number = (-reach - offset) / speed;
            var last:Number = (reach - offset) / speed;
            if (last < far)
            {
                far = last;
            }
            if (first > near)
            {
                near = first;
                return true;
            }
            return false;
        }

        /** Widens near and far to where the line is in a ball with the radius. */
        public function addBall(middle:Vector3D):void
        {
            var toX:Number = middle.x - x;
            var toY:Number = middle.y - y;
            var toZ:Number = middle.z - z;
            var along:Number = toX * directionX + toY * directionY + toZ * directionZ;
            toX -= along * directionX;
            toY -= along * directionY;
            toZ -= along * directionZ;
            var squared:Number = radius * radius - (toX * toX + toY * toY + toZ * toZ);
            if (squared >= 0)
            {
                squared = Math.sqrt(squared);
                near = along - squared < near ? along - squared : near;
                far = along + squared > far ? along + squared : far;
            }
        }

        /** Narrows the part to what is between near and far; returns whether anything is left. */
        public function narrow():Boolean
        {
            if (near > from)
            {
                from = near;
            }
            if (far < to)
            {
                to = far;
            }
            return from <= to;
        }
    }
}
