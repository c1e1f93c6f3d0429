package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.placePoints;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.BoxTree;
    import starlogo.intersection.TriangleKernel;
    import starlogo.solid.ModelTree;

    use namespace engine;

    /**
     * Goes through the convex pieces of a placed model, one after the other. A structure is one piece. The smallest pieces of a tree are its nodes at
     * the depth limit, or its triangles.
     *
     * <p>Before these come the nodes above them, the inner nodes. Only after <code>divide()</code> does <code>next()</code> go on to the pieces inside of
     * one.</p>
     */
    internal final class ModelPieces
    {
        /** A kind of piece: the structure that represents the model. */
        public static const STRUCTURE:int = 0;

        /** A kind of piece: the box of a node at the depth limit. */
        public static const NODE_BOX:int = 1;

        /** A kind of piece: a triangle of the model. */
        public static const TRIANGLE:int = 2;

        /** A kind of piece: a node above the smallest pieces. It can be divided. */
        public static const INNER_NODE:int = 3;

        /** The kind of the current piece. Read only. */
        public var kind:int = STRUCTURE;

        /** Tests the current piece, which is the kernel's shape, with a triangle of the ground. For an inner node the shape is still an earlier piece. */
        public var kernel:TriangleKernel = new TriangleKernel();

        /** The margin of the current piece, with the margins of the model's place and surface. Read only. */
        public var shapeMargin:Number = 0;

        /**
         * The box around the current piece, relative to the origin. If the piece is a triangle, it is around the node of the triangle. After
         * <code>findWholeBox()</code> it is around the whole model. Read only.
         */
        public var box:GroundBox = new GroundBox();

        /** The corners of the current piece if it is a triangle, relative to the origin. Read only. */
        public var corners:Vector.<Number> = new Vector.<Number>(9, true);

        /** A point of the current piece; the middle of the box of an inner node. Read only. */
        public var point:Vector3D = new Vector3D();

        /** The part of a list that the caller has for the current piece: what it gave <code>divide()</code>; 0 and 0 for the first piece. Read only. */
        public var listBegin:int = 0;
        public var listEnd:int = 0;

        private var _tree:BoxTree;
        private var _structure:BoundingStructure;

        // How many levels of the tree are visited; EXACT if the pieces are triangles.
        private var _depth:int;

        // The model's placement, relative to the origin, and the margin for its place and surface.
        private var _placement:Placement = new Placement();
        private var _modelMargin:Number = 0;

        // What comes next: a range of the tree's triangles, then nodes from the last one on. Each has three numbers: the node, and where its part of the
        // caller's list begins and ends. Behind these is the current node.
        private var _nextTriangle:int = 0;
        private var _trianglesEnd:int = 0;
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _nodesEnd:int = 0;

        // The middle and the half lengths of a box, relative to the model's place.
        private var _middleAndHalves:Vector.<Number> = new Vector.<Number>(6, true);

        /** Sets the model, as <code>GroundModelQuery.setTo()</code> takes it. The origin is the place of the placement. */
        public function setTo(tree:ModelTree, structure:BoundingStructure, placement:Placement, depth:int):void
        {
            _tree = tree == null ? null : tree.treeFor(depth);
            _structure = structure;
            _depth = depth;
            // twice, as if another agent stood at the place of the touch
            _modelMargin = 2 * Touching.marginOfPlace(placement.x, placement.y, placement.z);
            if (_depth == BoxTree.EXACT)
            {
                _modelMargin += Touching.marginOfSurface(_tree.boundingRadius * placement.size);
            }
            _placement.copyFrom(placement);
            moveTo(RelativeMotion.NONE, 0);
        }

        /** Moves the model to where a motion has brought it at a time. */
        public function moveTo(motion:RelativeMotion, time:Number):void
        {
            _placement.x = motion.startX + time * motion.x;
            _placement.y = motion.startY + time * motion.y;
            _placement.z = motion.startZ + time * motion.z;
        }

        /** Begins. Then <code>next()</code> goes on to the first piece. */
        public function begin():void
        {
            _nextTriangle = _trianglesEnd = 0;
            _nodesEnd = 0;
            push(0, 0, 0);
        }

        /** Goes on to the next piece. Returns false if there is none. */
        public function next():Boolean
        {
            if (_nextTriangle < _trianglesEnd)
            {
                enterTriangle();
                return true;
            }
            if (_nodesEnd == 0)
            {
                return false;
            }
            _nodesEnd -= 3;
            listBegin = _nodes[int(_nodesEnd + 1)];
            listEnd = _nodes[int(_nodesEnd + 2)];
            if (_tree == null)
            {
                enterStructure(_structure, STRUCTURE);
            }
            else
            {
                enterNode(_nodes[_nodesEnd]);
            }
            return true;
        }

        /**
         * Divides the current piece, an inner node: the pieces inside of it come next. The lower one of two nodes comes first, because the ground is below.
         *
         * @param listBegin where the part of the caller's list begins that is for the pieces inside of it
         * @param listEnd where it ends
         */
        public function divide(listBegin:int, listEnd:int):void
        {
            var node:int = _nodes[_nodesEnd];
            var left:int = _tree.left[node];
            if (left == 0)
            {
                _nextTriangle = _tree.firstPrimitive[node];
                _trianglesEnd = _tree.endPrimitive[node];
                this.listBegin = listBegin;
                this.listEnd = listEnd;
                return;
            }
            var lower:int = heightOf(left) < heightOf(left + 1) ? left : left + 1;
            push(left + left + 1 - lower, listBegin, listEnd);
            push(lower, listBegin, listEnd);
        }

        // Puts a node on the stack.
        private function push(node:int, listBegin:int, listEnd:int):void
        {
            _nodes[_nodesEnd] = node;
            _nodes[int(_nodesEnd + 1)] = listBegin;
            _nodes[int(_nodesEnd + 2)] = listEnd;
            _nodesEnd += 3;
        }

        // How high the middle of a node is, as a multiple of the model's size.
        private function heightOf(node:int):Number
        {
            var boxes:Vector.<Number> = _tree.boxes;
            var at:int = 6 * node;
            return _placement.r20 * boxes[at] + _placement.r21 * boxes[int(at + 1)] + _placement.r22 * boxes[int(at + 2)];
        }

        /** Whether the piece is a structure or a node's box. Then <code>box</code> is around the kernel's shape. */
        public function get hasShapeInBox():Boolean
        {
            return kind <= NODE_BOX;
        }

        /** Finds the box around the whole model, where it stands now. There is no current piece then. */
        public function findWholeBox():void
        {
            findBoxAround(_structure, box);
        }

        // Makes the next triangle the current piece.
        private function enterTriangle():void
        {
            _tree.readTriangle(_nextTriangle, corners);
            placePoints(_placement, corners, 0, 9, corners);
            _nextTriangle++;
            kind = TRIANGLE;
            point.x = corners[0];
            point.y = corners[1];
            point.z = corners[2];
            shapeMargin = _modelMargin;
            kernel.shape.setTriangle(corners, 0);
        }

        // Makes a node the current piece.
        private function enterNode(node:int):void
        {
            if (_depth != BoxTree.EXACT && _tree.leafUpToDepth[node] >= _depth)
            {
                enterStructure(_tree.boxOf(node), NODE_BOX);
                return;
            }
            kind = INNER_NODE;
            findBoxAround(_tree.boxOf(node), box);
            point.x = box.x;
            point.y = box.y;
            point.z = box.z;
        }

        // Makes a structure of the model the current piece.
        private function enterStructure(structure:BoundingStructure, kind:int):void
        {
            var shape:ConvexShape = kernel.shape;
            this.kind = kind;
            findBoxAround(structure, box);
            kernel.setStructure(structure, _placement);
            shape.margin += _modelMargin;
            shapeMargin = shape.margin;
            point.copyFrom(shape.origin);
        }

        // Finds the box around a structure of the model.
        private function findBoxAround(structure:BoundingStructure, out:GroundBox):void
        {
            structure.findPlacedBox(_placement, _middleAndHalves);
            out.x = _middleAndHalves[0] + _placement.x;
            out.y = _middleAndHalves[1] + _placement.y;
            out.z = _middleAndHalves[2] + _placement.z;
            out.halfX = _middleAndHalves[3] + _modelMargin;
            out.halfY = _middleAndHalves[4] + _modelMargin;
            out.halfZ = _middleAndHalves[5] + _modelMargin;
        }
    }
}
