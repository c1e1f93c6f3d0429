package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.TriangleKernel;
    import starlogo.solid.ModelTree;

    /**
     * Finds the pairs of a placed model's convex pieces and the triangles of the ground's surface near each. The model is a structure or a tree.
     * A node of a tree that the surface does not come near is a piece without triangles, in place of all pieces below it.
     *
     * <p>After <code>begin()</code>, <code>next()</code> goes through the pairs. If the pieces count too, <code>nextPiece()</code> goes through them, and
     * <code>nextTriangle()</code> through the triangles near the current one. The limits may be narrowed meanwhile.</p>
     */
    internal final class PieceTrianglePairs
    {
        /** Where a piece is: a point of it is under the ground. */
        public static const UNDER:int = 0;

        /** Where a piece is: that point is not under the ground, but another one is. */
        public static const REACHES_UNDER:int = 1;

        /** Where a piece is: both points are above the ground. Only triangles decide whether the piece touches it. */
        public static const ABOVE:int = 2;

        /** The pieces. A query may move the model before it begins. */
        public var pieces:ModelPieces = new ModelPieces();

        // Finds triangles near the current piece.
        private var _triangles:NearTriangles = new NearTriangles();
        private var _search:GroundSearch = _triangles.search;

        // A place under the piece, and the ground there.
        private var _ground:GroundPoint = new GroundPoint();

        // The direction out of the ground below the current piece, and how far the piece reaches against it; -Infinity if that is not known.
        private var _out:Vector3D = new Vector3D();
        private var _lowest:Number = 0;

        /** Sets the model and the ground, as <code>GroundModelQuery.setTo()</code> takes them. */
        public function setTo(grid:HeightGrid, tree:ModelTree, structure:BoundingStructure, placement:Placement, depth:int, exact:Boolean):void
        {
            _search.grid = grid;
            origin.x = placement.x;
            origin.y = placement.y;
            origin.z = placement.z;
            pieces.setTo(tree, structure, placement, depth, exact);
        }

        /** Decides about the current piece and the current triangle. Both are relative to the origin. Read only. */
        public function get kernel():TriangleKernel
        {
            return pieces.kernel;
        }

        /** The ground. */
        public function get grid():HeightGrid
        {
            return _search.grid;
        }

        /** The place that the model was set to: pieces, triangles and contacts are relative to it. Read only. */
        public function get origin():Placement
        {
            return _search.origin;
        }

        /** The current triangle of the ground. Read only. */
        public function get triangle():GroundTriangle
        {
            return _triangles.triangle;
        }

        /**
         * Begins.
         *
         * @param motion of the pieces from where they are: triangles count that they may meet until its latest time. The motion is copied
         * @param maxDistance triangles count that are at most this far away
         */
        public function begin(motion:RelativeMotion, maxDistance:Number):void
        {
            _triangles.stop();
            pieces.begin();
            _search.motion.copyVector(motion);
            _search.motion.latest = motion.latest;
            _search.maxDistance = maxDistance;
            _triangles.leastDepth = 0;
        }

        /** From now on only triangles count that the pieces may meet until a motion's latest time. */
        public function leaveOutLater(motion:RelativeMotion):void
        {
            _search.motion.latest = motion.latest;
        }

        /** From now on only triangles count that are at most this far away. */
        public function leaveOutFarther(maxDistance:Number):void
        {
            _search.maxDistance = maxDistance;
        }

        /** From now on only triangles count behind whose planes the piece, or its box, is at least this deep. */
        public function leaveOutShallower(depth:Number):void
        {
            _triangles.leastDepth = depth;
        }

        /** Goes on to the next triangle near the piece, or near the next piece that has one. Returns false if there is none. */
        public function next():Boolean
        {
            while (!nextTriangle())
            {
                if (!nextPiece())
                {
                    return false;
                }
            }
            return true;
        }

        /** Goes on to the next piece. Returns false if there is none. */
        public function nextPiece():Boolean
        {
            while (pieces.next())
            {
                _lowest = -Infinity;
                _triangles.begin(pieces.box, pieces.shapeInBox, pieces.nodesLeft);
                if (!pieces.isDivisible || !_triangles.next())
                {
                    return true;
                }
                pieces.divide();
            }
            return false;
        }

        /** Goes on to the next triangle near the piece. Returns false if there is none. */
        public function nextTriangle():Boolean
        {
            if (!_triangles.next())
            {
                return false;
            }
            kernel.shape.margin = pieces.margin + triangle.margin;
            kernel.setTriangle(triangle.corners, triangle.plane);
            return true;
        }

        /** Whether the piece touches a triangle near it. It is quicker after <code>findWhere()</code>. */
        public function touchesTriangle():Boolean
        {
            while (nextTriangle())
            {
                if (!isBelowPiece() && !kernel.stayApart(RelativeMotion.NONE) && kernel.areTouching())
                {
                    return true;
                }
            }
            return false;
        }

        /** Whether a point of the piece is at least this deep under the ground. */
        public function isUnder(depth:Number):Boolean
        {
            _ground.x = pieces.point.x + origin.x;
            _ground.y = pieces.point.y + origin.y;
            grid.findHeight(_ground);
            return _ground.height - depth >= pieces.point.z + origin.z;
        }

        /**
         * Finds where the piece is, as far as two of its points know: UNDER, REACHES_UNDER or ABOVE. The second point is the lowest one above the slope
         * below the first. Nearly all pieces that reach under the ground do so there.
         */
        public function findWhere():int
        {
            if (isUnder(0))
            {
                return UNDER;
            }
            if (pieces.isDivisible)
            {
                return ABOVE;
            }
            var shape:ConvexShape = kernel.shape;
            grid.findDirectionOut(_ground, _out);
            var at:int = shape.support(_out, -1);
            var x:Number = shape.x + shape.points[at] - shape.radius * _out.x;
            var y:Number = shape.y + shape.points[int(at + 1)] - shape.radius * _out.y;
            var z:Number = shape.z + shape.points[int(at + 2)] - shape.radius * _out.z;
            _lowest = x * _out.x + y * _out.y + z * _out.z - Tolerances.EXTENTS * (shape.extent + shape.radius + Math.abs(x) + Math.abs(y) + Math.abs(z));
            _ground.x = x + origin.x;
            _ground.y = y + origin.y;
            grid.findHeight(_ground);
            return _ground.height >= z + origin.z ? REACHES_UNDER : ABOVE;
        }

        /**
         * Whether the triangle is clearly below all of the piece, along the direction out of the ground. This direction is known after
         * <code>findWhere()</code>; before, the answer is false.
         */
        public function isBelowPiece():Boolean
        {
            var p:Vector.<Number> = triangle.corners;
            var most:Number = _lowest - kernel.shape.margin * Tolerances.OUTER;
            return _out.x * p[0] + _out.y * p[1] + _out.z * p[2] < most && _out.x * p[3] + _out.y * p[4] + _out.z * p[5] < most
                && _out.x * p[6] + _out.y * p[7] + _out.z * p[8] < most;
        }

        /** Moves a contact of the piece and the triangle into the world. */
        public function moveToWorld(contact:ContactPoint):void
        {
            contact.x += origin.x;
            contact.y += origin.y;
            contact.z += origin.z;
        }
    }
}
