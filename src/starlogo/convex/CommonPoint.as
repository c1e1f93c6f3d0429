package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /**
     * Finds the point of a contact whose normal and depth are known: the middle of what the two shapes have in common where they touch. That is
     * the common part of a corner, an edge or a face of each, seen along the normal. The middle of a polygon is the mean of its corners.
     */
    internal final class CommonPoint
    {
        // The feature of each core that faces the other, relative to the second one's origin.
        private var _a:ContactFeature = new ContactFeature();
        private var _b:ContactFeature = new ContactFeature();

        private var _clip:PolygonClip = new PolygonClip();

        /** Writes the point halfway between the two surfaces, relative to the second shape's origin. */
        public function find(cores:CorePair, out:ContactPoint):void
        {
            findFeatures(cores, out);
            // how far the place halfway between the surfaces is from the common part, along the normal
            var by:Number;
            if (_a.end == 3)
            {
                writeMean(_a.points, 3, out);
                by = out.depth / 2 - cores.first.radius;
            }
            else if (_b.end == 3)
            {
                writeMean(_b.points, 3, out);
                by = cores.second.radius - out.depth / 2;
            }
            else
            {
                findShared(out);
                var surface:Number = out.normalX * cores.x + out.normalY * cores.y + out.normalZ * cores.z - _a.farthest - cores.first.radius;
                by = surface + out.depth / 2 - (out.normalX * out.x + out.normalY * out.y + out.normalZ * out.z);
            }
            out.x += by * out.normalX;
            out.y += by * out.normalY;
            out.z += by * out.normalZ;
        }

        // Finds both features, first that of the core with fewer points. If it is a corner, it is the common part, and the other feature is left
        // empty.
        private function findFeatures(cores:CorePair, contact:ContactPoint):void
        {
            _a.clear();
            _b.clear();
            if (cores.second.end < cores.first.end)
            {
                _b.find(cores.second, 1, contact);
            }
            if (_b.end != 3)
            {
                _a.find(cores.first, -1, contact);
                _a.move(cores.x, cores.y, cores.z);
            }
            if (_a.end > 3 && _b.end == 0)
            {
                _b.find(cores.second, 1, contact);
            }
            if (_a.end > 3 && _b.end > 3)
            {
                _a.order(contact);
                _b.order(contact);
            }
        }

        // Writes the middle of what two edges or faces share when seen along the normal. It is in the plane of either.
        private function findShared(out:ContactPoint):void
        {
            if (_b.end > 6)
            {
                writeMeanWithin(_a, _b, out);
            }
            else if (_a.end > 6)
            {
                writeMeanWithin(_b, _a, out);
            }
            else
            {
                writeCrossing(_a.points, _b.points, out);
            }
        }

        // Writes the mean of the corners that are left of a segment or polygon after clipping it to a polygon. If none is left, it is the mean of the
        // polygon's corners.
        private function writeMeanWithin(inner:ContactFeature, outer:ContactFeature, out:ContactPoint):void
        {
            _clip.clip(inner, outer, out);
            if (_clip.end > 0)
            {
                writeMean(_clip.points, _clip.end, out);
            }
            else
            {
                writeMean(outer.points, outer.end, out);
            }
        }

        private static function writeMean(points:Vector.<Number>, end:int, out:ContactPoint):void
        {
            var x:Number = 0;
            var y:Number = 0;
            var z:Number = 0;
            for (var at:int = 0; at < end; at += 3)
            {
                x += points[at];
                y += points[int(at + 1)];
                z += points[int(at + 2)];
            }
            out.x = x * (3 / end);
            out.y = y * (3 / end);
            out.z = z * (3 / end);
        }

        // Writes where two segments cross, seen along the normal, or the point of the first one that is nearest to the other's end. If they are
        // parallel, writes the middle of the part that they share.
        private static function writeCrossing(a:Vector.<Number>, b:Vector.<Number>, out:ContactPoint):void
        {
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
            var crossX:Number = uy * vz - uz * vy;
            var crossY:Number = uz * vx - ux * vz;
            var crossZ:Number = ux * vy - uy * vx;
            var squared:Number = crossX * crossX + crossY * crossY + crossZ * crossZ;
            var one:Number;
            var other:Number;
            if (squared > Tolerances.DIRECTION * Tolerances.DIRECTION * uu * (vx * vx + vy * vy + vz * vz))
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
            out.x = a[0] + share * ux;
            out.y = a[1] + share * uy;
            out.z = a[2] + share * uz;
        }
    }
}
