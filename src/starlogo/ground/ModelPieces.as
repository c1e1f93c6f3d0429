package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.placePoints;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.BoxTree;
    import starlogo.intersection.TriangleKernel;
    import starlogo.solid.ModelTree;

    use namespace engine;

    /**
     * Goes through the convex pieces of a placed model, one after the other. A structure is one piece. The smallest pieces of a tree are its nodes at
     * the depth limit, or its triangles.
     *
     * <p>Before these come the nodes above them, as divisible pieces. Only after <code>divide()</code> does <code>next()</code> go on to the pieces
     * inside of such a piece.</p>
     */
    internal final class ModelPieces
    {
        // In the list of nodes: the structure around the whole model.
        private static const WHOLE:int = -1;

        /** It decides about a triangle and the current piece, once <code>shape</code> has been read. */
        public var kernel:TriangleKernel = new TriangleKernel();

        /** The margin of the kernel's shape, with the margins of the model's place and surface. Read only. */
        public var shapeMargin:Number = 0;

        /** The box around the current piece; around the node of a triangle that has a list. Relative to the origin. Read only. */
        public var box:GroundBox = new GroundBox();

        /** The kernel's shape if the box is around it, null otherwise. Read only. */
        public var shapeInBox:ConvexShape = null;

        /** Whether the current piece is a node above the smallest pieces. Read only. */
        public var isDivisible:Boolean = false;

        /** The corners of the current piece if it is a triangle, relative to the origin; null otherwise. Read only. */
        public var corners:Vector.<Number> = null;

        /** Where a list of the box around the current piece begins and ends: what <code>divide()</code> was told. Read only. */
        public var listBegin:int = 0;
        public var listEnd:int = 0;

        /** A point of the current piece; the middle of the box of a divisible one. Read only. */
        public var point:Vector3D = new Vector3D();

        private var _tree:ModelTree;
        private var _structure:BoundingStructure;

        // How many levels of the tree are visited; EXACT if the pieces are triangles.
        private var _depth:int;

        // The model's placement, relative to the origin, and the margin for its place and surface.
        private var _placement:Placement = new Placement();
        private var _modelMargin:Number = 0;

        // What comes next: a range of the tree's triangles, then nodes from the last one on. Each has three numbers: the node, and the list of the box
        // around it. Behind these is the current node.
        private var _nextTriangle:int = 0;
        private var _trianglesEnd:int = 0;
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _nodesEnd:int = 0;

        // A triangle in the model's space, the same relative to the origin, and whether the kernel's shape is not yet set to it.
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);
        private var _placed:Vector.<Number> = new Vector.<Number>(9, true);
        private var _isShapeMissing:Boolean = false;

        // The middle and the half lengths of a structure's box, relative to the model's place.
        private var _middleAndHalves:Vector.<Number> = new Vector.<Number>(6, true);

        // How far a box of the tree extends along x, y and z for each half length: the rotation without signs, times the size, row by row.
        private var _spans:Vector.<Number> = new Vector.<Number>(9, true);

        /** Sets the model, as <code>GroundModelQuery.setTo()</code> takes it. The origin is the place of the placement. */
        public function setTo(tree:ModelTree, structure:BoundingStructure, placement:Placement, depth:int):void
        {
            _tree = tree;
            _structure = structure;
            _depth = depth;
            // Touching.marginOfPlace(), twice: as if another agent stood at the place of the touch. It is written out because V8 makes objects for
            // Numbers that are passed.
            _modelMargin = 2 * Tolerances.PLACES * (Math.abs(placement.x) + Math.abs(placement.y) + Math.abs(placement.z));
            if (_depth == BoxTree.EXACT)
            {
                _modelMargin += Touching.marginOfSurface(tree.boxTree.radius * placement.size);
            }
            _placement.copyFrom(placement);
            if (isTree)
            {
                _placement.readRows(_spans, 0);
                for (var i:int = 0; i < 9; i++)
                {
                    _spans[i] = (_spans[i] < 0 ? -_spans[i] : _spans[i]) * placement.size;
                }
            }
            moveTo(RelativeMotion.NONE, 0);
        }

        /** Whether the model is a tree; otherwise it is a structure. */
        public function get isTree():Boolean
        {
            return _tree != null;
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
            push(isTree ? 0 : WHOLE, 0, 0);
        }

        // Puts a node on the stack, and the list of the node around it.
        private function push(node:int, listBegin:int, listEnd:int):void
        {
            _nodes[_nodesEnd] = node;
            _nodes[int(_nodesEnd + 1)] = listBegin;
            _nodes[int(_nodesEnd + 2)] = listEnd;
            _nodesEnd += 3;
        }

        /** Goes on to the next piece. Returns false if there is none. */
        public function next():Boolean
        {
            if (_nextTriangle < _trianglesEnd)
            {
                _tree.mesh.readTriangle(_nextTriangle, _corners);
                placePoints(_placement, _corners, 0, 9, _placed);
                _nextTriangle++;
                if (listEnd == 0)
                {
                    box.setToTriangle(_placed, _modelMargin);
                }
                point.x = _placed[0];
                point.y = _placed[1];
                point.z = _placed[2];
                corners = _placed;
                isDivisible = false;
                _isShapeMissing = true;
                shapeMargin = _modelMargin;
                shapeInBox = null;
                return true;
            }
            if (_nodesEnd == 0)
            {
                return false;
            }
            _nodesEnd -= 3;
            corners = null;
            listBegin = _nodes[int(_nodesEnd + 1)];
            listEnd = _nodes[int(_nodesEnd + 2)];
            enter(_nodes[_nodesEnd]);
            return true;
        }

        /**
         * Divides the current piece, which is divisible: the pieces inside of it come next. The lower one of two nodes comes first, because the ground is
         * below.
         *
         * @param listBegin where a list of the piece begins, for the pieces inside of it; <code>listEnd</code> is where it ends
         */
        public function divide(listBegin:int, listEnd:int):void
        {
            var tree:BoxTree = _tree.boxTree;
            var node:int = _nodes[_nodesEnd];
            var left:int = tree.left[node];
            if (left == 0)
            {
                this.listBegin = listBegin;
                this.listEnd = listEnd;
                _nextTriangle = tree.first[node];
                _trianglesEnd = tree.end[node];
                return;
            }
            var isLeftLower:Boolean = heightOf(left) < heightOf(left + 1);
            push(isLeftLower ? left + 1 : left, listBegin, listEnd);
            push(isLeftLower ? left : left + 1, listBegin, listEnd);
        }

        // How high the middle of a node is, as a multiple of the model's size.
        private function heightOf(node:int):Number
        {
            var boxes:Vector.<Number> = _tree.boxTree.boxes;
            var at:int = 6 * node;
            return _placement.r20 * boxes[at] + _placement.r21 * boxes[int(at + 1)] + _placement.r22 * boxes[int(at + 2)];
        }

        /** Finds the box around the whole model, relative to the origin. */
        public function findBoxAroundWhole(out:GroundBox):void
        {
            _structure.findPlacedBox(_placement, _middleAndHalves);
            out.x = _middleAndHalves[0] + _placement.x;
            out.y = _middleAndHalves[1] + _placement.y;
            out.z = _middleAndHalves[2] + _placement.z;
            out.halfX = _middleAndHalves[3] + _modelMargin;
            out.halfY = _middleAndHalves[4] + _modelMargin;
            out.halfZ = _middleAndHalves[5] + _modelMargin;
        }

        // Makes a node the current piece.
        private function enter(node:int):void
        {
            if (node == WHOLE)
            {
                findBoxAroundWhole(box);
                takeStructure(_structure);
                return;
            }
            var tree:BoxTree = _tree.boxTree;
            isDivisible = _depth == BoxTree.EXACT || tree.endsUpToDepth[node] < _depth;
            findBoxOfNode(node);
            if (!isDivisible)
            {
                takeStructure(tree.boxOf(node));
                return;
            }
            shapeInBox = null;
            point.x = box.x;
            point.y = box.y;
            point.z = box.z;
        }

        // Finds the box around a node's box.
        private function findBoxOfNode(node:int):void
        {
            var boxes:Vector.<Number> = _tree.boxTree.boxes;
            var at:int = 6 * node;
            var size:Number = _placement.size;
            var x:Number = boxes[at] * size;
            var y:Number = boxes[int(at + 1)] * size;
            var z:Number = boxes[int(at + 2)] * size;
            var halfX:Number = boxes[int(at + 3)];
            var halfY:Number = boxes[int(at + 4)];
            var halfZ:Number = boxes[int(at + 5)];
            // no coordinate and no half length is more than the radius
            var margin:Number = _modelMargin + 6 * Tolerances.ROUNDING * _tree.boxTree.radiusAboutOrigin * size;
            box.x = _placement.r00 * x + _placement.r01 * y + _placement.r02 * z + _placement.x;
            box.y = _placement.r10 * x + _placement.r11 * y + _placement.r12 * z + _placement.y;
            box.z = _placement.r20 * x + _placement.r21 * y + _placement.r22 * z + _placement.z;
            box.halfX = _spans[0] * halfX + _spans[1] * halfY + _spans[2] * halfZ + margin;
            box.halfY = _spans[3] * halfX + _spans[4] * halfY + _spans[5] * halfZ + margin;
            box.halfZ = _spans[6] * halfX + _spans[7] * halfY + _spans[8] * halfZ + margin;
        }

        /** The shape of the current piece, relative to the origin, if the piece is not divisible. A triangle's is made when it is first asked for. */
        public function get shape():ConvexShape
        {
            if (_isShapeMissing)
            {
                _isShapeMissing = false;
                kernel.shape.setTriangle(_placed, 0);
                kernel.shape.margin = shapeMargin;
            }
            return kernel.shape;
        }

        // Makes a structure of the model the current piece.
        private function takeStructure(structure:BoundingStructure):void
        {
            var placed:ConvexShape = kernel.shape;
            kernel.setStructure(structure, _placement);
            isDivisible = _isShapeMissing = false;
            placed.margin += _modelMargin;
            shapeMargin = placed.margin;
            shapeInBox = placed;
            point.x = placed.x;
            point.y = placed.y;
            point.z = placed.z;
        }
    }
}
