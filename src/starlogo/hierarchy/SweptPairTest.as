package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.TriangleSweep;

    use namespace engine;

    /**
     * Decides by the models' triangles when they touch, where their hierarchies leave it open: when those of two leaves do.
     */
    internal final class SweptPairTest
    {
        /** Pairs of triangles that were tested; SweptHierarchyTraversal sets it to 0. */
        public var triangleTests:int = 0;

        private var _pose:RelativePose;
        private var _sweep:TriangleSweep = new TriangleSweep();
        private var _solidA:Solid;
        private var _solidB:Solid;

        // How close triangles of these models touch.
        private var _touching:Number;

        // The triangles of a leaf of the second model in the space of the first, at time 0, and their way.
        private var _corners:Vector.<Number> = new Vector.<Number>();
        private var _cornersOf:HierarchyNode;
        private var _wayX:Number;
        private var _wayY:Number;
        private var _wayZ:Number;

        // The triangles that touched first: where their corners begin, those of the second model in its own space.
        private var _firstA:int;
        private var _firstB:int;

        /**
         * @param pose where the second model is in the space of the first at time 0, whenever two are asked about
         */
        public function SweptPairTest(pose:RelativePose)
        {
            _pose = pose;
        }

        /**
         * Prepares for two models that the pose relates.
         *
         * @param x the way of the second in the space of the first
         * @param y likewise
         * @param z likewise
         * @return whether both have triangles; otherwise nothing else may be asked
         */
        public function prepare(a:Hierarchy, b:Hierarchy, x:Number, y:Number, z:Number):Boolean
        {
            if (!a.hasTriangles || !b.hasTriangles)
            {
                return false;
            }
            _solidA = a.solid;
            _solidB = b.solid;
            _cornersOf = null;
            _wayX = x;
            _wayY = y;
            _wayZ = z;
            _touching = _pose.gap + Tolerances.SURFACES * (a.root.radius + b.root.radius * _pose.placement.size);
            return true;
        }

        /** When a triangle of a leaf of the first model touches one of a leaf of the second, before a time; else RelativeMotion.NEVER. */
        public function leavesTouch(a:HierarchyNode, b:HierarchyNode, latest:Number):Number
        {
            if (b !== _cornersOf)
            {
                _pose.movePoints(_solidB.corners, 9 * b.first, 9 * b.end, _corners);
                _cornersOf = b;
            }
            var earliest:Number = RelativeMotion.NEVER;
            var corners:Vector.<Number> = _corners;
            var length:int = 9 * (b.end - b.first);
            var first:int = a.first;
            var end:int = a.end;
            for (var at:int = 0; at < length; at += 9)
            {
                // what the triangle passes over till then
                var x:Number = _wayX * latest;
                var y:Number = _wayY * latest;
                var z:Number = _wayZ * latest;
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
                var extents:Vector.<Number> = _solidA.extents;
                for (var i:int = first; i < end; i++)
                {
                    var extent:int = 6 * i;
                    if (extents[extent] > maxX || extents[int(extent + 3)] < minX || extents[int(extent + 1)] > maxY
                            || extents[int(extent + 4)] < minY || extents[int(extent + 2)] > maxZ || extents[int(extent + 5)] < minZ)
                    {
                        continue;
                    }
                    triangleTests++;
                    var time:Number = _sweep.touch(_solidA.corners, 9 * i, corners, at, _wayX, _wayY, _wayZ, _touching, latest);
                    if (time < earliest)
                    {
                        earliest = latest = time;
                        _firstA = 9 * i;
                        _firstB = 9 * b.first + at;
                        if (time == 0)
                        {
                            return 0;
                        }
                    }
                }
            }
            return earliest;
        }

        /**
         * Where the triangles that touched first do so, in the space of the first model.
         *
         * @param time when that was
         * @param out takes it
         */
        public function findContact(time:Number, out:ContactPoint):void
        {
            _cornersOf = null;
            _pose.movePoints(_solidB.corners, _firstB, _firstB + 9, _corners);
            _sweep.findContact(_solidA.corners, _firstA, _corners, 0, time * _wayX, time * _wayY, time * _wayZ, out);
        }

        private function least(corners:Vector.<Number>, at:int, way:Number):Number
        {
            var p:Number = corners[at];
            var q:Number = corners[int(at + 3)];
            var r:Number = corners[int(at + 6)];
            p = p < q ? p : q;
            p = p < r ? p : r;
            p -= _touching;
            return way < 0 ? p + way : p;
        }

        private function most(corners:Vector.<Number>, at:int, way:Number):Number
        {
            var p:Number = corners[at];
            var q:Number = corners[int(at + 3)];
            var r:Number = corners[int(at + 6)];
            p = p > q ? p : q;
            p = p > r ? p : r;
            p += _touching;
            return way > 0 ? p + way : p;
        }
    }
}
