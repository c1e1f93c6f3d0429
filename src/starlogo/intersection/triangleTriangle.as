package starlogo.intersection
{
    import starlogo.geometry.Tolerances;

    /**
     * Whether two triangles meet: separating axes (Ericson, "Real-Time Collision Detection", §5.2.1), most of
     * which need not be tried.
     *
     * <p>Most triangles are on one side of the other's plane. Of those that cross each other's planes, the pieces that they
     * cut out of the line in both decide (Möller, "A fast triangle-triangle intersection test", Journal of Graphics Tools,
     * 1997): where the pieces clearly overlap the triangles meet, and where they do not the edges that face each other give the
     * one axis that can separate. The rest, triangles that just touch or are nearly in one plane, and needles, is left to
     * TriangleAxes.</p>
     *
     * <p>Triangles that overlap, touch, or have a gap of no more than the tolerance always meet. The opposite error is
     * bounded by geometry, not by the tolerance: of triangles of size 1, those that are farther apart than 1e-7 are
     * told apart. Symmetric up to rounding; allocates nothing.</p>
     *
     * <p>In order: the corners, from a's first; b on one side of a's plane; a on one side of b's; the pieces of the line in both; the edges
     * that face each other; all axes.</p>
     *
     * @param a has nine numbers of a triangle: x, y, z of each corner
     * @param atA where in a they begin
     * @param b has nine numbers of the other, in the same space
     * @param atB where in b they begin
     * @param axes for the rest, with the tolerance, the gap that still counts as touching: Tolerances.SURFACES of the coordinates' size is
     *     above the rounding errors
     *
     * @private
     */
    public function triangleTriangle(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int, axes:TriangleAxes):Boolean
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
        var tolerance:Number = axes.tolerance;
        var limit:Number = tolerance * tolerance;

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
                axes.ux = ux;
                axes.uy = uy;
                axes.uz = uz;
                axes.vx = vx;
                axes.vy = vy;
                axes.vz = vz;
                axes.px = px;
                axes.py = py;
                axes.pz = pz;
                axes.qx = qx;
                axes.qy = qy;
                axes.qz = qz;
                axes.rx = rx;
                axes.ry = ry;
                axes.rz = rz;
                // the edges through the ends that face each other: begins are on a first edge, or a second where a third corner is alone
                var isFirst:Boolean = highA < lowB;
                var isBegin:Boolean = isFirst ? highA == beginA : lowA == beginA;
                if (!isBegin || isThirdA)
                {
                    var isThirdEdge:Boolean = !isBegin && (isThirdA || isSecondA);
                    ux = isThirdEdge ? vx - ux : vx;
                    uy = isThirdEdge ? vy - uy : vy;
                    uz = isThirdEdge ? vz - uz : vz;
                }
                isBegin = isFirst ? lowB == beginB : highB == beginB;
                if (!isBegin || isThirdB)
                {
                    isThirdEdge = !isBegin && (isThirdB || isSecondB);
                    fx = isThirdEdge ? gx - fx : gx;
                    fy = isThirdEdge ? gy - fy : gy;
                    fz = isThirdEdge ? gz - fz : gz;
                }
                axes.axisX = uy * fz - uz * fy;
                axes.axisY = uz * fx - ux * fz;
                axes.axisZ = ux * fy - uy * fx;
                return !axes.isAxis() && !axes.areApart();
            }
        }
        axes.relate(a, atA, b, atB);
        return !axes.areApart();
    }
}
