package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.intersection.TrianglePairDistance;
    import starlogo.intersection.triangleTriangle;

    use namespace engine;

    /** Decides by triangles whether two leaves touch, for models that stand still. */
    internal final class LeafOverlapTest extends LeafPairTest
    {
        private var _closest:TrianglePairDistance = new TrianglePairDistance();

        /** @inheritDoc */
        override public function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            _closest.reach = touching;
            move(b);
            var count:int = b.end - b.first;
            for (var i:int = 0; i < count; i++)
            {
                if (touchesSome(i, a))
                {
                    return true;
                }
            }
            return false;
        }

        // Whether a triangle of the second model touches a triangle in a leaf of the first.
        private function touchesSome(triangle:int, a:HierarchyNode):Boolean
        {
            var at:int = 6 * triangle;
            var extents:Vector.<Number> = movedExtents;
            var touching:Number = this.touching;
            var minX:Number = extents[at] - touching;
            var minY:Number = extents[int(at + 1)] - touching;
            var minZ:Number = extents[int(at + 2)] - touching;
            var maxX:Number = extents[int(at + 3)] + touching;
            var maxY:Number = extents[int(at + 4)] + touching;
            var maxZ:Number = extents[int(at + 5)] + touching;
            var corners:Vector.<Number> = movedCorners;
            var corner:int = 9 * triangle;
            var px:Number = corners[corner];
            var py:Number = corners[int(corner + 1)];
            var pz:Number = corners[int(corner + 2)];
            var qx:Number = corners[int(corner + 3)];
            var qy:Number = corners[int(corner + 4)];
            var qz:Number = corners[int(corner + 5)];
            var rx:Number = corners[int(corner + 6)];
            var ry:Number = corners[int(corner + 7)];
            var rz:Number = corners[int(corner + 8)];
            extents = solidA.extents;
            var planes:Vector.<Number> = solidA.planes;
            var off:Number = 2 * touching + solidA.flatness;
            var end:int = a.end;
            for (var i:int = a.first; i < end; i++)
            {
                at = 6 * i;
                if (extents[at] > maxX || extents[int(at + 3)] < minX || extents[int(at + 1)] > maxY
                        || extents[int(at + 4)] < minY || extents[int(at + 2)] > maxZ || extents[int(at + 5)] < minZ)
                {
                    continue;
                }
                triangleTests++;

                // Most triangles are on one side of the other's plane.
                at = 4 * i;
                var nx:Number = planes[at];
                var ny:Number = planes[int(at + 1)];
                var nz:Number = planes[int(at + 2)];
                var place:Number = planes[int(at + 3)];
                var p:Number = nx * px + ny * py + nz * pz - place;
                var q:Number = nx * qx + ny * qy + nz * qz - place;
                var r:Number = nx * rx + ny * ry + nz * rz - place;
                if (p > off && q > off && r > off || p < -off && q < -off && r < -off)
                {
                    continue;
                }
                if (triangleTriangle(solidA.corners, 9 * i, corners, corner, _closest))
                {
                    return true;
                }
            }
            return false;
        }
    }
}
