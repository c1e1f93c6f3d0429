package starlogo.solid
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.RelativePose;
    import starlogo.intersection.triangleTriangle;

    use namespace engine;

    /**
     * Decides by the models' triangles where their hierarchies leave it open: whether those of two leaves touch. Only those are looked at
     * that reach into what the two leaves' boxes have in common.
     */
    internal final class ExactPairTest extends TrianglePairTest
    {
        // A box in the space of the one model or the other: minX, minY, minZ, maxX, maxY, maxZ.
        private var _box:Vector.<Number> = new Vector.<Number>(6, true);

        // The rotation from the second model's space to the first's, row by row.
        private var _rotation:Vector.<Number> = new Vector.<Number>(9, true);

        // The triangles of the first leaf, and of the second, that reach into the box.
        private var _nearA:Vector.<int> = new Vector.<int>();
        private var _nearB:Vector.<int> = new Vector.<int>();
        private var _countA:int;

        // A triangle of the second model in the space of the first.
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);

        /** @inheritDoc */
        public function ExactPairTest(pose:RelativePose)
        {
            super(pose);
        }

        /** @inheritDoc */
        override public function prepare(a:SolidHierarchy, b:SolidHierarchy):Boolean
        {
            var relative:Placement = pose.placement;
            var rotation:Vector.<Number> = _rotation;
            rotation[0] = relative.r00;
            rotation[1] = relative.r01;
            rotation[2] = relative.r02;
            rotation[3] = relative.r10;
            rotation[4] = relative.r11;
            rotation[5] = relative.r12;
            rotation[6] = relative.r20;
            rotation[7] = relative.r21;
            rotation[8] = relative.r22;
            return super.prepare(a, b);
        }

        /** @inheritDoc */
        override public function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            setCommonBox(a, b);
            _countA = collect(solidA.extents, a.first, a.end, _nearA);
            if (_countA == 0)
            {
                return false;
            }
            moveBoxToSecond();
            var near:Vector.<int> = _nearB;
            var count:int = collect(solidB.extents, b.first, b.end, near);
            for (var i:int = 0; i < count; i++)
            {
                if (touchesSome(near[i]))
                {
                    return true;
                }
            }
            return false;
        }

        // What a's box and b's, axis-aligned in the space of the first, have in common.
        private function setCommonBox(a:HierarchyNode, b:HierarchyNode):void
        {
            var relative:Placement = pose.placement;
            var scale:Number = relative.size;
            var x:Number = scale * b.x;
            var y:Number = scale * b.y;
            var z:Number = scale * b.z;
            var halfX:Number = scale * b.halfX;
            var halfY:Number = scale * b.halfY;
            var halfZ:Number = scale * b.halfZ;
            var rotation:Vector.<Number> = _rotation;
            var box:Vector.<Number> = _box;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var row:int = 3 * axis;
                var p:Number = rotation[row];
                var q:Number = rotation[int(row + 1)];
                var r:Number = rotation[int(row + 2)];
                var middle:Number = p * x + q * y + r * z;
                p = p < 0 ? -p : p;
                q = q < 0 ? -q : q;
                r = r < 0 ? -r : r;
                var reach:Number = p * halfX + q * halfY + r * halfZ + touching;
                var middleA:Number = a.z;
                var halfA:Number = a.halfZ;
                if (axis == 0)
                {
                    middle += relative.x;
                    middleA = a.x;
                    halfA = a.halfX;
                }
                else if (axis == 1)
                {
                    middle += relative.y;
                    middleA = a.y;
                    halfA = a.halfY;
                }
                else
                {
                    middle += relative.z;
                }
                var low:Number = middle - reach;
                var lowA:Number = middleA - halfA;
                box[axis] = low > lowA ? low : lowA;
                var high:Number = middle + reach;
                var highA:Number = middleA + halfA;
                box[int(axis + 3)] = high < highA ? high : highA;
            }
        }

        // The box around the same in the space of the second.
        private function moveBoxToSecond():void
        {
            var relative:Placement = pose.placement;
            var scale:Number = relative.size;
            var rotation:Vector.<Number> = _rotation;
            var box:Vector.<Number> = _box;
            var x:Number = (box[0] + box[3]) / 2 - relative.x;
            var y:Number = (box[1] + box[4]) / 2 - relative.y;
            var z:Number = (box[2] + box[5]) / 2 - relative.z;
            var halfX:Number = (box[3] - box[0]) / 2 + touching;
            var halfY:Number = (box[4] - box[1]) / 2 + touching;
            var halfZ:Number = (box[5] - box[2]) / 2 + touching;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var p:Number = rotation[axis];
                var q:Number = rotation[int(axis + 3)];
                var r:Number = rotation[int(axis + 6)];
                var middle:Number = (p * x + q * y + r * z) / scale;
                p = p < 0 ? -p : p;
                q = q < 0 ? -q : q;
                r = r < 0 ? -r : r;
                var reach:Number = (p * halfX + q * halfY + r * halfZ) / scale;
                box[axis] = middle - reach;
                box[int(axis + 3)] = middle + reach;
            }
        }

        // Lists the triangles of a leaf that reach into the box; returns how many.
        private function collect(extents:Vector.<Number>, first:int, end:int, out:Vector.<int>):int
        {
            var box:Vector.<Number> = _box;
            var lowX:Number = box[0];
            var lowY:Number = box[1];
            var lowZ:Number = box[2];
            var highX:Number = box[3];
            var highY:Number = box[4];
            var highZ:Number = box[5];
            var count:int = 0;
            for (var i:int = first; i < end; i++)
            {
                var at:int = 6 * i;
                if (extents[at] > highX || extents[int(at + 3)] < lowX || extents[int(at + 1)] > highY
                        || extents[int(at + 4)] < lowY || extents[int(at + 2)] > highZ || extents[int(at + 5)] < lowZ)
                {
                    continue;
                }
                out[count] = i;
                count++;
            }
            return count;
        }

        // Whether a triangle of the second model touches one of those of the first that are near.
        private function touchesSome(triangle:int):Boolean
        {
            var corners:Vector.<Number> = _corners;
            pose.movePoints(solidB.corners, 9 * triangle, 9 * triangle + 9, corners);
            var touching:Number = this.touching;
            var px:Number = corners[0];
            var py:Number = corners[1];
            var pz:Number = corners[2];
            var qx:Number = corners[3];
            var qy:Number = corners[4];
            var qz:Number = corners[5];
            var rx:Number = corners[6];
            var ry:Number = corners[7];
            var rz:Number = corners[8];
            var minX:Number = px < qx ? px : qx;
            minX = minX < rx ? minX - touching : rx - touching;
            var maxX:Number = px > qx ? px : qx;
            maxX = maxX > rx ? maxX + touching : rx + touching;
            var minY:Number = py < qy ? py : qy;
            minY = minY < ry ? minY - touching : ry - touching;
            var maxY:Number = py > qy ? py : qy;
            maxY = maxY > ry ? maxY + touching : ry + touching;
            var minZ:Number = pz < qz ? pz : qz;
            minZ = minZ < rz ? minZ - touching : rz - touching;
            var maxZ:Number = pz > qz ? pz : qz;
            maxZ = maxZ > rz ? maxZ + touching : rz + touching;
            var near:Vector.<int> = _nearA;
            var extents:Vector.<Number> = solidA.extents;
            var planes:Vector.<Number> = solidA.planes;
            for (var k:int = 0; k < _countA; k++)
            {
                var i:int = near[k];
                var at:int = 6 * i;
                if (extents[at] > maxX || extents[int(at + 3)] < minX || extents[int(at + 1)] > maxY
                        || extents[int(at + 4)] < minY || extents[int(at + 2)] > maxZ || extents[int(at + 5)] < minZ)
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
                var p:Number = nx * px + ny * py + nz * pz - place;
                var q:Number = nx * qx + ny * qy + nz * qz - place;
                var r:Number = nx * rx + ny * ry + nz * rz - place;
                if (p > off && q > off && r > off || p < -off && q < -off && r < -off)
                {
                    continue;
                }
                if (triangleTriangle(solidA.corners, 9 * i, corners, 0, touching))
                {
                    return true;
                }
            }
            return false;
        }
    }
}
