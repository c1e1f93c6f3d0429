package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.RelativePose;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.TriangleSweep;

    use namespace engine;

    /**
     * Decides by the models' triangles when they touch, where their hierarchies leave it open: when those of two leaves do.
     */
    internal final class SweptPairTest extends TrianglePairTest
    {
        private var _sweep:TriangleSweep = new TriangleSweep();

        // The triangles of a leaf of the second model in the space of the first, at time 0.
        private var _corners:Vector.<Number> = new Vector.<Number>();
        private var _cornersOf:HierarchyNode;

        // The triangles that touched first: where their corners begin, those of the second model in its own space.
        private var _firstA:int;
        private var _firstB:int;

        /** @inheritDoc */
        public function SweptPairTest(pose:RelativePose)
        {
            super(pose);
        }

        /** @inheritDoc */
        override public function prepare(a:SolidHierarchy, b:SolidHierarchy):Boolean
        {
            _cornersOf = null;
            return super.prepare(a, b);
        }

        /** @inheritDoc */
        override public function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            if (b !== _cornersOf)
            {
                pose.movePoints(solidB.corners, 9 * b.first, 9 * b.end, _corners);
                _cornersOf = b;
            }
            var latest:Number = time;
            time = RelativeMotion.NEVER;
            var motion:RelativeMotion = pose.motion;
            var corners:Vector.<Number> = _corners;
            var extents:Vector.<Number> = solidA.extents;
            var length:int = 9 * (b.end - b.first);
            for (var at:int = 0; at < length; at += 9)
            {
                // what the triangle passes over till then
                var x:Number = motion.x * latest;
                var y:Number = motion.y * latest;
                var z:Number = motion.z * latest;
                var minX:Number = least(corners, at, x);
                var maxX:Number = most(corners, at, x);
                if (minX > a.x + a.halfX || maxX < a.x - a.halfX)
                {
                    continue;
                }
                var minY:Number = least(corners, at + 1, y);
                var maxY:Number = most(corners, at + 1, y);
                if (minY > a.y + a.halfY || maxY < a.y - a.halfY)
                {
                    continue;
                }
                var minZ:Number = least(corners, at + 2, z);
                var maxZ:Number = most(corners, at + 2, z);
                if (minZ > a.z + a.halfZ || maxZ < a.z - a.halfZ)
                {
                    continue;
                }
                var end:int = a.end;
                for (var i:int = a.first; i < end; i++)
                {
                    var extent:int = 6 * i;
                    if (extents[extent] > maxX || extents[int(extent + 3)] < minX || extents[int(extent + 1)] > maxY
                            || extents[int(extent + 4)] < minY || extents[int(extent + 2)] > maxZ || extents[int(extent + 5)] < minZ)
                    {
                        continue;
                    }
                    triangleTests++;
                    var impact:Number = _sweep.touch(solidA.corners, 9 * i, corners, at, motion.x, motion.y, motion.z, touching, latest);
                    if (impact < time)
                    {
                        time = latest = impact;
                        _firstA = 9 * i;
                        _firstB = 9 * b.first + at;
                        if (impact == 0)
                        {
                            return true;
                        }
                    }
                }
            }
            return time <= 1;
        }

        /**
         * Where the triangles that touched first do so, in the space of the first model.
         *
         * @param moment when that was
         * @param out takes it
         */
        public function findContact(moment:Number, out:ContactPoint):void
        {
            _cornersOf = null;
            pose.movePoints(solidB.corners, _firstB, _firstB + 9, _corners);
            var motion:RelativeMotion = pose.motion;
            _sweep.findContact(solidA.corners, _firstA, _corners, 0, moment * motion.x, moment * motion.y, moment * motion.z, out);
        }

        private function least(corners:Vector.<Number>, at:int, motion:Number):Number
        {
            var p:Number = corners[at];
            var q:Number = corners[int(at + 3)];
            var r:Number = corners[int(at + 6)];
            p = p < q ? p : q;
            p = p < r ? p : r;
            p -= touching;
            return motion < 0 ? p + motion : p;
        }

        private function most(corners:Vector.<Number>, at:int, motion:Number):Number
        {
            var p:Number = corners[at];
            var q:Number = corners[int(at + 3)];
            var r:Number = corners[int(at + 6)];
            p = p > q ? p : q;
            p = p > r ? p : r;
            p += touching;
            return motion > 0 ? p + motion : p;
        }
    }
}
