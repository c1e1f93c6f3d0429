package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;
    import starlogo.intersection.TriangleKernel;
    import starlogo.solid.ModelTree;

    use namespace engine;

    /**
     * Tests a placed model against the ground: whether the two overlap, when and how they first touch, and how far they are apart. The model is
     * a structure or a tree.
     *
     * <p>A connected piece that does not touch the ground's surface is wholly under the ground or wholly outside of it, so one point decides.
     * First, each convex piece is tested against the triangles of the surface near it. Then a point of the piece is tested.</p>
     *
     * <p>Answers are nested, because a node's piece contains the pieces and the triangles of all its
     * descendants.</p>
     *
     * @private
     */
    public final class GroundQuery
    {
        // Two exits have nearly the same direction if the cosine of their angle is larger.
        private static const SAME_EXIT:Number = 0.98;

        // The triangle of a contact counts as behind a plane if it is in front of it by at most this many margins of the plane's triangle, which are rounding.
        private static const IN_FRONT:Number = 10;

        // The most exits that are found.
        private static const MOST_EXITS:int = 12;

        // A contact is taken at once if the least length of an exit is at least this fraction of its depth.
        private static const NEEDED:Number = 0.8;

        private var _grid:HeightGrid;
        private var _hasTree:Boolean = false;
        private var _pieces:GroundPieces = new GroundPieces();

        // The parts of _pieces that are read all the time.
        private var _piece:TriangleKernel = _pieces.piece;
        private var _box:GroundBox = _pieces.box;
        private var _triangles:GroundTriangles = _pieces.triangles;

        // The contact with the last triangle that was tried.
        private var _tried:ContactPoint = new ContactPoint();

        // The triangle of the ground that the model was deepest in at the last contact, and whether there was one: a first touch may be at an edge of
        // several. The triangle is relative to where the model stood, and the model has come from there by a vector.
        private var _touched:Vector.<Number> = new Vector.<Number>(9, true);
        private var _hasTouched:Boolean = false;
        private var _touchedFrom:Vector3D = new Vector3D();
        private var _come:Vector3D = new Vector3D();

        // The motion of the search for the first touch; bounds of the ground's heights; and the search for the closest points.
        private var _sweep:RelativeMotion = new RelativeMotion();
        private var _range:HeightRange = new HeightRange();
        private var _distance:GroundDistanceQuery = new GroundDistanceQuery(_pieces);

        /**
         * Sets the model and the ground.
         *
         * @param grid the ground
         * @param tree the model's tree; null if a structure represents it
         * @param structure the structure, or the one around the tree, in the model's space
         * @param placement where the model stands
         * @param depth how many levels of the tree are visited
         * @param exact whether triangles decide in place of depths, if the tree has triangles
         */
        public function setTo(grid:HeightGrid, tree:ModelTree, structure:BoundingStructure, placement:Placement, depth:int, exact:Boolean):void
        {
            _grid = grid;
            _hasTree = tree != null;
            _pieces.setTo(grid, tree, structure, placement, depth, exact);
        }

        /** Whether a piece of the model overlaps the surface by more than a depth, or a point of it is as deep under the ground. */
        public function isDeeper(depth:Number):Boolean
        {
            _pieces.begin(RelativeMotion.NONE, 0);
            while (_pieces.nextPiece())
            {
                var isApart:Boolean = true;
                while (_pieces.nextTriangle())
                {
                    if (findOverlap())
                    {
                        if (_tried.depth > depth)
                        {
                            return true;
                        }
                        isApart = false;
                    }
                }
                // the point of a flat piece of a tree may be on the surface
                if ((isApart || !_hasTree) && _pieces.isUnder(depth))
                {
                    return true;
                }
            }
            return false;
        }

        /**
         * Finds the first moment at which the two overlap while the model moves, and the contact then.
         *
         * @param motion of the model; takes the time, from 0 to 1, or RelativeMotion.NEVER
         * @param out receives the contact, with a normal that points out of the ground; null if only the time is needed
         */
        public function findFirst(motion:RelativeMotion, out:ContactPoint):void
        {
            var touching:Number = 0;
            if (!overlapsAt(motion, 0))
            {
                findImpact(motion, out);
                if (motion.time != RelativeMotion.NEVER)
                {
                    return;
                }
                // rounding can miss a touch at the end of the motion
                touching = overlapsAt(motion, 1) ? 1 : RelativeMotion.NEVER;
            }
            motion.time = touching;
            if (out != null && touching != RelativeMotion.NEVER)
            {
                findContact(motion, out);
            }
        }

        /**
         * Finds when the model first touches the surface as it moves, and how.
         *
         * @param motion of the model; takes the time, from 0 to 1, or RelativeMotion.NEVER
         * @param out receives the contact, with a normal that points out of the ground; null if only the time is needed. Then the last contact stays
         *     the one that <code>findExits()</code> goes by
         */
        public function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            _hasTouched &&= out == null;
            var first:Number = RelativeMotion.NEVER;
            _sweep.x = motion.x;
            _sweep.y = motion.y;
            _sweep.z = motion.z;
            _pieces.placeAt(motion, 0);
            _pieces.begin(motion, 0);
            while (first > 0 && _pieces.nextPiece())
            {
                while (first > 0 && _pieces.nextTriangle())
                {
                    findTime();
                    if (_sweep.time < first)
                    {
                        first = _box.latest = _sweep.time;
                        if (out != null)
                        {
                            _piece.findContact(_sweep, out);
                            _piece.leadOutside(_sweep, out);
                        }
                    }
                }
            }
            motion.time = first;
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                setBounds(out, 0, false);
                moveToWorld(out);
            }
        }

        /**
         * Finds the contact of the model and the ground, which overlap at the motion's time. If the moving model first touches the surface
         * then, it is the contact of this touch. Otherwise it is the contact of the deepest piece, where the model stands then. If the model is
         * wholly under the ground, the contact lifts it up.
         *
         * @param out receives the contact, with a normal that points out of the ground
         */
        public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            var time:Number = motion.time;
            _hasTouched = false;
            if (motion.x != 0 || motion.y != 0 || motion.z != 0)
            {
                findImpact(motion, out);
                var isSame:Boolean = motion.time <= time + Tolerances.SAME_TIME;
                motion.time = time;
                if (isSame)
                {
                    return;
                }
            }
            _pieces.placeAt(motion, time);
            findDeepestPoint(out);
            // a point of the model is that deep behind a triangle
            var isSure:Boolean = _hasTouched;
            if (!_hasTouched)
            {
                findDeepestOverlap(out);
            }
            if (_hasTouched)
            {
                setBounds(out, isSure || isNeeded(out) ? out.depth : 0, isSure);
                moveToWorld(out);
            }
            else
            {
                findOuterContact(out);
            }
        }

        /**
         * Finds the planes of triangles that the standing structure around the model is behind: of planes with nearly the same direction, the one
         * that it is least behind. The last contact has to be of the same two. If the model was deepest in a triangle of the ground then, and
         * did not first touch it, only planes that this triangle is not in front of count.
         *
         * @param maxDistance how far away triangles may be
         * @param exits receives the contacts that lead out of the planes
         * @return their number
         */
        public function findExits(maxDistance:Number, exits:Vector.<ContactPoint>):int
        {
            var count:int = 0;
            _pieces.beginWhole(RelativeMotion.NONE, maxDistance);
            _pieces.nextPiece();
            while (_pieces.nextTriangle())
            {
                _piece.findBehind(RelativeMotion.NONE, _tried);
                if (_tried.depth >= -_triangles.margin && (!_hasTouched || isTouchedBehind()))
                {
                    count = addExit(exits, count);
                }
            }
            for (var i:int = 0; i < count; i++)
            {
                moveToWorld(exits[i]);
            }
            return count;
        }

        /** Finds the contact that lifts the model from its lowest place above all ground under it. */
        public function findOuterContact(out:ContactPoint):void
        {
            setBounds(out, 0, false);
            _pieces.placeBox();
            var low:Number = _box.z - _box.halfZ;
            _grid.findAround(_box.x + _box.origin.x, _box.y + _box.origin.y, _box.halfX, _box.halfY, _range);
            out.setNormal(0, 0, 1);
            out.depth = Math.max(0, _range.greatest - _box.origin.z - low);
            out.x = _box.x;
            out.y = _box.y;
            out.z = low + out.depth / 2;
            moveToWorld(out);
        }

        /**
         * Finds how far the two are apart where the model stands, and between which points.
         *
         * @param areTouching whether they overlap. If so, a point of both is found
         */
        public function findClosest(areTouching:Boolean, out:ClosestPoints):void
        {
            _distance.find(_grid, _hasTree, areTouching, out);
        }

        // Finds the contact with the triangle that the model is deepest behind, of those that the deepest point of a piece is behind. Only depths
        // count that are known to be about as deep in the ground.
        private function findDeepestPoint(out:ContactPoint):void
        {
            var deepest:Number = 0;
            _pieces.begin(RelativeMotion.NONE, 0);
            while (_pieces.nextPiece())
            {
                while (_pieces.nextTriangle())
                {
                    var isFootInside:Boolean = _piece.findBehind(RelativeMotion.NONE, _tried);
                    if (isFootInside && isClearlyDeeper(deepest) && isNeeded(_tried) && isDeeperThan(deepest))
                    {
                        deepest = _box.above = _tried.depth;
                        keep(_tried, out);
                    }
                }
            }
        }

        // Finds the contact with the triangle that the model overlaps most.
        private function findDeepestOverlap(out:ContactPoint):void
        {
            var deepest:Number = 0;
            _pieces.begin(RelativeMotion.NONE, 0);
            while (_pieces.nextPiece())
            {
                while (_pieces.nextTriangle())
                {
                    // no overlap is deeper than the piece is behind the plane
                    _piece.findBehind(RelativeMotion.NONE, _tried);
                    if (isClearlyDeeper(deepest) && findOverlap() && isDeeperThan(deepest))
                    {
                        deepest = _tried.depth;
                        _piece.leadOutside(RelativeMotion.NONE, _tried);
                        keep(_tried, out);
                    }
                }
            }
        }

        // Whether the last contact is deeper than the deepest one so far by more than rounding. NaN counts as deeper.
        private function isClearlyDeeper(deepest:Number):Boolean
        {
            return !(deepest > 0 && _tried.depth < deepest + _triangles.margin);
        }

        // Whether the last contact is deeper than the deepest one so far, or the first one.
        private function isDeeperThan(deepest:Number):Boolean
        {
            return _tried.depth > deepest || _tried.depth == deepest && !_hasTouched;
        }

        // Finds when the moving piece touches the triangle, until the latest time.
        private function findTime():void
        {
            _sweep.latest = _box.latest;
            _sweep.time = RelativeMotion.NEVER;
            if (!_piece.staysBeside(_sweep))
            {
                _piece.findTime(_sweep);
            }
        }

        // Finds the contact of the piece and the triangle, along the shortest way apart. Returns false if they do not touch.
        private function findOverlap():Boolean
        {
            if (!_piece.areTouching())
            {
                return false;
            }
            _piece.findContact(RelativeMotion.NONE, _tried);
            return true;
        }

        // Writes a contact with the current triangle.
        private function keep(contact:ContactPoint, out:ContactPoint):void
        {
            out.copyFrom(contact);
            for (var i:int = 0; i < 9; i++)
            {
                _touched[i] = _triangles.corners[i];
            }
            _hasTouched = true;
            _touchedFrom.setTo(_box.origin.x, _box.origin.y, _box.origin.z);
        }

        // Whether the triangle of the last contact is not in front of the plane of the last exit.
        private function isTouchedBehind():Boolean
        {
            var origin:Placement = _box.origin;
            _come.setTo(origin.x - _touchedFrom.x, origin.y - _touchedFrom.y, origin.z - _touchedFrom.z);
            var rounding:Number = _come.lengthSquared > 0 ? 2 * Touching.marginOfPlace(origin.x, origin.y, origin.z) : 0;
            return _piece.isBehindPlane(_touched, IN_FRONT * _triangles.margin + rounding + _tried.along(_come));
        }

        // Adds the last contact to a number of exits. Of exits with nearly the same direction, the shortest is kept. Returns the new number.
        private function addExit(exits:Vector.<ContactPoint>, count:int):int
        {
            var at:int = 0;
            while (at < count && _tried.normalX * exits[at].normalX + _tried.normalY * exits[at].normalY + _tried.normalZ * exits[at].normalZ <= SAME_EXIT)
            {
                at++;
            }
            if (at == MOST_EXITS)
            {
                return count;
            }
            if (at == exits.length)
            {
                exits[at] = new ContactPoint();
            }
            if (at == count || _tried.depth < exits[at].depth)
            {
                exits[at].copyFrom(_tried);
            }
            return Math.max(count, at + 1);
        }

        // Whether each exit from the ground is at least about as long as a contact is deep, because the piece's deepest point has to get out.
        private function isNeeded(contact:ContactPoint):Boolean
        {
            var depth:Number = contact.depth;
            if (!(depth >= 0))
            {
                return false;
            }
            var x:Number = _box.origin.x + contact.x - depth / 2 * contact.normalX;
            var y:Number = _box.origin.y + contact.y - depth / 2 * contact.normalY;
            var z:Number = _box.origin.z + contact.z - depth / 2 * contact.normalZ;
            return depth == 0 || _grid.leastExit(x, y, z, depth) >= NEEDED * depth;
        }

        /** Whether the two overlap or touch where the motion has brought the model at a time. */
        public function overlapsAt(motion:RelativeMotion, time:Number):Boolean
        {
            _pieces.placeAt(motion, time);
            _pieces.begin(RelativeMotion.NONE, 0);
            while (_pieces.nextPiece())
            {
                if (_pieces.isUnder(0))
                {
                    return true;
                }
                while (_pieces.nextTriangle())
                {
                    if (!_piece.staysBeside(RelativeMotion.NONE) && _piece.areTouching())
                    {
                        return true;
                    }
                }
            }
            return false;
        }

        private static function setBounds(out:ContactPoint, leastDepth:Number, isDepthSure:Boolean):void
        {
            out.leastDepth = leastDepth;
            out.isDepthSure = isDepthSure;
        }

        private function moveToWorld(out:ContactPoint):void
        {
            out.x += _box.origin.x;
            out.y += _box.origin.y;
            out.z += _box.origin.z;
        }
    }
}
