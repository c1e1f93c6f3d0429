package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.TriangleContactFinder;
    import starlogo.intersection.sweep.TriangleSweep;

    use namespace engine;

    /** Decides by triangles when two leaves first touch, for models that move. */
    internal final class LeafSweepTest extends LeafPairTest
    {
        private var _sweep:TriangleSweep = new TriangleSweep();
        private var _overlap:TriangleContactFinder = new TriangleContactFinder();

        // The triangles that touch first: the indices of their corners, the second's in its own space. Then the second's corners in the
        // first model's space. This list begins empty, as <code>movedCorners</code> does, because V8 makes objects for Numbers that a method
        // writes to lists of both kinds.
        private var _firstA:int;
        private var _firstB:int;
        private var _corners:Vector.<Number> = new Vector.<Number>();

        /** @inheritDoc */
        override public function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            move(b);
            _sweep.tolerance = touching;
            var motion:RelativeMotion = pose.motion;
            var latest:Number = least;
            least = RelativeMotion.NEVER;
            var corners:Vector.<Number> = movedCorners;
            var spans:Vector.<Number> = movedExtents;
            var extents:Vector.<Number> = solidA.extents;
            // Higher indices come first, as in the traversal. So if several triangles touch at the same time, the result does not depend on
            // where leaves end.
            for (var k:int = b.end - b.first - 1; k >= 0; k--)
            {
                // the extents of the triangle during its motion until <code>latest</code>
                var span:int = 6 * k;
                var minX:Number = spans[span] - touching;
                var minY:Number = spans[int(span + 1)] - touching;
                var minZ:Number = spans[int(span + 2)] - touching;
                var maxX:Number = spans[int(span + 3)] + touching;
                var maxY:Number = spans[int(span + 4)] + touching;
                var maxZ:Number = spans[int(span + 5)] + touching;
                var way:Number = motion.x * latest;
                minX = way < 0 ? minX + way : minX;
                maxX = way > 0 ? maxX + way : maxX;
                way = motion.y * latest;
                minY = way < 0 ? minY + way : minY;
                maxY = way > 0 ? maxY + way : maxY;
                way = motion.z * latest;
                minZ = way < 0 ? minZ + way : minZ;
                maxZ = way > 0 ? maxZ + way : maxZ;
                for (var i:int = a.end - 1; i >= a.first; i--)
                {
                    var extent:int = 6 * i;
                    if (extents[extent] > maxX || extents[int(extent + 3)] < minX || extents[int(extent + 1)] > maxY
                            || extents[int(extent + 4)] < minY || extents[int(extent + 2)] > maxZ || extents[int(extent + 5)] < minZ)
                    {
                        continue;
                    }
                    triangleTests++;
                    _sweep.relate(solidA.corners, 9 * i, corners, 9 * k);
                    motion.time = latest;
                    _sweep.findTime(motion);
                    var impact:Number = motion.time;
                    if (impact < least)
                    {
                        least = latest = impact;
                        _firstA = 9 * i;
                        _firstB = 9 * (b.first + k);
                        if (impact == 0)
                        {
                            return true;
                        }
                    }
                }
            }
            return least <= 1;
        }

        /** @inheritDoc */
        override public function findContact(out:ContactPoint):void
        {
            pose.placement.movePoints(solidB.corners, _firstB, _firstB + 9, _corners);
            _overlap.relate(solidA.corners, _firstA, _corners, 0);
            _overlap.tolerance = touching;
            _overlap.findContact(pose.motion, out);
        }
    }
}
