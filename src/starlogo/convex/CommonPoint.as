package starlogo.convex
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Tolerances;

    /**
     * Finds the point of a contact whose normal and depth are known: the middle of what the two shapes have in common where they touch. That is
     * the common part of a corner, an edge or a face of each, seen along the normal.
     */
    internal final class CommonPoint
    {
        // The feature of each core that faces the other, relative to b's origin.
        private var _a:ContactFeature = new ContactFeature();
        private var _b:ContactFeature = new ContactFeature();

        // The corners of a feature in the order of the core's points, and a corner.
        private var _found:Vector.<Number> = new Vector.<Number>();
        private var _corner:Vector3D = new Vector3D();

        // How far the last core reaches along the normal, and how much nearer other corners of it may be that count as well.
        private var _farthest:Number = 0;
        private var _slack:Number = 0;

        /** Writes the point halfway between the two surfaces, relative to b's origin. */
        public function find(cores:CorePair, out:ContactPoint):void
        {
            // If a core is a point, it is the common part.
            var isPointB:Boolean = cores.a.end > 3 && cores.b.end == 3;
            if (cores.a.end > 3 && !isPointB)
            {
                wrap(findCorners(cores.b, 1, out), out, _b);
            }
            wrap(findCorners(cores.a, -1, out), out, _a);
            _corner.x = cores.x;
            _corner.y = cores.y;
            _corner.z = cores.z;
            _a.move(_corner);
            if (isPointB)
            {
                out.x = cores.b.points[0];
                out.y = cores.b.points[1];
                out.z = cores.b.points[2];
            }
            else
            {
                _a.findCommonPoint(_b, out);
            }
            var surface:Number = out.normalX * cores.x + out.normalY * cores.y + out.normalZ * cores.z - _farthest - cores.a.radius;
            var by:Number = surface + out.depth / 2 - (out.normalX * out.x + out.normalY * out.y + out.normalZ * out.z);
            out.x += by * out.normalX;
            out.y += by * out.normalY;
            out.z += by * out.normalZ;
        }

        // Finds a core's corners that are farthest along the normal, or against it. Returns how many numbers they are.
        private function findCorners(shape:ConvexShape, side:int, contact:ContactPoint):int
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
            _farthest = most;
            _slack = Tolerances.DIRECTION * shape.size;
            most -= _slack;
            var end:int = 0;
            for (var k:int = 0; k < shape.end; k += 3)
            {
                if (x * p[k] + y * p[int(k + 1)] + z * p[int(k + 2)] >= most)
                {
                    _found[end] = p[k];
                    _found[int(end + 1)] = p[int(k + 1)];
                    _found[int(end + 2)] = p[int(k + 2)];
                    end += 3;
                }
            }
            return end;
        }

        // Writes the found corners in order around the normal (gift wrapping).
        private function wrap(end:int, contact:ContactPoint, out:ContactFeature):void
        {
            out.clear();
            // the first is farthest from another one
            var first:int = farthestFrom(0, end);
            var last:int = farthestFrom(first, end);
            addCorner(first, out);
            if (first == last)
            {
                return;
            }
            if (areOnLine(first, last, end))
            {
                addCorner(last, out);
                return;
            }
            var count:int = 3;
            for (var at:int = nextOf(first, end, contact); at != first && count < end; at = nextOf(at, end, contact))
            {
                addCorner(at, out);
                count += 3;
            }
        }

        private function addCorner(at:int, out:ContactFeature):void
        {
            _corner.x = _found[at];
            _corner.y = _found[int(at + 1)];
            _corner.z = _found[int(at + 2)];
            out.add(_corner);
        }

        // Whether all found corners are as near to the line through two of them as rounding.
        private function areOnLine(first:int, last:int, end:int):Boolean
        {
            var found:Vector.<Number> = _found;
            var x:Number = found[last] - found[first];
            var y:Number = found[int(last + 1)] - found[int(first + 1)];
            var z:Number = found[int(last + 2)] - found[int(first + 2)];
            var most:Number = _slack * _slack * (x * x + y * y + z * z);
            for (var i:int = 0; i < end; i += 3)
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

        private function farthestFrom(corner:int, end:int):int
        {
            var found:Vector.<Number> = _found;
            var best:int = corner;
            var most:Number = 0;
            for (var i:int = 0; i < end; i += 3)
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
        private function nextOf(at:int, end:int, contact:ContactPoint):int
        {
            var found:Vector.<Number> = _found;
            var best:int = at;
            var x:Number = 0;
            var y:Number = 0;
            var z:Number = 0;
            for (var i:int = 0; i < end; i += 3)
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
