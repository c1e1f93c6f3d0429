package starlogo.geometry.hull
{
    import starlogo.geometry.Tolerances;

    /**
     * The points outside of the hull that QuickHull is building. Each point is on the list of a face that it lies beyond, as long as it may
     * become a vertex.
     */
    internal final class OutsidePoints
    {
        // Level 0 holds faces whose farthest point is at most 1 step away, level n those with 2^(n-1) to 2^n steps. Every distance is below
        // 2^26.
        private static const LEVELS:int = 27;

        private var _points:Vector.<Number>;

        // For each point, the next point on its face's list, or -1.
        private var _next:Vector.<int>;

        // The faces that have received a list, in a stack for each level of their farthest points' distances. Some are buried by now.
        private var _pending:Vector.<Vector.<HullFace>> = new Vector.<Vector.<HullFace>>(LEVELS, true);

        /**
         * @param points x, y, z of every point
         */
        public function OutsidePoints(points:Vector.<Number>)
        {
            _points = points;
            _next = new Vector.<int>(points.length / 3);
            for (var i:int = 0; i < LEVELS; i++)
            {
                _pending[i] = new Vector.<HullFace>();
            }
        }

        /**
         * Returns the face of the hull whose farthest point is farthest from it, up to a factor of 2. Returns null if no face has points
         * beyond it.
         *
         * <p>So the hull becomes finer everywhere at the same time. If one part of a curve were finished first, each vertex of the opposite
         * part would see most of its faces.</p>
         */
        public function nextFace():HullFace
        {
            for (var level:int = LEVELS - 1; level >= 0; level--)
            {
                var faces:Vector.<HullFace> = _pending[level];
                while (faces.length > 0 && faces[faces.length - 1].state == HullFace.BURIED)
                {
                    faces.pop();
                }
                if (faces.length > 0)
                {
                    return faces[faces.length - 1];
                }
            }
            return null;
        }

        /** Adds faces that have received all of their points to the stacks. */
        public function addPending(faces:Vector.<HullFace>):void
        {
            for each (var face:HullFace in faces)
            {
                if (face.farthest >= 0)
                {
                    var level:int = 0;
                    for (var distance:Number = face.farthestDistance; distance > 1; distance /= 2)
                    {
                        level++;
                    }
                    _pending[level].push(face);
                }
            }
        }

        /**
         * Redistributes the lists of some faces to others.
         *
         * @param from the faces that a new vertex has buried
         * @param to the faces that receive the points. Their third corner is the new vertex, which is on no list any more
         * @return the number of points
         */
        public function redistribute(from:Vector.<HullFace>, to:Vector.<HullFace>):int
        {
            var count:int = 0;
            var vertex:int = to[0].c;
            for each (var face:HullFace in from)
            {
                for (var point:int = face.firstOutside; point >= 0; point = next)
                {
                    var next:int = _next[point];
                    if (point != vertex)
                    {
                        assign(point, to);
                    }
                    count++;
                }
            }
            addPending(to);
            return count;
        }

        /**
         * Puts a point on the list of a face that it lies beyond. If it lies beyond none of the faces, it is inside of the hull from now
         * on. A point that is at most HULL_COPLANAR above a face is left out like one inside, if it is over the face or at most as far beside it.
         */
        public function assign(point:int, faces:Vector.<HullFace>):void
        {
            var x:Number = _points[3 * point];
            var y:Number = _points[3 * point + 1];
            var z:Number = _points[3 * point + 2];
            var count:int = faces.length;
            var nearFace:HullFace = null;
            var near:Number = 0;
            for (var i:int = 0; i < count; i++)
            {
                var face:HullFace = faces[i];
                var distance:Number = face.normalX * x + face.normalY * y + face.normalZ * z - face.offset;
                if (distance > Tolerances.HULL_COPLANAR)
                {
                    addTo(face, point, distance);
                    return;
                }
                if (distance > Tolerances.HULL_CERTAIN)
                {
                    if (face.isOver(_points, x, y, z))
                    {
                        return;
                    }
                    nearFace = face;
                    near = distance;
                }
            }
            if (nearFace != null)
            {
                addTo(nearFace, point, near);
            }
        }

        // Adds a point to the list of a face.
        private function addTo(face:HullFace, point:int, distance:Number):void
        {
            _next[point] = face.firstOutside;
            face.firstOutside = point;
            if (distance > face.farthestDistance + Tolerances.HULL_CERTAIN)
            {
                face.farthestDistance = distance;
                face.farthest = point;
            }
            else if (distance >= face.farthestDistance - Tolerances.HULL_CERTAIN && squaredFromMiddle(point) > squaredFromMiddle(face.farthest))
            {
                // If several points are equally far, they are on a side parallel to the face. Then the outermost one is taken.
                face.farthest = point;
            }
        }

        // The squared distance from the grid's middle.
        private function squaredFromMiddle(point:int):Number
        {
            var x:Number = _points[3 * point] - QuickHull.GRID / 2;
            var y:Number = _points[3 * point + 1] - QuickHull.GRID / 2;
            var z:Number = _points[3 * point + 2] - QuickHull.GRID / 2;
            return x * x + y * y + z * z;
        }
    }
}
