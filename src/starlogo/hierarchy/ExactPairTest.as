package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.triangleTriangle;

    use namespace engine;

    /**
     * Decides by the models' triangles where their hierarchies leave it open: whether those of two leaves touch.
     */
    internal final class ExactPairTest
    {
        /** Pairs of triangles that were tested; HierarchyTraversal sets it to 0. */
        public var triangleTests:int = 0;

        private var _pose:RelativePose;

        private var _solidA:Solid;
        private var _solidB:Solid;

        // How close triangles of these models touch.
        private var _touching:Number;

        // The triangles of the first leaf that reach into what the two boxes have in common.
        private var _near:Vector.<int> = new Vector.<int>();
        private var _nearCount:int;

        // A triangle of the second model in the space of the first.
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);

        /**
         * @param pose where the second model is in the space of the first, whenever two are asked about
         */
        public function ExactPairTest(pose:RelativePose)
        {
            _pose = pose;
        }

        /**
         * Prepares for two models that the pose relates.
         *
         * @return whether both have triangles; otherwise nothing else may be asked
         */
        public function prepare(a:Hierarchy, b:Hierarchy):Boolean
        {
            if (!a.hasTriangles || !b.hasTriangles)
            {
                return false;
            }
            _solidA = a.solid;
            _solidB = b.solid;
            _touching = _pose.gap + Tolerances.SURFACES * (a.root.radius + b.root.radius * _pose.placement.size);
            return true;
        }

        /** Whether a triangle of a leaf of the first model touches one of a leaf of the second. */
        public function leavesTouch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            var touching:Number = _touching;
            var relative:Placement = _pose.placement;
            var scale:Number = relative.size;
            var moveX:Number = relative.x;
            var moveY:Number = relative.y;
            var moveZ:Number = relative.z;
            var r00:Number = relative.r00;
            var r01:Number = relative.r01;
            var r02:Number = relative.r02;
            var r10:Number = relative.r10;
            var r11:Number = relative.r11;
            var r12:Number = relative.r12;
            var r20:Number = relative.r20;
            var r21:Number = relative.r21;
            var r22:Number = relative.r22;

            // what b's box, axis-aligned in the space of the first, and a's have in common
            var x:Number = scale * b.x;
            var y:Number = scale * b.y;
            var z:Number = scale * b.z;
            var halfX:Number = scale * b.halfX;
            var halfY:Number = scale * b.halfY;
            var halfZ:Number = scale * b.halfZ;
            var abs0:Number = r00 < 0 ? -r00 : r00;
            var abs1:Number = r01 < 0 ? -r01 : r01;
            var abs2:Number = r02 < 0 ? -r02 : r02;
            var middle:Number = r00 * x + r01 * y + r02 * z + moveX;
            var reach:Number = abs0 * halfX + abs1 * halfY + abs2 * halfZ + touching;
            var low:Number = a.x - a.halfX;
            var high:Number = a.x + a.halfX;
            var lowX:Number = middle - reach;
            lowX = lowX > low ? lowX : low;
            var highX:Number = middle + reach;
            highX = highX < high ? highX : high;
            abs0 = r10 < 0 ? -r10 : r10;
            abs1 = r11 < 0 ? -r11 : r11;
            abs2 = r12 < 0 ? -r12 : r12;
            middle = r10 * x + r11 * y + r12 * z + moveY;
            reach = abs0 * halfX + abs1 * halfY + abs2 * halfZ + touching;
            low = a.y - a.halfY;
            high = a.y + a.halfY;
            var lowY:Number = middle - reach;
            lowY = lowY > low ? lowY : low;
            var highY:Number = middle + reach;
            highY = highY < high ? highY : high;
            abs0 = r20 < 0 ? -r20 : r20;
            abs1 = r21 < 0 ? -r21 : r21;
            abs2 = r22 < 0 ? -r22 : r22;
            middle = r20 * x + r21 * y + r22 * z + moveZ;
            reach = abs0 * halfX + abs1 * halfY + abs2 * halfZ + touching;
            low = a.z - a.halfZ;
            high = a.z + a.halfZ;
            var lowZ:Number = middle - reach;
            lowZ = lowZ > low ? lowZ : low;
            var highZ:Number = middle + reach;
            highZ = highZ < high ? highZ : high;

            // a's triangles that reach into it
            var near:Vector.<int> = _near;
            var nearCount:int = 0;
            var extents:Vector.<Number> = _solidA.extents;
            var at:int = 6 * a.first;
            var last:int = a.end;
            for (var i:int = a.first; i < last; i++)
            {
                if (extents[at] <= highX)
                {
                    if (extents[int(at + 3)] >= lowX)
                    {
                        if (extents[int(at + 1)] <= highY)
                        {
                            if (extents[int(at + 4)] >= lowY)
                            {
                                if (extents[int(at + 2)] <= highZ)
                                {
                                    if (extents[int(at + 5)] >= lowZ)
                                    {
                                        near[nearCount] = i;
                                        nearCount++;
                                    }
                                }
                            }
                        }
                    }
                }
                at += 6;
            }
            if (nearCount == 0)
            {
                return false;
            }
            _nearCount = nearCount;

            // the same in the space of the second
            halfX = (highX - lowX) / 2 + touching;
            halfY = (highY - lowY) / 2 + touching;
            halfZ = (highZ - lowZ) / 2 + touching;
            x = (lowX + highX) / 2 - moveX;
            y = (lowY + highY) / 2 - moveY;
            z = (lowZ + highZ) / 2 - moveZ;
            abs0 = r00 < 0 ? -r00 : r00;
            abs1 = r10 < 0 ? -r10 : r10;
            abs2 = r20 < 0 ? -r20 : r20;
            middle = (r00 * x + r10 * y + r20 * z) / scale;
            reach = (abs0 * halfX + abs1 * halfY + abs2 * halfZ) / scale;
            lowX = middle - reach;
            highX = middle + reach;
            abs0 = r01 < 0 ? -r01 : r01;
            abs1 = r11 < 0 ? -r11 : r11;
            abs2 = r21 < 0 ? -r21 : r21;
            middle = (r01 * x + r11 * y + r21 * z) / scale;
            reach = (abs0 * halfX + abs1 * halfY + abs2 * halfZ) / scale;
            lowY = middle - reach;
            highY = middle + reach;
            abs0 = r02 < 0 ? -r02 : r02;
            abs1 = r12 < 0 ? -r12 : r12;
            abs2 = r22 < 0 ? -r22 : r22;
            middle = (r02 * x + r12 * y + r22 * z) / scale;
            reach = (abs0 * halfX + abs1 * halfY + abs2 * halfZ) / scale;
            lowZ = middle - reach;
            highZ = middle + reach;
            extents = _solidB.extents;
            at = 6 * b.first;
            last = b.end;
            for (i = b.first; i < last; i++)
            {
                if (extents[at] <= highX)
                {
                    if (extents[int(at + 3)] >= lowX)
                    {
                        if (extents[int(at + 1)] <= highY)
                        {
                            if (extents[int(at + 4)] >= lowY)
                            {
                                if (extents[int(at + 2)] <= highZ)
                                {
                                    if (extents[int(at + 5)] >= lowZ)
                                    {
                                        if (touchesSome(i))
                                        {
                                            return true;
                                        }
                                    }
                                }
                            }
                        }
                    }
                }
                at += 6;
            }
            return false;
        }

        // Whether a triangle of the second model touches one of those of the first that are near.
        private function touchesSome(triangle:int):Boolean
        {
            var corners:Vector.<Number> = _corners;
            _pose.movePoints(_solidB.corners, 9 * triangle, 9 * triangle + 9, corners);
            var touching:Number = _touching;
            var px:Number = corners[0];
            var qx:Number = corners[3];
            var rx:Number = corners[6];
            var minX:Number = px < qx ? px : qx;
            minX = minX < rx ? minX : rx;
            minX -= touching;
            var maxX:Number = px > qx ? px : qx;
            maxX = maxX > rx ? maxX : rx;
            maxX += touching;
            var py:Number = corners[1];
            var qy:Number = corners[4];
            var ry:Number = corners[7];
            var minY:Number = py < qy ? py : qy;
            minY = minY < ry ? minY : ry;
            minY -= touching;
            var maxY:Number = py > qy ? py : qy;
            maxY = maxY > ry ? maxY : ry;
            maxY += touching;
            var pz:Number = corners[2];
            var qz:Number = corners[5];
            var rz:Number = corners[8];
            var minZ:Number = pz < qz ? pz : qz;
            minZ = minZ < rz ? minZ : rz;
            minZ -= touching;
            var maxZ:Number = pz > qz ? pz : qz;
            maxZ = maxZ > rz ? maxZ : rz;
            maxZ += touching;
            var near:Vector.<int> = _near;
            var nearCount:int = _nearCount;
            var extents:Vector.<Number> = _solidA.extents;
            var planes:Vector.<Number> = _solidA.planes;
            var cornersA:Vector.<Number> = _solidA.corners;
            for (var k:int = 0; k < nearCount; k++)
            {
                var i:int = near[k];
                var at:int = 6 * i;
                if (extents[at] > maxX)
                {
                    continue;
                }
                if (extents[int(at + 3)] < minX)
                {
                    continue;
                }
                if (extents[int(at + 1)] > maxY)
                {
                    continue;
                }
                if (extents[int(at + 4)] < minY)
                {
                    continue;
                }
                if (extents[int(at + 2)] > maxZ)
                {
                    continue;
                }
                if (extents[int(at + 5)] < minZ)
                {
                    continue;
                }
                triangleTests++;

                // on one side of its plane, as most are
                at = 5 * i;
                var nx:Number = planes[at];
                var ny:Number = planes[int(at + 1)];
                var nz:Number = planes[int(at + 2)];
                var place:Number = planes[int(at + 3)];
                var off:Number = 2 * touching + planes[int(at + 4)];
                var side:Number = nx * px + ny * py + nz * pz - place;
                if (side > off)
                {
                    if (nx * qx + ny * qy + nz * qz - place > off)
                    {
                        if (nx * rx + ny * ry + nz * rz - place > off)
                        {
                            continue;
                        }
                    }
                }
                else if (side < -off)
                {
                    if (nx * qx + ny * qy + nz * qz - place < -off)
                    {
                        if (nx * rx + ny * ry + nz * rz - place < -off)
                        {
                            continue;
                        }
                    }
                }
                if (triangleTriangle(cornersA, 9 * i, corners, 0, touching))
                {
                    return true;
                }
            }
            return false;
        }
    }
}
