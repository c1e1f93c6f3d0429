package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /**
     * Finds the point of a contact whose normal and depth are known: the middle of what the two shapes have in common where they touch. That is
     * the common part of a corner, an edge or a face of each, seen along the normal. The middle of a polygon is the mean of its corners.
     */
    internal final class ContactPointFinder
    {
        // The feature of each core that faces the other, relative to the second one's origin.
        private var _first:ContactFeature = new ContactFeature();
        private var _second:ContactFeature = new ContactFeature();

        /** Writes the point halfway between the two surfaces, relative to the second shape's origin. */
        public function find(cores:CorePair, out:ContactPoint):void
        {
            _first.findFarthest(cores.first, -1, out);
            _first.move(cores.x, cores.y, cores.z);
            _second.findFarthest(cores.second, 1, out);
            // of two corners, that of the core with fewer points counts
            var isSecondSimpler:Boolean = _second.isCorner && cores.second.pointsEnd < cores.first.pointsEnd;
            if (!_first.isCorner && !_second.isCorner)
            {
                // corners in the same place become one
                _first.orderAsOutline(out);
                _second.orderAsOutline(out);
            }
            // how far the middle between the surfaces is from the common part, along the normal
            var offset:Number;
            if (_first.isCorner && !isSecondSimpler)
            {
                writeMean(_first, out);
                offset = out.depth / 2 - cores.first.radius;
            }
            else if (_second.isCorner)
            {
                writeMean(_second, out);
                offset = cores.second.radius - out.depth / 2;
            }
            else
            {
                writeShared(out);
                var surface:Number = out.normalX * cores.x + out.normalY * cores.y + out.normalZ * cores.z - _first.farthest - cores.first.radius;
                offset = surface + out.depth / 2 - (out.normalX * out.x + out.normalY * out.y + out.normalZ * out.z);
            }
            out.x += offset * out.normalX;
            out.y += offset * out.normalY;
            out.z += offset * out.normalZ;
        }

        // Writes the middle of what two edges or faces share when seen along the normal. It is in the plane of either.
        private function writeShared(out:ContactPoint):void
        {
            if (_second.isFace)
            {
                _first.clip(_second, out);
                writeMean(_first, out);
            }
            else if (_first.isFace)
            {
                _second.clip(_first, out);
                writeMean(_second, out);
            }
            else
            {
                writeCrossing(_first.points, _second.points, out);
            }
        }

        private static function writeMean(feature:ContactFeature, out:ContactPoint):void
        {
            var points:Vector.<Number> = feature.points;
            var length:int = feature.length;
            var x:Number = 0;
            var y:Number = 0;
            var z:Number = 0;
            for (var at:int = 0; at < length; at += 3)
            {
                x += points[at];
                y += points[int(at + 1)];
                z += points[int(at + 2)];
            }
            out.x = x * (3 / length);
            out.y = y * (3 / length);
            out.z = z * (3 / length);
        }

        // Writes where two segments cross, seen along the normal, or the point of the first one that is nearest to an end of the second. If they are
        // parallel, writes the middle of the part that they share. u is the first segment's vector, v the second's. Fractions of u go from 0 at the first
        // segment's start to 1 at its end.
        private static function writeCrossing(first:Vector.<Number>, second:Vector.<Number>, out:ContactPoint):void
        {
            var ux:Number = first[3] - first[0];
            var uy:Number = first[4] - first[1];
            var uz:Number = first[5] - first[2];
            var vx:Number = second[3] - second[0];
            var vy:Number = second[4] - second[1];
            var vz:Number = second[5] - second[2];
            var gapX:Number = second[0] - first[0];
            var gapY:Number = second[1] - first[1];
            var gapZ:Number = second[2] - first[2];
            var uu:Number = ux * ux + uy * uy + uz * uz;
            var crossX:Number = uy * vz - uz * vy;
            var crossY:Number = uz * vx - ux * vz;
            var crossZ:Number = ux * vy - uy * vx;
            var squared:Number = crossX * crossX + crossY * crossY + crossZ * crossZ;
            // where the part that they share begins and ends on the first segment
            var begin:Number;
            var end:Number;
            if (squared > Tolerances.DIRECTION * Tolerances.DIRECTION * uu * (vx * vx + vy * vy + vz * vz))
            {
                var fractionOfV:Number = ((gapY * uz - gapZ * uy) * crossX + (gapZ * ux - gapX * uz) * crossY + (gapX * uy - gapY * ux) * crossZ) / squared;
                fractionOfV = fractionOfV > 0 ? (fractionOfV < 1 ? fractionOfV : 1) : 0;
                begin = ((gapX + fractionOfV * vx) * ux + (gapY + fractionOfV * vy) * uy + (gapZ + fractionOfV * vz) * uz) / uu;
                end = begin;
            }
            else
            {
                begin = (gapX * ux + gapY * uy + gapZ * uz) / uu;
                end = begin + (vx * ux + vy * uy + vz * uz) / uu;
            }
            begin = begin > 0 ? (begin < 1 ? begin : 1) : 0;
            end = end > 0 ? (end < 1 ? end : 1) : 0;
            var fraction:Number = (begin + end) / 2;
            out.x = first[0] + fraction * ux;
            out.y = first[1] + fraction * uy;
            out.z = first[2] + fraction * uz;
        }
    }
}
