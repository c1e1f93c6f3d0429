package starlogo.solid
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.RelativePose;
    import starlogo.intersection.TriangleAxes;
    import starlogo.intersection.triangleTriangle;

    use namespace engine;

    /**
     * Decides by the models' triangles where their hierarchies leave it open: whether those of two leaves touch. Only those are looked at
     * that reach into what the two leaves' boxes have in common.
     */
    internal final class ExactPairTest extends TrianglePairTest
    {
        // A box in the space of the one model or the other.
        private var _minX:Number;
        private var _minY:Number;
        private var _minZ:Number;
        private var _maxX:Number;
        private var _maxY:Number;
        private var _maxZ:Number;

        // The triangles of the first leaf, and of the second, that reach into the box.
        private var _nearA:Vector.<int> = new Vector.<int>();
        private var _nearB:Vector.<int> = new Vector.<int>();
        private var _countA:int;

        // A triangle of the second model in the space of the first.
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);
        private var _axes:TriangleAxes = new TriangleAxes();

        /** @inheritDoc */
        public function ExactPairTest(pose:RelativePose)
        {
            super(pose);
        }

        /** @inheritDoc */
        override public function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            _axes.tolerance = touching;
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
            var p:Number = relative.r00;
            var q:Number = relative.r01;
            var r:Number = relative.r02;
            var middle:Number = p * x + q * y + r * z + relative.x;
            p = p < 0 ? -p : p;
            q = q < 0 ? -q : q;
            r = r < 0 ? -r : r;
            var reach:Number = p * halfX + q * halfY + r * halfZ + touching;
            var low:Number = middle - reach;
            var high:Number = middle + reach;
            var lowA:Number = a.x - a.halfX;
            var highA:Number = a.x + a.halfX;
            _minX = low > lowA ? low : lowA;
            _maxX = high < highA ? high : highA;
            p = relative.r10;
            q = relative.r11;
            r = relative.r12;
            middle = p * x + q * y + r * z + relative.y;
            p = p < 0 ? -p : p;
            q = q < 0 ? -q : q;
            r = r < 0 ? -r : r;
            reach = p * halfX + q * halfY + r * halfZ + touching;
            low = middle - reach;
            high = middle + reach;
            lowA = a.y - a.halfY;
            highA = a.y + a.halfY;
            _minY = low > lowA ? low : lowA;
            _maxY = high < highA ? high : highA;
            p = relative.r20;
            q = relative.r21;
            r = relative.r22;
            middle = p * x + q * y + r * z + relative.z;
            p = p < 0 ? -p : p;
            q = q < 0 ? -q : q;
            r = r < 0 ? -r : r;
            reach = p * halfX + q * halfY + r * halfZ + touching;
            low = middle - reach;
            high = middle + reach;
            lowA = a.z - a.halfZ;
            highA = a.z + a.halfZ;
            _minZ = low > lowA ? low : lowA;
            _maxZ = high < highA ? high : highA;
        }

        // The box around the same in the space of the second.
        private function moveBoxToSecond():void
        {
            var relative:Placement = pose.placement;
            var scale:Number = relative.size;
            var halfX:Number = (_maxX - _minX) / 2 + touching;
            var halfY:Number = (_maxY - _minY) / 2 + touching;
            var halfZ:Number = (_maxZ - _minZ) / 2 + touching;
            var x:Number = (_minX + _maxX) / 2 - relative.x;
            var y:Number = (_minY + _maxY) / 2 - relative.y;
            var z:Number = (_minZ + _maxZ) / 2 - relative.z;
            var p:Number = relative.r00;
            var q:Number = relative.r10;
            var r:Number = relative.r20;
            var middle:Number = (p * x + q * y + r * z) / scale;
            p = p < 0 ? -p : p;
            q = q < 0 ? -q : q;
            r = r < 0 ? -r : r;
            var reach:Number = (p * halfX + q * halfY + r * halfZ) / scale;
            _minX = middle - reach;
            _maxX = middle + reach;
            p = relative.r01;
            q = relative.r11;
            r = relative.r21;
            middle = (p * x + q * y + r * z) / scale;
            p = p < 0 ? -p : p;
            q = q < 0 ? -q : q;
            r = r < 0 ? -r : r;
            reach = (p * halfX + q * halfY + r * halfZ) / scale;
            _minY = middle - reach;
            _maxY = middle + reach;
            p = relative.r02;
            q = relative.r12;
            r = relative.r22;
            middle = (p * x + q * y + r * z) / scale;
            p = p < 0 ? -p : p;
            q = q < 0 ? -q : q;
            r = r < 0 ? -r : r;
            reach = (p * halfX + q * halfY + r * halfZ) / scale;
            _minZ = middle - reach;
            _maxZ = middle + reach;
        }

        // Lists the triangles of a leaf that reach into the box; returns how many.
        private function collect(extents:Vector.<Number>, first:int, end:int, out:Vector.<int>):int
        {
            var lowX:Number = _minX;
            var highX:Number = _maxX;
            var lowY:Number = _minY;
            var highY:Number = _maxY;
            var lowZ:Number = _minZ;
            var highZ:Number = _maxZ;
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
                if (triangleTriangle(solidA.corners, 9 * i, corners, 0, _axes))
                {
                    return true;
                }
            }
            return false;
        }
    }
}
