package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /**
     * Finds the point of a contact whose normal and depth are known: the middle of what the two shapes have in common where they touch. That is
     * the common part of a corner, an edge or a face of each, seen along the normal.
     */
    internal final class CommonPoint
    {
        // The corners of the part of each core that faces the other: a convex polygon in order, relative to b's origin.
        private var _a:Vector.<Number> = new Vector.<Number>();
        private var _b:Vector.<Number> = new Vector.<Number>();
        private var _endA:int = 0;
        private var _endB:int = 0;

        // The corners in the order of the core's points, and a clipped polygon.
        private var _found:Vector.<Number> = new Vector.<Number>();
        private var _clipped:Vector.<Number> = new Vector.<Number>();

        // How far the last core reaches along the normal, and how much nearer other corners of it may be that count as well.
        private var _reach:Number = 0;
        private var _slack:Number = 0;

        /** Writes the point halfway between the two surfaces, relative to b's origin. */
        public function find(cores:CorePair, out:ContactPoint):void
        {
            if (cores.a.end > 3)
            {
                _endB = wrap(findCorners(cores.b, 1, out), out, _b);
            }
            var end:int = findCorners(cores.a, -1, out);
            for (var i:int = 0; i < end; i += 3)
            {
                _found[i] += cores.x;
                _found[int(i + 1)] += cores.y;
                _found[int(i + 2)] += cores.z;
            }
            _endA = wrap(end, out, _a);
            if (_endA > 3)
            {
                _slack = Tolerances.DIRECTION * Math.min(cores.a.size, cores.b.size);
                intersect(out);
            }
            writeMiddle(out);
            var surface:Number = out.normalX * cores.x + out.normalY * cores.y + out.normalZ * cores.z - _reach - cores.a.radius;
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
            _reach = most;
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

        // Writes the found corners in order around the normal (gift wrapping). Returns how many numbers they are.
        private function wrap(end:int, contact:ContactPoint, out:Vector.<Number>):int
        {
            // the first is farthest from another one
            var first:int = farthestFrom(0, end);
            var last:int = farthestFrom(first, end);
            writeCorner(first, out, 0);
            if (first == last)
            {
                return 3;
            }
            if (areOnLine(first, last, end))
            {
                writeCorner(last, out, 3);
                return 6;
            }
            var count:int = 3;
            for (var at:int = nextOf(first, end, contact); at != first && count < end; at = nextOf(at, end, contact))
            {
                writeCorner(at, out, count);
                count += 3;
            }
            return count;
        }

        private function writeCorner(corner:int, out:Vector.<Number>, at:int):void
        {
            out[at] = _found[corner];
            out[int(at + 1)] = _found[int(corner + 1)];
            out[int(at + 2)] = _found[int(corner + 2)];
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

        // Reduces a's polygon to what it has in common with b's.
        private function intersect(contact:ContactPoint):void
        {
            if (_endB == 6 && _endA > 6 || _endB == 3)
            {
                swap();
            }
            if (_endA > 3 && _endB > 6)
            {
                clip(contact);
            }
            else if (_endA > 3)
            {
                cross();
            }
        }

        private function swap():void
        {
            var polygon:Vector.<Number> = _a;
            var end:int = _endA;
            _a = _b;
            _endA = _endB;
            _b = polygon;
            _endB = end;
        }

        // Clips a's polygon to b's (Sutherland and Hodgman, 1974). If nothing is left, takes b's.
        private function clip(contact:ContactPoint):void
        {
            var last:int = _endB - 3;
            for (var at:int = 0; at < _endB && _endA > 0; at += 3)
            {
                cut(last, at, contact);
                last = at;
            }
            if (_endA == 0)
            {
                swap();
            }
        }

        // Keeps the part of a's polygon that is on the inner side of an edge of b's.
        private function cut(edge:int, to:int, contact:ContactPoint):void
        {
            var points:Vector.<Number> = _a;
            var kept:Vector.<Number> = _clipped;
            var b:Vector.<Number> = _b;
            var edgeX:Number = b[to] - b[edge];
            var edgeY:Number = b[int(to + 1)] - b[int(edge + 1)];
            var edgeZ:Number = b[int(to + 2)] - b[int(edge + 2)];
            var inX:Number = contact.normalY * edgeZ - contact.normalZ * edgeY;
            var inY:Number = contact.normalZ * edgeX - contact.normalX * edgeZ;
            var inZ:Number = contact.normalX * edgeY - contact.normalY * edgeX;
            var from:Number = inX * b[edge] + inY * b[int(edge + 1)] + inZ * b[int(edge + 2)] - _slack * Math.sqrt(inX * inX + inY * inY + inZ * inZ);
            var isSegment:Boolean = _endA == 6;
            var count:int = 0;
            var last:int = _endA - 3;
            var lastBeyond:Number = inX * points[last] + inY * points[int(last + 1)] + inZ * points[int(last + 2)] - from;
            for (var at:int = 0; at < _endA; at += 3)
            {
                var beyond:Number = inX * points[at] + inY * points[int(at + 1)] + inZ * points[int(at + 2)] - from;
                if (beyond > 0 != lastBeyond > 0 && !(isSegment && at == 0))
                {
                    var share:Number = lastBeyond / (lastBeyond - beyond);
                    for (var c:int = 0; c < 3; c++)
                    {
                        kept[int(count + c)] = points[int(last + c)] + share * (points[int(at + c)] - points[int(last + c)]);
                    }
                    count += 3;
                }
                if (beyond > 0)
                {
                    for (var k:int = 0; k < 3; k++)
                    {
                        kept[int(count + k)] = points[int(at + k)];
                    }
                    count += 3;
                }
                last = at;
                lastBeyond = beyond;
            }
            _a = kept;
            _clipped = points;
            _endA = count;
        }

        // Reduces a's segment to the place where it crosses b's, seen along the normal, or comes nearest to it. If they are parallel, to the middle of what
        // they share.
        private function cross():void
        {
            var a:Vector.<Number> = _a;
            var b:Vector.<Number> = _b;
            var ux:Number = a[3] - a[0];
            var uy:Number = a[4] - a[1];
            var uz:Number = a[5] - a[2];
            var vx:Number = b[3] - b[0];
            var vy:Number = b[4] - b[1];
            var vz:Number = b[5] - b[2];
            var gapX:Number = b[0] - a[0];
            var gapY:Number = b[1] - a[1];
            var gapZ:Number = b[2] - a[2];
            var uu:Number = ux * ux + uy * uy + uz * uz;
            var vv:Number = vx * vx + vy * vy + vz * vz;
            var crossX:Number = uy * vz - uz * vy;
            var crossY:Number = uz * vx - ux * vz;
            var crossZ:Number = ux * vy - uy * vx;
            var squared:Number = crossX * crossX + crossY * crossY + crossZ * crossZ;
            var one:Number;
            var other:Number;
            if (squared > Tolerances.DIRECTION * Tolerances.DIRECTION * uu * vv)
            {
                var onB:Number = ((gapY * uz - gapZ * uy) * crossX + (gapZ * ux - gapX * uz) * crossY + (gapX * uy - gapY * ux) * crossZ) / squared;
                onB = onB > 0 ? (onB < 1 ? onB : 1) : 0;
                one = ((gapX + onB * vx) * ux + (gapY + onB * vy) * uy + (gapZ + onB * vz) * uz) / uu;
                other = one;
            }
            else
            {
                one = (gapX * ux + gapY * uy + gapZ * uz) / uu;
                other = one + (vx * ux + vy * uy + vz * uz) / uu;
            }
            one = one > 0 ? (one < 1 ? one : 1) : 0;
            other = other > 0 ? (other < 1 ? other : 1) : 0;
            var share:Number = (one + other) / 2;
            a[0] += share * ux;
            a[1] += share * uy;
            a[2] += share * uz;
            _endA = 3;
        }

        // Writes the middle of the corners of a's polygon.
        private function writeMiddle(out:ContactPoint):void
        {
            var count:Number = _endA / 3;
            out.x = out.y = out.z = 0;
            for (var i:int = 0; i < _endA; i += 3)
            {
                out.x += _a[i] / count;
                out.y += _a[int(i + 1)] / count;
                out.z += _a[int(i + 2)] / count;
            }
        }
    }
}
