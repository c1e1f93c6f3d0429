package starlogo.convex
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Tolerances;

    /** The part of a core that is farthest along a direction: a corner, an edge or a face. An edge or a face can be clipped to a face. */
    internal final class ContactFeature
    {
        // How many numbers an edge has: three for each of its corners. A face has more.
        private static const EDGE:int = 6;

        /** The corners: x, y, z of each. <code>length</code> is the count of these numbers. Read only. */
        public var points:Vector.<Number> = new Vector.<Number>();
        public var length:int = 0;

        /** How far the core extends along the direction. Read only. */
        public var farthest:Number = 0;

        // The rounding error of the corners that findFarthest() has found: how far from the farthest, from a line or from each other they still count.
        private var _cornerTolerance:Number = 0;

        // A second list: startOver() exchanges the two.
        private var _spare:Vector.<Number> = new Vector.<Number>();

        // The inner side of an edge of a face: a direction, and in w the least projection on it.
        private var _innerSide:Vector3D = new Vector3D();

        /** Whether the feature is a corner. */
        public function get isCorner():Boolean
        {
            return length == 3;
        }

        /** Whether the feature is a face. */
        public function get isFace():Boolean
        {
            return length > EDGE;
        }

        /** Finds the corners of a core that are farthest along a contact's normal, or against it if the sign is -1. They are in any order. */
        public function findFarthest(shape:ConvexShape, sign:int, contact:ContactPoint):void
        {
            var p:Vector.<Number> = shape.points;
            var x:Number = sign * contact.normalX;
            var y:Number = sign * contact.normalY;
            var z:Number = sign * contact.normalZ;
            var most:Number = -Infinity;
            for (var i:int = 0; i < shape.pointsEnd; i += 3)
            {
                var projection:Number = x * p[i] + y * p[int(i + 1)] + z * p[int(i + 2)];
                most = projection > most ? projection : most;
            }
            farthest = most;
            _cornerTolerance = Tolerances.DIRECTION * shape.boundingRadius;
            most -= _cornerTolerance;
            length = 0;
            for (var k:int = 0; k < shape.pointsEnd; k += 3)
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
            for (var at:int = 0; at < length; at += 3)
            {
                points[at] += x;
                points[int(at + 1)] += y;
                points[int(at + 2)] += z;
            }
        }

        /**
         * Makes the corners an outline: counter-clockwise around a contact's normal, seen against it, and without those between others (gift
         * wrapping). Of corners in the same place, such as those of both sides of a thin box, one is left.
         */
        public function orderAsOutline(contact:ContactPoint):void
        {
            var foundEnd:int = length;
            var found:Vector.<Number> = startOver();
            // the first is farthest from another one
            var first:int = farthestFrom(0, found, foundEnd);
            var last:int = farthestFrom(first, found, foundEnd);
            add(found, first);
            if (first == last)
            {
                return;
            }
            if (areOnLine(first, last, found, foundEnd))
            {
                add(found, last);
                return;
            }
            var at:int = nextOf(first, found, foundEnd, contact);
            while (length < foundEnd && !areInOnePlace(at, first, found))
            {
                add(found, at);
                at = nextOf(at, found, foundEnd, contact);
            }
        }

        /**
         * Keeps the part of an edge or a face that is within another face (Sutherland and Hodgman, "Reentrant polygon clipping", 1974). What two
         * shapes share where they touch may be as narrow as rounding, so if all is outside of an edge of the face, what is nearest to that edge is left.
         *
         * @param face in the same plane or in a parallel one. Both are outlines
         * @param contact has the normal of the planes
         */
        public function clip(face:ContactFeature, contact:ContactPoint):void
        {
            var hasCommonPart:Boolean = true;
            var last:int = face.length - 3;
            for (var at:int = 0; at < face.length; at += 3)
            {
                var isPartInside:Boolean = findInnerSide(face, last, at, contact, _innerSide);
                if (isPartInside)
                {
                    keepInside(_innerSide);
                }
                hasCommonPart = hasCommonPart && isPartInside;
                last = at;
            }
            if (hasCommonPart)
            {
                return;
            }
            // what is nearest to an edge may be beside the face, so these edges come last
            for (at = 0; at < face.length; at += 3)
            {
                findInnerSide(face, last, at, contact, _innerSide);
                keepInside(_innerSide);
                last = at;
            }
        }

        // Begins without corners. Returns the list of those before, which stays as it is until the next call.
        private function startOver():Vector.<Number>
        {
            var before:Vector.<Number> = points;
            points = _spare;
            _spare = before;
            length = 0;
            return before;
        }

        private function add(from:Vector.<Number>, at:int):void
        {
            points[length] = from[at];
            points[int(length + 1)] = from[int(at + 1)];
            points[int(length + 2)] = from[int(at + 2)];
            length += 3;
        }

        // Whether all corners are as near to the line through two of them as rounding.
        private function areOnLine(first:int, last:int, found:Vector.<Number>, foundEnd:int):Boolean
        {
            var x:Number = found[last] - found[first];
            var y:Number = found[int(last + 1)] - found[int(first + 1)];
            var z:Number = found[int(last + 2)] - found[int(first + 2)];
            var most:Number = _cornerTolerance * _cornerTolerance * (x * x + y * y + z * z);
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

        // Whether two corners are as near to each other as rounding.
        private function areInOnePlace(corner:int, other:int, found:Vector.<Number>):Boolean
        {
            var x:Number = found[corner] - found[other];
            var y:Number = found[int(corner + 1)] - found[int(other + 1)];
            var z:Number = found[int(corner + 2)] - found[int(other + 2)];
            return x * x + y * y + z * z <= 4 * _cornerTolerance * _cornerTolerance;
        }

        /** The point of a list that is farthest from one of them, which is the result if all are in one place. Points are given by their first numbers. */
        public static function farthestFrom(corner:int, found:Vector.<Number>, foundEnd:int):int
        {
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
        private function nextOf(at:int, found:Vector.<Number>, foundEnd:int, contact:ContactPoint):int
        {
            var best:int = at;
            var x:Number = 0;
            var y:Number = 0;
            var z:Number = 0;
            for (var i:int = 0; i < foundEnd; i += 3)
            {
                if (areInOnePlace(i, at, found))
                {
                    continue;
                }
                var ux:Number = found[i] - found[at];
                var uy:Number = found[int(i + 1)] - found[int(at + 1)];
                var uz:Number = found[int(i + 2)] - found[int(at + 2)];
                var left:Number = contact.normalX * (y * uz - z * uy) + contact.normalY * (z * ux - x * uz) + contact.normalZ * (x * uy - y * ux);
                var further:Number = ux * ux + uy * uy + uz * uz - (x * x + y * y + z * z);
                var rounding:Number = _cornerTolerance * Math.sqrt(x * x + y * y + z * z);
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

        // Finds the inner side of an edge of a face. Returns whether a part of this feature is there. If not, the side is widened to what is nearest to the edge.
        private function findInnerSide(face:ContactFeature, from:int, to:int, contact:ContactPoint, out:Vector3D):Boolean
        {
            var corners:Vector.<Number> = face.points;
            var edgeX:Number = corners[to] - corners[from];
            var edgeY:Number = corners[int(to + 1)] - corners[int(from + 1)];
            var edgeZ:Number = corners[int(to + 2)] - corners[int(from + 2)];
            // to the left of the edge, which is inwards
            var inX:Number = contact.normalY * edgeZ - contact.normalZ * edgeY;
            var inY:Number = contact.normalZ * edgeX - contact.normalX * edgeZ;
            var inZ:Number = contact.normalX * edgeY - contact.normalY * edgeX;
            var border:Number = inX * corners[to] + inY * corners[int(to + 1)] + inZ * corners[int(to + 2)];
            var innermost:Number = -Infinity;
            for (var i:int = 0; i < length; i += 3)
            {
                var projection:Number = inX * points[i] + inY * points[int(i + 1)] + inZ * points[int(i + 2)];
                innermost = projection > innermost ? projection : innermost;
            }
            // rounding is relative to the face's extent, which two of its edges tell
            var rounding:Number = Tolerances.ROUNDING * (Math.abs(corners[3] - corners[0]) + Math.abs(corners[4] - corners[1]) + Math.abs(corners[5] - corners[2])
                    + Math.abs(corners[6] - corners[3]) + Math.abs(corners[7] - corners[4]) + Math.abs(corners[8] - corners[5]))
                * Math.sqrt(inX * inX + inY * inY + inZ * inZ);
            var isPartInside:Boolean = innermost >= border - rounding;
            border = isPartInside ? border : innermost;
            out.x = inX;
            out.y = inY;
            out.z = inZ;
            out.w = border - rounding;
            return isPartInside;
        }

        // Keeps the part on the inner side of an edge.
        private function keepInside(side:Vector3D):void
        {
            // an edge is not a closed outline
            var isEdge:Boolean = length == EDGE;
            var end:int = length;
            var before:Vector.<Number> = startOver();
            var last:int = end - 3;
            var lastInwards:Number = side.x * before[last] + side.y * before[int(last + 1)] + side.z * before[int(last + 2)] - side.w;
            for (var at:int = 0; at < end; at += 3)
            {
                var inwards:Number = side.x * before[at] + side.y * before[int(at + 1)] + side.z * before[int(at + 2)] - side.w;
                if (inwards >= 0 != lastInwards >= 0 && !(isEdge && at == 0))
                {
                    var fraction:Number = lastInwards / (lastInwards - inwards);
                    points[length] = before[last] + fraction * (before[at] - before[last]);
                    points[int(length + 1)] = before[int(last + 1)] + fraction * (before[int(at + 1)] - before[int(last + 1)]);
                    points[int(length + 2)] = before[int(last + 2)] + fraction * (before[int(at + 2)] - before[int(last + 2)]);
                    length += 3;
                }
                if (inwards >= 0)
                {
                    add(before, at);
                }
                last = at;
                lastInwards = inwards;
            }
        }
    }
}
