package starlogo.fitting.hull
{
    import starlogo.fitting.FitSession;
    import starlogo.geometry.hull.ConvexHull;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * The steps that find few corners whose hull is around the convex hull of a session's vertices, up to rounding.
     *
     * <p>Edges of a ProgressiveHull collapse, each time the one for which it grows least. As long as it has many corners, it queues only the shortest
     * edge of each face, and then the shortest edge at each new corner, because short edges cost least. Later it queues all edges. If
     * rounding stops the search, the corners of a box are the result.</p>
     *
     * <p>Vertices in a plane have a polygon instead of a solid hull. The search then takes the double pyramid on the polygon, and both tips
     * stay.</p>
     *
     * @private
     */
    public final class HullSimplification extends StepSequence
    {
        private static const FACES_PER_STEP:int = 200;
        private static const EDGES_PER_STEP:int = 200;

        // With this many times the wanted corners or fewer, all edges are queued.
        private static const FEW:Number = 1.5;

        // How far the tips are from the polygon's plane.
        private static const TIP:Number = 0.5;

        private var _session:FitSession;
        private var _maxCorners:int;
        private var _space:UnitSpace;
        private var _solid:ProgressiveHull = null;
        private var _queue:EdgeQueue = new EdgeQueue();
        private var _collapse:EdgeCollapse = new EdgeCollapse();

        // The first tip is this corner, and the second one the next; -1 if there are none.
        private var _tip:int = -1;

        /**
         * @param session the vertices; their hull may not exist before the first step
         * @param maxCorners the largest number of corners, at least 8
         */
        public function HullSimplification(session:FitSession, maxCorners:int)
        {
            _session = session;
            _maxCorners = maxCorners;
            call(start);
        }

        /** Lists the corners, x, y, z of each. Call it when no step is left. */
        public function listCorners():Vector.<Number>
        {
            if (_solid == null)
            {
                return _session.hull.points;
            }
            return _space.fromUnit(hasMoreThan(_maxCorners) ? UnitSpace.BOX : withoutTips(_solid.listCorners()));
        }

        private function start():void
        {
            var hull:ConvexHull = _session.hull;
            if (hull.dimension < 2 || hull.indices.length <= _maxCorners)
            {
                return;
            }
            _space = new UnitSpace(hull);
            var points:Vector.<Number> = _space.toUnit(hull.points);
            var triangles:Vector.<int> = hull.triangles;
            if (hull.dimension == 2)
            {
                points.push(0, 0, TIP, 0, 0, -TIP);
                _tip = hull.indices.length;
                triangles = pyramidsOn(hull.outline);
            }
            _solid = new ProgressiveHull(points, triangles);
            slices(_solid.faceCount, FACES_PER_STEP, queueShortest).repeat(reduceToFew).begin(queueingAll).repeat(reduceToMaximum);
        }

        private function queueShortest(first:int, end:int):void
        {
            for (var face:int = first; face < end; face++)
            {
                queueEdge(_solid.shortestEdge(face));
            }
        }

        private function queueingAll():Steps
        {
            return new StepSequence().slices(_solid.faceCount, FACES_PER_STEP, function(first:int, end:int):void
                {
                    for (var edge:int = 3 * first; edge < 3 * end; edge++)
                    {
                        queueEdge(edge);
                    }
                });
        }

        // Both take some edges from the queue, and return whether there is more to do.
        private function reduceToFew():Boolean
        {
            for (var i:int = 0; i < EDGES_PER_STEP && canReduceTo(FEW * _maxCorners); i++)
            {
                var face:int = collapseFirst();
                if (face >= 0)
                {
                    queueEdge(_solid.shortestNewEdge(face));
                }
            }
            return canReduceTo(FEW * _maxCorners);
        }

        private function reduceToMaximum():Boolean
        {
            for (var i:int = 0; i < EDGES_PER_STEP && canReduceTo(_maxCorners); i++)
            {
                for (var face:int = collapseFirst(); face >= 0 && face < _solid.faceCount; face++)
                {
                    // the edge to the new corner; the first edge of a new face is where an earlier edge was
                    queueEdge(3 * face + 1);
                }
            }
            return canReduceTo(_maxCorners);
        }

        private function canReduceTo(corners:int):Boolean
        {
            return hasMoreThan(corners) && !_queue.isEmpty;
        }

        private function hasMoreThan(corners:int):Boolean
        {
            return _solid.cornerCount - (_tip < 0 ? 0 : 2) > corners;
        }

        // Takes the first edge of the queue and collapses it. Returns the first new face; -1 if the edge cannot collapse, or if its cost has increased
        // since it was queued: then it is queued again.
        private function collapseFirst():int
        {
            var edge:int = _solid.currentEdge(_queue.pop());
            if (edge < 0 || isQueued(edge) || !_solid.findCollapse(edge, _collapse))
            {
                return -1;
            }
            if (_collapse.growth > _queue.leastCost)
            {
                _queue.push(edge, _collapse.growth);
                return -1;
            }
            return _solid.collapse(_collapse);
        }

        // Queues an edge if it can collapse, unless it is queued already.
        private function queueEdge(edge:int):void
        {
            var mayCollapse:Boolean = _solid.isOnSurface(edge) && !isQueued(edge) && !isTip(_solid.startOf(edge)) && !isTip(_solid.endOf(edge));
            if (mayCollapse && _solid.findCollapse(edge, _collapse))
            {
                _queue.push(edge, _collapse.growth);
            }
        }

        // Whether an edge is queued, or the edge that runs the other way.
        private function isQueued(edge:int):Boolean
        {
            return _queue.has(edge) || _queue.has(_solid.acrossOf(edge));
        }

        private function isTip(corner:int):Boolean
        {
            return _tip >= 0 && (corner == _tip || corner == _tip + 1);
        }

        // The triangles from the edges of a polygon to both tips.
        private function pyramidsOn(outline:Vector.<int>):Vector.<int>
        {
            var triangles:Vector.<int> = new Vector.<int>();
            var last:int = outline[outline.length - 1];
            for each (var corner:int in outline)
            {
                triangles.push(last, corner, _tip, corner, last, _tip + 1);
                last = corner;
            }
            return triangles;
        }

        private function withoutTips(points:Vector.<Number>):Vector.<Number>
        {
            if (_tip < 0)
            {
                return points;
            }
            var found:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < points.length; i += 3)
            {
                if (Math.abs(points[i + 2]) < TIP)
                {
                    found.push(points[i], points[i + 1], 0);
                }
            }
            return found;
        }
    }
}
