package starlogo.intersection.ray
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    /**
     * A part of a line. The kernels narrow it to the part inside of a shape.
     *
     * <p>A number stands for a place on the line: its distance along the direction from the point (x, y, z). The direction has length 1.
     * That point should be near the shapes that are asked about, because the rounding error grows with their distance from it. The part may
     * begin far from that point.</p>
     *
     * @private
     */
    public final class Ray
    {
        // The square of a direction's length must be neither infinite nor 0. So a direction that is longer than this, or shorter than 1 divided
        // by this, is scaled.
        private static const LARGE:Number = 1e120;

        /** A point of the line. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The line's direction, of length 1. */
        public var directionX:Number = 0;
        public var directionY:Number = 0;
        public var directionZ:Number = 0;

        /** Where the part begins: on a shape's surface, or at the ray's origin. */
        public var from:Number = 0;

        /** Where the part ends. */
        public var to:Number = Infinity;

        /**
         * The unit normal of the surface on which the part begins. If the part begins at the ray's origin, the opposite of the ray's
         * direction.
         */
        public var normalX:Number = 0;
        public var normalY:Number = 0;
        public var normalZ:Number = 0;

        /**
         * The number of the triangle on which the part begins, as the model counts them. It is -1 if no triangle decides, or if the part begins
         * at the ray's origin.
         */
        public var triangle:int = -1;

        /** Where the line enters a shape. Input of narrow. */
        public var near:Number = 0;

        /** Where the line leaves the shape. Input of narrow. */
        public var far:Number = 0;

        /** The axis across the slab that the line enters last. */
        public var entered:Vector3D = null;

        /** The factor on a shape's size at which the line still touches it. */
        public var touchingFactor:Number = Tolerances.TOUCHING;

        /** Where the line enters the shape without the tolerance of touching. Input of narrowExactly. */
        public var entry:Number = 0;

        /** Sets the line to another ray's line, or its own, transformed into a model's space. The part has to be set after that. */
        public function bringInto(placement:Placement, line:Ray):void
        {
            var toX:Number = line.x / placement.size;
            var toY:Number = line.y / placement.size;
            var toZ:Number = line.z / placement.size;
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

        /** Copies the line and the part of another ray, without the normal, the triangle and the factor of touching. */
        public function copyFrom(other:Ray):void
        {
            x = other.x;
            y = other.y;
            z = other.z;
            directionX = other.directionX;
            directionY = other.directionY;
            directionZ = other.directionZ;
            from = other.from;
            to = other.to;
        }

        /** Gives the line the opposite direction. The part stays, so it begins at its end. */
        public function turnRound():void
        {
            var end:Number = -from;
            from = -to;
            to = end;
            directionX = -directionX;
            directionY = -directionY;
            directionZ = -directionZ;
        }

        /** Whether the products of the line's numbers are finite. */
        public function get isFinite():Boolean
        {
            return x * x + y * y + z * z < Infinity;
        }

        /**
         * Sets the ray to begin at a point in a direction of any length.
         *
         * @throws ArgumentError if one of them is null, or if the direction is 0 or not finite
         */
        public function aim(origin:Vector3D, direction:Vector3D):void
        {
            if (origin == null || direction == null)
            {
                throw new ArgumentError("a ray needs an origin and a direction, not " + origin + " and " + direction);
            }
            var largest:Number = Math.max(Math.abs(direction.x), Math.abs(direction.y));
            largest = Math.max(largest, Math.abs(direction.z));
            if (!(largest > 0 && largest < Infinity))
            {
                throw new ArgumentError("a ray needs a direction, finite and not 0: " + direction);
            }
            var unit:Number = largest > LARGE || largest < 1 / LARGE ? largest : 1;
            var toX:Number = direction.x / unit;
            var toY:Number = direction.y / unit;
            var toZ:Number = direction.z / unit;
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

        /** Sets the normal to a unit vector, or to its opposite if the vector points along the ray. */
        public function setNormal(x:Number, y:Number, z:Number):void
        {
            var side:int = x * directionX + y * directionY + z * directionZ > 0 ? -1 : 1;
            normalX = side * x;
            normalY = side * y;
            normalZ = side * z;
        }

        /** Sets the normal to the opposite of the ray's direction, for a ray that begins inside of a shape. */
        public function faceBack():void
        {
            normalX = -directionX;
            normalY = -directionY;
            normalZ = -directionZ;
        }

        /**
         * Narrows near and far to the part inside of a slab, the space between two parallel planes, or touching it. If near
         * changes, <code>entered</code> becomes the axis. Where the line enters the slab itself limits <code>entry</code>.
         *
         * @param axis a unit vector across the slab
         * @param middle a point halfway between the planes
         * @param half the distance of each plane from the point
         */
        public function cutAlong(axis:Vector3D, middle:Vector3D, half:Number):void
        {
            var offset:Number = axis.x * (x - middle.x) + axis.y * (y - middle.y) + axis.z * (z - middle.z);
            var speed:Number = axis.x * directionX + axis.y * directionY + axis.z * directionZ;
            // a line within the planes crosses them at an infinite distance, if its speed is not -0
            speed = speed == 0 ? 0 : speed;
            var ahead:Number = speed < 0 ? -half : half;
            var exact:Number = (-ahead - offset) / speed;
            if (exact > entry && exact < Infinity)
            {
                entry = exact;
            }
            ahead *= touchingFactor;
            var place:Number = (ahead - offset) / speed;
            far = place < far ? place : far;
            place = (-ahead - offset) / speed;
            if (place > near)
            {
                near = place;
                entered = axis;
            }
        }

        /** Widens near and far to include the part in a ball. */
        public function addBall(middle:Vector3D, radius:Number):void
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

        /**
         * Widens near and far to include the part in the cylinder around a segment. Across the segment the cylinder is a circle. The line is inside
         * between the places where it enters and leaves that circle, as far as they are between the segment's ends.
         */
        public function addTube(start:Vector3D, end:Vector3D, radius:Number):void
        {
            var axisX:Number = end.x - start.x;
            var axisY:Number = end.y - start.y;
            var axisZ:Number = end.z - start.z;
            var squared:Number = axisX * axisX + axisY * axisY + axisZ * axisZ;
            if (!(squared > 0))
            {
                return;
            }
            var asideX:Number = x - start.x;
            var asideY:Number = y - start.y;
            var asideZ:Number = z - start.z;
            // As shares of the segment: the place of the line's point, and how far the line goes along the segment in a length of 1.
            var share:Number = (asideX * axisX + asideY * axisY + asideZ * axisZ) / squared;
            var speed:Number = (directionX * axisX + directionY * axisY + directionZ * axisZ) / squared;
            var acrossX:Number = directionX - speed * axisX;
            var acrossY:Number = directionY - speed * axisY;
            var acrossZ:Number = directionZ - speed * axisZ;
            var turn:Number = acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ;
            if (!(turn > Tolerances.PARALLEL) || speed == 0 && (share < 0 || share > 1))
            {
                return;
            }
            asideX -= share * axisX;
            asideY -= share * axisY;
            asideZ -= share * axisZ;
            var closest:Number = -(asideX * acrossX + asideY * acrossY + asideZ * acrossZ) / turn;
            asideX += closest * acrossX;
            asideY += closest * acrossY;
            asideZ += closest * acrossZ;
            var inside:Number = radius * radius - (asideX * asideX + asideY * asideY + asideZ * asideZ);
            if (!(inside >= 0))
            {
                return;
            }
            inside = Math.sqrt(inside / turn);
            var into:Number = closest - inside;
            var out:Number = closest + inside;
            if (speed != 0)
            {
                var first:Number = speed > 0 ? -share : 1 - share;
                var last:Number = speed > 0 ? 1 - share : -share;
                first /= speed;
                last /= speed;
                into = first > into ? first : into;
                out = last < out ? last : out;
            }
            if (into <= out)
            {
                near = into < near ? into : near;
                far = out > far ? out : far;
            }
        }

        /** Narrows the ray's part to the part between near and far. Returns whether anything is left. */
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

        /**
         * Narrows the ray's part to the part between near and far. If it begins at near, it begins at <code>entry</code> instead, which is the place
         * on the surface itself. A line that only touches has no such place.
         */
        public function narrowExactly():Boolean
        {
            var isEntering:Boolean = near > from;
            var isMet:Boolean = narrow();
            if (isMet && isEntering && entry > near && entry <= to)
            {
                from = entry;
            }
            return isMet;
        }
    }
}
