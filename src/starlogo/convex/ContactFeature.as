package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /**
     * The part of a core that is farthest along a direction: a corner, an edge or a face.
     */
    internal final class ContactFeature
    {
        /** The count of the numbers of a corner, and of an edge. A face has more. */
        public static const CORNER:int = 3;
        public static const EDGE:int = 6;

        /** The corners: x, y, z of each. <code>end</code> is the count of these numbers. Read only. */
        public var points:Vector.<Number> = new Vector.<Number>();
        public var end:int = 0;

        /** How far the core extends along the direction. Read only. */
        public var farthest:Number = 0;

        // How much nearer corners may be that count as well.
        private var _slack:Number = 0;

        // The corners that find() has found.
        private var _found:Vector.<Number> = new Vector.<Number>();

        /** Leaves no corners. */
        public function clear():void
        {
            end = 0;
        }

        /** Finds the corners of a core that are farthest along a contact's normal, or against it if the side is -1. They are in any order. */
        public function find(shape:ConvexShape, side:int, contact:ContactPoint):void
        {
            var p:Vector.<Number> = shape.points;
            var x:Number = side * contact.normalX;
            var y:Number = side * contact.normalY;
            var z:Number = side * contact.normalZ;
            var most:Number = -Infinity;
            for (var i:int = 0; i < shape.end; i += 3)
            {
                var along:Number = x * p[i] + y * p[int(i + 1)] + z * p[int(i + 2)];
                most = along > most ? along : most;
            }
            farthest = most;
            _slack = Tolerances.DIRECTION * shape.extent;
            most -= _slack;
            end = 0;
            for (var k:int = 0; k < shape.end; k += 3)
            {
                if (x * p[k] + y * p[int(k + 1)] + z * p[int(k + 2)] >= most)
                {
                    add(p, k);
                }
            }
        }

        /** Moves all corners by a vector. */
        public function move(x:Number, y:Number, z:Number):void
        {
            for (var at:int = 0; at < end; at += 3)
            {
                points[at] += x;
                points[int(at + 1)] += y;
                points[int(at + 2)] += z;
            }
        }

        /**
         * Makes the corners an outline: counter-clockwise around a contact's normal, seen against it, and without those between others (gift
         * wrapping).
         */
        public function makeOutline(contact:ContactPoint):void
        {
            var found:Vector.<Number> = points;
            var foundEnd:int = end;
            points = _found;
            _found = found;
            end = 0;
            // the first is farthest from another one
            var first:int = farthestFrom(0, foundEnd);
            var last:int = farthestFrom(first, foundEnd);
            add(found, first);
            if (first == last)
            {
                return;
            }
            if (areOnLine(first, last, foundEnd))
            {
                add(found, last);
                return;
            }
            for (var at:int = nextOf(first, foundEnd, contact); at != first && end < foundEnd; at = nextOf(at, foundEnd, contact))
            {
                add(found, at);
            }
        }

        private function add(from:Vector.<Number>, at:int):void
        {
            points[end] = from[at];
            points[int(end + 1)] = from[int(at + 1)];
            points[int(end + 2)] = from[int(at + 2)];
            end += 3;
        }

        // Whether all corners are as near to the line through two of them as rounding.
        private function areOnLine(first:int, last:int, foundEnd:int):Boolean
        {
            var found:Vector.<Number> = _found;
            var x:Number = found[last] - found[first];
            var y:Number = found[int(last + 1)] - found[int(first + 1)];
            var z:Number = found[int(last + 2)] - found[int(first + 2)];
            var most:Number = _slack * _slack * (x * x + y * y + z * z);
            for (var i:int = 0; i < foundEnd; i += 3)
            {
                var ux:Number = found[i] - found[first];
                var uy:Number = found[int(i + 1)] - found[int(first + 1)];
                var uz:Number = found[int(i + 2)] - found[int(first + 2)];
                var crossX:Number = y * uz - z * uy;
                var crossY:Number = z * ux - x * uz;
                var crossZ:Number = x * uy - y * ux;
                if (crossX * crossX + crossY * crossY + crossZ * crossZ > most)
                {
                    return false;
                }
            }
            return true;
        }

        private function farthestFrom(corner:int, foundEnd:int):int
        {
            var found:Vector.<Number> = _found;
            var best:int = corner;
            var most:Number = 0;
            for (var i:int = 0; i < foundEnd; i += 3)
            {
                var x:Number = found[i] - found[corner];
                var y:Number = found[int(i + 1)] - found[int(corner + 1)];
                var z:Number = found[int(i + 2)] - found[int(corner + 2)];
                var squared:Number = x * x + y * y + z * z;
                if (squared > most)
                {
                    most = squared;
                    best = i;
                }
            }
            return best;
        }

        // Returns the corner after which all others are on the left.
        private function nextOf(at:int, foundEnd:int, contact:ContactPoint):int
        {
            var found:Vector.<Number> = _found;
            var best:int = at;
            var x:Number = 0;
            var y:Number = 0;
            var z:Number = 0;
            for (var i:int = 0; i < foundEnd; i += 3)
            {
                var ux:Number = found[i] - found[at];
                var uy:Number = found[int(i + 1)] - found[int(at + 1)];
                var uz:Number = found[int(i + 2)] - found[int(at + 2)];
                var left:Number = contact.normalX * (y * uz - z * uy) + contact.normalY * (z * ux - x * uz) + contact.normalZ * (x * uy - y * ux);
                var further:Number = ux * ux + uy * uy + uz * uz - (x * x + y * y + z * z);
                var rounding:Number = _slack * Math.sqrt(x * x + y * y + z * z);
                if (left < -rounding || left <= rounding && further > 0 && x * ux + y * uy + z * uz >= 0)
                {
                    x = ux;
                    y = uy;
                    z = uz;
                    best = i;
                }
            }
            return best;
        }
    }
}
