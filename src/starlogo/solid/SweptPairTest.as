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

        // How far a triangle goes along an axis, and between what it is then.
        private var _way:Number = 0;
        private var _min:Number = 0;
        private var _max:Number = 0;

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
            _sweep.tolerance = touching;
            var corners:Vector.<Number> = _corners;
            var extents:Vector.<Number> = solidA.extents;
            var length:int = 9 * (b.end - b.first);
            for (var at:int = 0; at < length; at += 9)
            {
                // what the triangle passes over till then
                _way = motion.x * latest;
                span(at);
                var minX:Number = _min;
                var maxX:Number = _max;
                if (minX > a.x + a.halfX || maxX < a.x - a.halfX)
                {
                    continue;
                }
                _way = motion.y * latest;
                span(at + 1);
                var minY:Number = _min;
                var maxY:Number = _max;
                if (minY > a.y + a.halfY || maxY < a.y - a.halfY)
                {
                    continue;
                }
                _way = motion.z * latest;
                span(at + 2);
                var minZ:Number = _min;
                var maxZ:Number = _max;
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
                    _sweep.relate(solidA.corners, 9 * i, corners, at);
                    motion.time = latest;
                    _sweep.findTime(motion);
                    var impact:Number = motion.time;
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
         * Where the triangles that touched first do so, at the pose's time, in the space of the first model.
         *
         * @param out takes it
         */
        public function findContact(out:ContactPoint):void
        {
            _cornersOf = null;
            pose.movePoints(solidB.corners, _firstB, _firstB + 9, _corners);
            var corners:Vector.<Number> = solidA.corners;
            _sweep.relate(corners, _firstA, _corners, 0);
            _sweep.findContact(pose.motion, out);
            // from the first triangle's first corner
            out.x += corners[_firstA];
            out.y += corners[int(_firstA + 1)];
            out.z += corners[int(_firstA + 2)];
        }

        // Finds between what the corners of a triangle are on the way, along one axis; at is where the first's coordinate is.
        private function span(at:int):void
        {
            var p:Number = _corners[at];
            var q:Number = _corners[int(at + 3)];
            var r:Number = _corners[int(at + 6)];
            var low:Number = p < q ? p : q;
            low = low < r ? low : r;
            low -= touching;
            var high:Number = p > q ? p : q;
            high = high > r ? high : r;
            high += touching;
            _min = _way < 0 ? low + _way : low;
            _max = _way > 0 ? high + _way : high;
        }
    }
}
