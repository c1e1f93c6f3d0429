package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.BoxTree;
    import starlogo.intersection.TriangleKernel;
    import starlogo.solid.ModelTree;

    use namespace engine;

    /**
     * Finds the pairs of a placed model's convex pieces and the triangles of the ground's surface near each. The model is a structure or a tree.
     *
     * <p>A structure is one piece. The pieces of a tree are its nodes at the depth limit, or its triangles. A node above them that the
     * surface does not come near is a piece without triangles, in place of all pieces below it.</p>
     *
     * <p><code>begin()</code> or <code>beginWhole()</code> comes first. Then <code>next()</code> goes through the pairs. If the pieces count too,
     * <code>nextPiece()</code> goes through them, and <code>nextTriangle()</code> through the triangles near the current one.</p>
     */
    internal final class PieceTrianglePairs
    {
        // In the list of nodes: the structure around the whole model.
        private static const WHOLE:int = -1;

        /** Decides about the current piece and triangles. Both are relative to the origin. */
        public var kernel:TriangleKernel = new TriangleKernel();

        /** Says on which side of the current triangle the current piece is. */
        public var side:TriangleSide;

        /**
         * The search for triangles near the current piece. Its box is around the piece or, for a triangle of a tree, around its node. Its limits may be
         * narrowed; all else is read only. Its origin is the place that the model was set to.
         */
        public var search:GroundSearch = new GroundSearch();

        private var _triangles:GroundTriangles = new GroundTriangles();

        private var _tree:ModelTree;
        private var _structure:BoundingStructure;
        private var _depth:int;
        private var _isExact:Boolean;

        // The model's placement where it is tested, relative to the origin.
        private var _relative:Placement = new Placement();

        // What is still to be visited: nodes, and their number; and a range of the tree's triangles.
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _nodeCount:int = 0;
        private var _first:int = 0;
        private var _end:int = 0;

        // A point of the current piece, and the ground there.
        private var _point:Vector3D = new Vector3D();
        private var _ground:GroundPoint = new GroundPoint();

        // The margin for the model's place and surface, and the margin of the current piece, to which each triangle adds its own.
        private var _margin:Number = 0;
        private var _pieceMargin:Number = 0;

        private var _node:Box = BoxTree.newBox();
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        public function PieceTrianglePairs()
        {
            side = new TriangleSide(kernel.shape);
        }

        /** Sets the model and the ground, as <code>GroundModelQuery.setTo()</code> takes them. */
        public function setTo(grid:HeightGrid, tree:ModelTree, structure:BoundingStructure, placement:Placement, depth:int, exact:Boolean):void
        {
            search.grid = grid;
            search.origin.x = placement.x;
            search.origin.y = placement.y;
            search.origin.z = placement.z;
            _tree = tree;
            _structure = structure;
            _isExact = hasTree && exact && tree.hasTriangles;
            _depth = _isExact ? BoxTree.EXACT : depth;
            // Touching.marginOfPlace(), twice: as if another agent stood at the place of the touch. It is written out because V8 makes objects for
            // Numbers that are passed.
            _margin = 2 * Tolerances.PLACES * (Math.abs(placement.x) + Math.abs(placement.y) + Math.abs(placement.z));
            if (_isExact)
            {
                _margin += Touching.marginOfSurface(tree.boxTree.radius * placement.size);
            }
            _relative.copyFrom(placement);
            moveModelTo(RelativeMotion.NONE, 0);
        }

        /** Whether the model is a tree; otherwise it is a structure. */
        public function get hasTree():Boolean
        {
            return _tree != null;
        }

        /** The current triangle of the ground. Read only. */
        public function get triangle():GroundTriangle
        {
            return _triangles.triangle;
        }

        /** Moves the model to where a motion has brought it at a time. Then a search begins. */
        public function moveModelTo(motion:RelativeMotion, time:Number):void
        {
            _relative.x = motion.startX + time * motion.x;
            _relative.y = motion.startY + time * motion.y;
            _relative.z = motion.startZ + time * motion.z;
        }

        /**
         * Begins with all pieces.
         *
         * @param motion of the pieces from where they are: triangles that they may meet until its latest time count
         * @param maxDistance triangles count that are at most this far away
         */
        public function begin(motion:RelativeMotion, maxDistance:Number):void
        {
            beginAt(hasTree ? 0 : WHOLE, motion, maxDistance);
        }

        /** Begins with the structure around the whole model as the only piece. It stands. */
        public function beginWhole(maxDistance:Number):void
        {
            beginAt(WHOLE, RelativeMotion.NONE, maxDistance);
        }

        // Begins with a node as all that is to be visited.
        private function beginAt(node:int, motion:RelativeMotion, maxDistance:Number):void
        {
            _triangles.stop();
            _first = _end = 0;
            _nodes[0] = node;
            _nodeCount = 1;
            search.motion = motion;
            search.latest = motion.latest;
            search.maxDistance = maxDistance;
            search.minHeight = -Infinity;
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
            while (_first == _end)
            {
                if (_nodeCount == 0)
                {
                    return false;
                }
                _nodeCount--;
                if (visit(_nodes[_nodeCount]))
                {
                    return true;
                }
            }
            kernel.setShapeToTriangle(_tree.mesh.corners, 9 * _first, _relative);
            _first++;
            takeShape();
            return true;
        }

        /** Finds only those triangles from now on that are at a point of the ground, in place of those near the current piece. */
        public function narrowTo(at:GroundPoint):void
        {
            var box:GroundBox = search.box;
            var origin:Placement = search.origin;
            box.x = at.x - origin.x;
            box.y = at.y - origin.y;
            box.z = at.height - origin.z;
            box.halfX = box.halfY = box.halfZ = 0;
            search.shape = null;
            _triangles.begin(search);
        }

        /** Goes on to the next triangle near the piece. Returns false if there is none. */
        public function nextTriangle():Boolean
        {
            if (!_triangles.next())
            {
                return false;
            }
            kernel.shape.margin = _pieceMargin + triangle.margin;
            side.setTriangle(triangle.corners);
            return true;
        }

        /** Whether a point of the piece is at least this deep under the ground. */
        public function isUnder(depth:Number):Boolean
        {
            var at:Placement = search.origin;
            _ground.x = _point.x + at.x;
            _ground.y = _point.y + at.y;
            search.grid.findHeight(_ground);
            return _ground.height - depth >= _point.z + at.z;
        }

        /** The box around the whole model. It is valid until the next search. */
        public function wholeBox():GroundBox
        {
            fitBoxTo(_structure);
            return search.box;
        }

        /** Moves a contact of the piece and the triangle into the world. */
        public function moveToWorld(contact:ContactPoint):void
        {
            contact.x += search.origin.x;
            contact.y += search.origin.y;
            contact.z += search.origin.z;
        }

        // Visits a node: it becomes the piece, or its triangles or its children are visited next. Returns whether it is the piece.
        private function visit(node:int):Boolean
        {
            if (node == WHOLE)
            {
                takeStructure(_structure);
                return true;
            }
            var tree:BoxTree = _tree.boxTree;
            var isDivided:Boolean = tree.endsUpToDepth[node] < _depth;
            tree.writeBox(node, _node);
            if (!isDivided && !_isExact)
            {
                takeStructure(_node);
                return true;
            }
            search.shape = null;
            fitBoxTo(_node);
            if (!isDivided)
            {
                _first = tree.first[node];
                _end = tree.end[node];
                return false;
            }
            _triangles.begin(search);
            if (_triangles.next())
            {
                _nodes[_nodeCount++] = tree.left[node] + 1;
                _nodes[_nodeCount++] = tree.left[node];
                return false;
            }
            _point.setTo(search.box.x, search.box.y, search.box.z);
            return true;
        }

        // Makes a structure of the model the piece.
        private function takeStructure(structure:BoundingStructure):void
        {
            kernel.setStructure(structure, _relative);
            fitBoxTo(structure);
            search.shape = kernel.shape;
            takeShape();
        }

        // Makes the kernel's shape the piece, and begins the search for the triangles near it. The search's box is set.
        private function takeShape():void
        {
            _pieceMargin = kernel.shape.margin + _margin;
            _point.x = kernel.shape.x;
            _point.y = kernel.shape.y;
            _point.z = kernel.shape.z;
            _triangles.begin(search);
        }

        // Puts the search's box around a structure of the model.
        private function fitBoxTo(structure:BoundingStructure):void
        {
            var box:GroundBox = search.box;
            structure.rotatedBoxInto(_relative, _extents);
            box.x = _extents[0] + _relative.x;
            box.y = _extents[1] + _relative.y;
            box.z = _extents[2] + _relative.z;
            box.halfX = _extents[3] + _margin;
            box.halfY = _extents[4] + _margin;
            box.halfZ = _extents[5] + _margin;
        }
    }
}
