package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Touching;

    /**
     * The triangles of the ground near the boxes of a model. Those near a box that comes to few cells are found once, and kept for the boxes inside of
     * it.
     */
    internal final class KeptTriangles
    {
        /** The triangle that <code>next()</code> has found. Read only. */
        public var triangle:GroundTriangle = null;

        private var _search:GroundSearch;
        private var _source:GroundTriangles = new GroundTriangles();

        // The triangles so far, and the next of them. If they are not kept, the first one is overwritten. The list grows during the first searches,
        // up to the triangles of few cells, and its records are used again: later frames allocate nothing.
        private var _found:Vector.<GroundTriangle> = new Vector.<GroundTriangle>();
        private var _count:int = 0;
        private var _next:int = 0;
        private var _areKept:Boolean = false;

        // How many boxes were left when the triangles that are kept were looked for.
        private var _boxesLeft:int = 0;

        // The least and the greatest corner of the box with all of its motion.
        private var _min:Vector3D = new Vector3D();
        private var _max:Vector3D = new Vector3D();

        /** @param search what is looked for, but for its box and shape. Before boxes begin, all of it is set. Then only the limits may be narrowed */
        public function KeptTriangles(search:GroundSearch)
        {
            _search = search;
        }

        /** Ends all searches. */
        public function stop():void
        {
            _areKept = false;
            _count = _next = 0;
            _source.stop();
        }

        /**
         * Begins with a box.
         *
         * @param shape the shape that is tested, if it is in the box; null for none
         * @param boxesLeft how many boxes come after this one and those inside of it
         */
        public function setTo(box:GroundBox, shape:ConvexShape, boxesLeft:int):void
        {
            _next = 0;
            // fewer boxes are left: all inside of the box whose triangles are kept have been
            if (!_areKept || boxesLeft < _boxesLeft)
            {
                _count = 0;
                _boxesLeft = boxesLeft;
                _search.box.copyFrom(box);
                _search.shape = shape;
                _source.begin(_search);
                _areKept = _source.comesToFewCells;
            }
            var motion:RelativeMotion = _search.motion;
            var x:Number = motion.latest * motion.x;
            var y:Number = motion.latest * motion.y;
            var z:Number = motion.latest * motion.z;
            _min.x = box.x - box.halfX + Math.min(0, x);
            _min.y = box.y - box.halfY + Math.min(0, y);
            _min.z = box.z - box.halfZ + Math.min(0, z);
            _max.x = box.x + box.halfX + Math.max(0, x);
            _max.y = box.y + box.halfY + Math.max(0, y);
            _max.z = box.z + box.halfZ + Math.max(0, z);
        }

        /**
         * Goes on to the next triangle near the box: the box comes near the triangle's own box, and is not all in front of its plane. Returns false if
         * there is none.
         */
        public function next():Boolean
        {
            var far:Number = _search.maxDistance;
            var front:Number = far - _search.minDepth + _source.slack;
            while (_next < _count || findMore())
            {
                var near:GroundTriangle = _found[_next];
                _next++;
                if (isApart(_min, near.max, far) || isApart(near.min, _max, far))
                {
                    continue;
                }
                // the corner of the box that is farthest behind the plane
                var normal:Vector3D = near.plane.normal;
                var x:Number = normal.x > 0 ? _min.x : _max.x;
                var y:Number = normal.y > 0 ? _min.y : _max.y;
                var z:Number = normal.z > 0 ? _min.z : _max.z;
                // a flat triangle has no plane
                if (!(normal.x * x + normal.y * y + normal.z * z - near.plane.max > front))
                {
                    triangle = near;
                    return true;
                }
            }
            return false;
        }

        // Whether the least corner of a box is so far beyond the greatest corner of another one that the boxes are farther apart.
        private static function isApart(min:Vector3D, max:Vector3D, far:Number):Boolean
        {
            return min.z - max.z > far || min.x - max.x > far || min.y - max.y > far;
        }

        // Finds one more triangle, and sets what only tests of the model need: its margin and its plane. Returns false if there is none.
        private function findMore():Boolean
        {
            if (!_areKept)
            {
                _count = _next = 0;
            }
            if (_count == _found.length)
            {
                _found.push(new GroundTriangle());
            }
            var found:GroundTriangle = _found[_count];
            if (!_source.next(found))
            {
                return false;
            }
            found.margin = Touching.marginOfSurface(found.radius);
            found.plane.setTriangle(found.corners, 0);
            _count++;
            return true;
        }
    }
}
