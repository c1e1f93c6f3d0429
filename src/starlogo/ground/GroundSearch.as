package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.intersection.ConvexTriangle;
    import starlogo.solid.SolidHierarchy;

    use namespace engine;

    /**
     * Goes through the pairs of a convex piece of a placed model and a triangle of the ground's surface near it, for what TerrainPair asks. The
     * model is a structure or a tree.
     *
     * <p>A piece is a structure or a triangle. Nodes at the depth limit are pieces. Nodes that are divided only say, by their boxes, whether the
     * surface is near.</p>
     */
    internal class GroundSearch
    {
        protected var _tree:SolidHierarchy;
        protected var _structure:BoundingStructure;
        private var _depth:int;
        private var _isExact:Boolean;

        // The triangles' corners if they decide. Their first reader prepares them, which changes the nodes below the thesis's leaves. So they are
        // read before a search begins.
        private var _corners:Vector.<Number> = null;

        // Where the model stands at the current time, relative to the origin of _faces, which is its place.
        protected var _placed:Placement = new Placement();

        // The current piece and the triangles near it. The nodes that are still to be visited, and their number. The triangles of the last node
        // that are still to be tested.
        protected var _piece:ConvexTriangle = new ConvexTriangle();
        protected var _faces:GroundTriangles = new GroundTriangles();
        private var _nodes:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _nodeCount:int = 0;
        private var _triangle:int = 0;
        private var _end:int = 0;

        // If _under is not NaN, the search ends at a piece with a point at least this deep under the ground. _isUnder says whether it found such a
        // piece. _point is the point of the last piece, or null.
        protected var _under:Number = NaN;
        protected var _isUnder:Boolean = false;
        protected var _point:Vector3D = null;

        // The margin of the model's place and surface, the margin of the current piece without that of a triangle, and the piece's origin.
        private var _margin:Number = 0;
        private var _pieceMargin:Number = 0;
        private var _pieceOrigin:Vector3D = new Vector3D();

        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        /**
         * Sets the model and the ground.
         *
         * @param grid the ground
         * @param tree the model's hierarchy; null if a structure represents it
         * @param structure the structure, or the one around the tree, in the model's space
         * @param placement where the model stands
         * @param depth how many levels of the tree are visited
         * @param exact whether triangles decide in place of depths, if the tree has triangles
         */
        public function setTo(grid:HeightGrid, tree:SolidHierarchy, structure:BoundingStructure, placement:Placement, depth:int, exact:Boolean):void
        {
            _faces.grid = grid;
            _tree = tree;
            _structure = structure;
            _placed.copyFrom(placement);
            _faces.origin.x = placement.x;
            _faces.origin.y = placement.y;
            _faces.origin.z = placement.z;
            _isExact = tree != null && exact && tree.hasTriangles;
            _depth = _isExact ? int.MAX_VALUE : depth;
            // The margin is as large as if another agent stood at the place of the touch.
            _margin = 2 * Touching.marginOfPlace(placement.x, placement.y, placement.z);
            if (_isExact)
            {
                _margin += Touching.marginOfSurface(tree.root.radius * placement.size / 2);
            }
            placeAt(RelativeMotion.NONE, 0);
        }

        // Moves the model to where the motion has brought it at a time.
        protected function placeAt(motion:RelativeMotion, time:Number):void
        {
            _placed.x = motion.startX + time * motion.x;
            _placed.y = motion.startY + time * motion.y;
            _placed.z = motion.startZ + time * motion.z;
        }

        // Begins with the pieces of a tree, or with the structure as the only piece. Triangles count that are near a piece on its way, or as far
        // away as the reach.
        protected function begin(tree:SolidHierarchy, motion:RelativeMotion, reach:Number):void
        {
            stop();
            _faces.way = motion;
            _faces.limit = 1;
            _faces.reach = reach;
            if (tree == null)
            {
                beginPiece(_structure);
            }
            else
            {
                _corners = _isExact ? tree.corners : null;
                addNode(tree.root);
            }
        }

        // Goes on to the next pair. Returns false if there is none.
        protected function next():Boolean
        {
            while (!_faces.next())
            {
                if (_under >= 0 && _point != null && isPointUnder())
                {
                    _isUnder = true;
                    return false;
                }
                if (_triangle < _end)
                {
                    _piece.beginTriangle(_corners, 9 * _triangle, _placed);
                    _pieceMargin = _piece.shape.margin + _margin;
                    _triangle++;
                    beginFaces(_box, pointOfPiece());
                }
                else if (_nodeCount > 0)
                {
                    _nodeCount--;
                    visit(_nodes[_nodeCount]);
                }
                else
                {
                    return false;
                }
            }
            _piece.shape.margin = _pieceMargin + _faces.gap;
            _piece.setTriangle(_faces.corners, 0);
            return true;
        }

        private function isPointUnder():Boolean
        {
            _faces.grid.atX = _point.x + _faces.origin.x;
            _faces.grid.atY = _point.y + _faces.origin.y;
            _faces.grid.findHeight();
            return _faces.grid.height - _under >= _point.z + _faces.origin.z;
        }

        // Ends the search.
        protected function stop():void
        {
            _faces.stop();
            _faces.above = -Infinity;
            _nodeCount = _triangle = _end = 0;
            _under = NaN;
            _isUnder = false;
            _point = null;
        }

        private function addNode(node:HierarchyNode):void
        {
            _nodes[_nodeCount] = node;
            _nodeCount++;
        }

        private function visit(node:HierarchyNode):void
        {
            node.writeBox(_box);
            if (node.goesBelow(_depth))
            {
                beginFaces(_box, _faces.middle);
                if (_faces.next())
                {
                    _faces.stop();
                    _point = null;
                    addNode(node.high);
                    addNode(node.low);
                }
            }
            else if (_isExact)
            {
                _triangle = node.first;
                _end = node.end;
                _point = null;
            }
            else
            {
                beginPiece(_box);
            }
        }

        protected function setPiece(structure:BoundingStructure):void
        {
            _piece.begin(structure, _placed);
            _pieceMargin = _piece.shape.margin + _margin;
        }

        private function beginPiece(structure:BoundingStructure):void
        {
            setPiece(structure);
            beginFaces(structure, pointOfPiece(), _piece.structure);
        }

        // Returns a point of the current piece.
        private function pointOfPiece():Vector3D
        {
            _pieceOrigin.x = _piece.shape.x;
            _pieceOrigin.y = _piece.shape.y;
            _pieceOrigin.z = _piece.shape.z;
            return _pieceOrigin;
        }

        // Begins with the triangles near the box around a structure of the model. The point is one of the piece. If it is a structure in the
        // world, it is given too.
        private function beginFaces(structure:BoundingStructure, point:Vector3D, piece:BoundingStructure = null):void
        {
            _point = point;
            placeBox(structure);
            _faces.structure = piece;
            _faces.begin();
        }

        // Puts the box around a structure of the model.
        protected function placeBox(structure:BoundingStructure):void
        {
            var middle:Vector3D = _faces.middle;
            var half:Vector3D = _faces.half;
            structure.rotatedExtentsInto(_placed, _extents);
            middle.x = _extents[0] + _placed.x;
            middle.y = _extents[1] + _placed.y;
            middle.z = _extents[2] + _placed.z;
            half.x = _extents[3] + _margin;
            half.y = _extents[4] + _margin;
            half.z = _extents[5] + _margin;
        }
    }
}
