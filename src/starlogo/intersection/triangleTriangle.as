package starlogo.intersection
{
    import starlogo.geometry.Tolerances;

    /**
     * Whether two triangles meet: they overlap, touch, or have a gap of no more than closest.reach.
     *
     * <p>Most triangles are on one side of the other's plane. Of those that cross each other's planes, the pieces that they cut out of the line
     * in both planes decide (Möller, "A fast triangle-triangle intersection test", Journal of Graphics Tools, 1997): where the pieces clearly
     * overlap the triangles meet. Where the pieces do not overlap, an axis at right angles to the two edges that face each other
     * separates the triangles. The closest points decide the rest: triangles that just touch or are nearly in one plane, and needles.</p>
     *
     * <p>Symmetric up to rounding; allocates nothing.</p>
     *
     * @param a has nine numbers of a triangle: x, y, z of each corner
     * @param atA where in a they begin
     * @param b has nine numbers of the other, in the same space
     * @param atB where in b they begin
     * @param closest finds the closest points. Its reach, the gap that still counts as touching, must be above the rounding errors:
     *     Tolerances.SURFACES of the coordinates' size is
     *
     * @private
     */
    public function triangleTriangle(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int, closest:ClosestTriangles):Boolean
    {
        // all relative to a's first corner
        var x:Number = a[atA];
        var y:Number = a[int(atA + 1)];
        var z:Number = a[int(atA + 2)];
        var ux:Number = a[int(atA + 3)] - x;
        var uy:Number = a[int(atA + 4)] - y;
        var uz:Number = a[int(atA + 5)] - z;
        var vx:Number = a[int(atA + 6)] - x;
        var vy:Number = a[int(atA + 7)] - y;
        var vz:Number = a[int(atA + 8)] - z;
        var px:Number = b[atB] - x;
        var py:Number = b[int(atB + 1)] - y;
        var pz:Number = b[int(atB + 2)] - z;
        var qx:Number = b[int(atB + 3)] - x;
        var qy:Number = b[int(atB + 4)] - y;
        var qz:Number = b[int(atB + 5)] - z;
        var rx:Number = b[int(atB + 6)] - x;
        var ry:Number = b[int(atB + 7)] - y;
        var rz:Number = b[int(atB + 8)] - z;
        var limit:Number = closest.reach * closest.reach;

        // b on one side of a's plane
        var nx:Number = uy * vz - uz * vy;
        var ny:Number = uz * vx - ux * vz;
        var nz:Number = ux * vy - uy * vx;
        var areaA:Number = nx * nx + ny * ny + nz * nz;
        var atP:Number = nx * px + ny * py + nz * pz;
        var atQ:Number = nx * qx + ny * qy + nz * qz;
        var atR:Number = nx * rx + ny * ry + nz * rz;
        var near:Number;
        var own:Number;
        if ((atP > 0 && atQ > 0 && atR > 0) || (atP < 0 && atQ < 0 && atR < 0))
        {
            near = atP < 0 ? -atP : atP;
            own = atQ < 0 ? -atQ : atQ;
            near = near < own ? near : own;
            own = atR < 0 ? -atR : atR;
            near = near < own ? near : own;
            // a needle's own corners need not be on the plane that was computed
            own = nx * ux + ny * uy + nz * uz;
            own = own < 0 ? -own : own;
            near -= own;
            own = nx * vx + ny * vy + nz * vz;
            own = own < 0 ? -own : own;
            near -= own;
            if (near > 0 && near * near > limit * areaA)
            {
                return false;
            }
        }

        // a on one side of b's plane
        var fx:Number = qx - px;
        var fy:Number = qy - py;
        var fz:Number = qz - pz;
        var gx:Number = rx - px;
        var gy:Number = ry - py;
        var gz:Number = rz - pz;
        var mx:Number = fy * gz - fz * gy;
        var my:Number = fz * gx - fx * gz;
        var mz:Number = fx * gy - fy * gx;
        var areaB:Number = mx * mx + my * my + mz * mz;
        var at0:Number = -mx * px - my * py - mz * pz;
        var atU:Number = at0 + mx * ux + my * uy + mz * uz;
        var atV:Number = at0 + mx * vx + my * vy + mz * vz;
        if ((at0 > 0 && atU > 0 && atV > 0) || (at0 < 0 && atU < 0 && atV < 0))
        {
            near = at0 < 0 ? -at0 : at0;
            own = atU < 0 ? -atU : atU;
            near = near < own ? near : own;
            own = atV < 0 ? -atV : atV;
            near = near < own ? near : own;
            own = mx * fx + my * fy + mz * fz;
            own = own < 0 ? -own : own;
            near -= own;
            own = mx * gx + my * gy + mz * gz;
            own = own < 0 ? -own : own;
            near -= own;
            if (near > 0 && near * near > limit * areaB)
            {
                return false;
            }
        }

        // Only where no rounding matters: neither a needle, and each corner well off the other's plane.
        var lone:Number = at0 * atU;
        var lone2:Number = at0 * atV;
        var loneB:Number = atP * atQ;
        var loneB2:Number = atP * atR;
        var enoughA:Number = Tolerances.CLEARLY_OFF_PLANE * limit * areaA;
        var enoughB:Number = Tolerances.CLEARLY_OFF_PLANE * limit * areaB;
        if ((lone < 0 || lone2 < 0) && (loneB < 0 || loneB2 < 0)
                && at0 * at0 > enoughB && atU * atU > enoughB && atV * atV > enoughB
                && atP * atP > enoughA && atQ * atQ > enoughA && atR * atR > enoughA
                && Tolerances.SLIMMEST_TRIANGLE * areaA > (ux * ux + uy * uy + uz * uz) * (vx * vx + vy * vy + vz * vz)
                && Tolerances.SLIMMEST_TRIANGLE * areaB > (fx * fx + fy * fy + fz * fz) * (gx * gx + gy * gy + gz * gz))
        {
            // along the line in both planes; each triangle has a corner alone on its side of it
            var dx:Number = ny * mz - nz * my;
            var dy:Number = nz * mx - nx * mz;
            var dz:Number = nx * my - ny * mx;
            var onU:Number = dx * ux + dy * uy + dz * uz;
            var onV:Number = dx * vx + dy * vy + dz * vz;
            var onP:Number = dx * px + dy * py + dz * pz;
            var onQ:Number = dx * qx + dy * qy + dz * qz;
            var onR:Number = dx * rx + dy * ry + dz * rz;
            var isThirdA:Boolean = lone > 0;
            var isSecondA:Boolean = lone2 > 0;
            var beginA:Number;
            var endA:Number;
            if (isThirdA)
            {
                beginA = onV - onV * atV / (atV - at0);
                endA = onV + (onU - onV) * atV / (atV - atU);
            }
            else if (isSecondA)
            {
                beginA = onU - onU * atU / (atU - at0);
                endA = onU + (onV - onU) * atU / (atU - atV);
            }
            else
            {
                beginA = onU * at0 / (at0 - atU);
                endA = onV * at0 / (at0 - atV);
            }
            var isThirdB:Boolean = loneB > 0;
            var isSecondB:Boolean = loneB2 > 0;
            var beginB:Number;
            var endB:Number;
            if (isThirdB)
            {
                beginB = onR + (onP - onR) * atR / (atR - atP);
                endB = onR + (onQ - onR) * atR / (atR - atQ);
            }
            else if (isSecondB)
            {
                beginB = onQ + (onP - onQ) * atQ / (atQ - atP);
                endB = onQ + (onR - onQ) * atQ / (atQ - atR);
            }
            else
            {
                beginB = onP + (onQ - onP) * atP / (atP - atQ);
                endB = onP + (onR - onP) * atP / (atP - atR);
            }
            // in order: the first edge of a at the low end, or at the high
            var lowA:Number = beginA < endA ? beginA : endA;
            var highA:Number = beginA < endA ? endA : beginA;
            var lowB:Number = beginB < endB ? beginB : endB;
            var highB:Number = beginB < endB ? endB : beginB;
            var overlap:Number = highA < highB ? highA : highB;
            near = lowA > lowB ? lowA : lowB;
            overlap -= near;
            onU = onU < 0 ? -onU : onU;
            onV = onV < 0 ? -onV : onV;
            onQ -= onP;
            onQ = onQ < 0 ? -onQ : onQ;
            onR -= onP;
            onR = onR < 0 ? -onR : onR;
            if (overlap > Tolerances.UNSURE_ON_LINE * (onU + onV + onQ + onR))
            {
                return true;
            }
            if (overlap < 0)
            {
                // the edges through the ends that face each other: begins are on a first edge, or a second where a third corner is alone
                var isFirst:Boolean = highA < lowB;
                var isBegin:Boolean = isFirst ? highA == beginA : lowA == beginA;
                var isThirdEdge:Boolean = !isBegin && (isThirdA || isSecondA);
                var ex:Number = isThirdEdge ? vx - ux : isBegin && !isThirdA ? ux : vx;
                var ey:Number = isThirdEdge ? vy - uy : isBegin && !isThirdA ? uy : vy;
                var ez:Number = isThirdEdge ? vz - uz : isBegin && !isThirdA ? uz : vz;
                isBegin = isFirst ? lowB == beginB : highB == beginB;
                isThirdEdge = !isBegin && (isThirdB || isSecondB);
                fx = isThirdEdge ? gx - fx : isBegin && !isThirdB ? fx : gx;
                fy = isThirdEdge ? gy - fy : isBegin && !isThirdB ? fy : gy;
                fz = isThirdEdge ? gz - fz : isBegin && !isThirdB ? fz : gz;
                dx = ey * fz - ez * fy;
                dy = ez * fx - ex * fz;
                dz = ex * fy - ey * fx;
                onU = dx * ux + dy * uy + dz * uz;
                onV = dx * vx + dy * vy + dz * vz;
                lowA = onU < 0 ? onU : 0;
                lowA = onV < lowA ? onV : lowA;
                highA = onU > 0 ? onU : 0;
                highA = onV > highA ? onV : highA;
                onP = dx * px + dy * py + dz * pz;
                onQ = dx * qx + dy * qy + dz * qz;
                onR = dx * rx + dy * ry + dz * rz;
                lowB = onP < onQ ? onP : onQ;
                lowB = onR < lowB ? onR : lowB;
                highB = onP > onQ ? onP : onQ;
                highB = onR > highB ? onR : highB;
                near = lowB > highA ? lowB - highA : lowA - highB;
                if (near > 0 && near * near > limit * (dx * dx + dy * dy + dz * dz))
                {
                    return false;
                }
            }
        }
        return closest.areWithin(a, atA, b, atB);
    }
}
