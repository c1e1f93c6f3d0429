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
    import starlogo.solid.SupportPoint;
    import starlogo.solid.SupportSearch;

    use namespace engine;

    /**
     * A convex piece of a placed model, where it stands. A model that a structure represents is one piece. The smallest pieces of a tree are its nodes at
     * the depth limit, or its triangles. An inner node, which has these inside of it, is a piece too, of which only the box is known.
     */
    internal final class ModelPiece
    {
        /** A kind of piece: the structure that represents the model. */
        public static const STRUCTURE:int = 0;

        /** A kind of piece: the box of a node at the depth limit. */
        public static const NODE_BOX:int = 1;

        /** A kind of piece: a triangle of the model. */
        public static const TRIANGLE:int = 2;

        /** A kind of piece: a node above the smallest pieces. */
        public static const INNER_NODE:int = 3;

        /** The kind. Read only. */
        public var kind:int = STRUCTURE;

        /** The model's tree; null if a structure represents it. Read only. */
        public var tree:BoxTree = null;

        /** Tests the piece, which is the kernel's shape, with a triangle of the ground. For an inner node the shape is still an earlier piece. */
        public var kernel:TriangleKernel = new TriangleKernel();

        /** The margin of the model's place and surface. Read only. */
        public var modelMargin:Number = 0;

        /** The margin of the piece, with the margins of the model's place and surface. Read only. */
        public var shapeMargin:Number = 0;

        /** The box around the piece and its margin, relative to the origin. After <code>findWholeBox()</code> it is around the whole model. Read only. */
        public var box:GroundBox = new GroundBox();

        /** A point of the piece; the middle of the box of an inner node. Read only. */
        public var point:Vector3D = new Vector3D();

        private var _structure:BoundingStructure;

        // How many levels of the tree are visited; EXACT if triangles are the smallest pieces.
        private var _depth:int;

        // The model's placement, relative to the origin.
        private var _placement:Placement = new Placement();

        private var _supportSearch:SupportSearch = new SupportSearch();

        // The corners of a triangle; the middle and the half lengths of a structure's box, relative to the model's place.
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);
        private var _middleAndHalves:Vector.<Number> = new Vector.<Number>(6, true);

        /** Sets the model, as <code>GroundModelQuery.setTo()</code> takes it. The origin is the place of the placement. */
        public function setModel(tree:ModelTree, structure:BoundingStructure, placement:Placement, depth:int):void
        {
            this.tree = tree == null ? null : tree.treeFor(depth);
            _structure = structure;
            _depth = depth;
            // twice, as if another agent stood at the place of the touch
            modelMargin = 2 * Touching.marginOfPlace(placement.x, placement.y, placement.z);
            if (_depth == BoxTree.EXACT)
            {
                modelMargin += Touching.marginOfSurface(this.tree.boundingRadius * placement.size);
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

        /** Whether the piece is a structure or a node's box. Then <code>box</code> is around the kernel's shape. */
        public function get hasShapeInBox():Boolean
        {
            return kind <= NODE_BOX;
        }

        /** Finds the box around the whole model, where it stands now. There is no piece then. */
        public function findWholeBox():void
        {
            if (tree == null)
            {
                setBoxAround(_structure);
                return;
            }
            setToInnerNode(0);
        }

        /** Whether the smallest pieces are triangles. */
        public function get areTriangles():Boolean
        {
            return _depth == BoxTree.EXACT;
        }

        /** Finds the point of the model that is farthest in a direction. */
        public function findFarthest(direction:Vector3D, out:SupportPoint):void
        {
            _supportSearch.find(tree, _depth, _structure, _placement, direction, out);
        }

        /** Becomes a node of the tree, or the structure if there is no tree. */
        public function setToNode(node:int):void
        {
            if (tree == null)
            {
                kind = STRUCTURE;
                setToStructure(_structure);
            }
            else if (_depth != BoxTree.EXACT && tree.leafUpToDepth[node] >= _depth)
            {
                kind = NODE_BOX;
                setToStructure(tree.boxOf(node));
            }
            else
            {
                setToInnerNode(node);
            }
        }

        /** Becomes a triangle of the tree. */
        public function setToTriangle(index:int):void
        {
            kind = TRIANGLE;
            tree.readTriangle(index, _corners);
            placePoints(_placement, _corners, 0, 9, _corners);
            kernel.shape.setTriangle(_corners, 0);
            shapeMargin = modelMargin;
            point.x = _corners[0];
            point.y = _corners[1];
            point.z = _corners[2];
            box.setToTriangle(_corners);
            box.halfX += shapeMargin;
            box.halfY += shapeMargin;
            box.halfZ += shapeMargin;
        }

        /** How high the middle of a node is above the model's place, as a multiple of its size. */
        public function heightOf(node:int):Number
        {
            var boxes:Vector.<Number> = tree.boxes;
            var at:int = 6 * node;
            return _placement.r20 * boxes[at] + _placement.r21 * boxes[int(at + 1)] + _placement.r22 * boxes[int(at + 2)];
        }

        // Becomes an inner node. The box is the one that setBoxAround() finds of any structure, to the last bit, because walls are cut above and below it.
        private function setToInnerNode(node:int):void
        {
            var boxes:Vector.<Number> = tree.boxes;
            var at:int = 6 * node;
            var size:Number = _placement.size;
            var x:Number = boxes[at] * size;
            var y:Number = boxes[int(at + 1)] * size;
            var z:Number = boxes[int(at + 2)] * size;
            var halfX:Number = boxes[int(at + 3)] * size;
            var halfY:Number = boxes[int(at + 4)] * size;
            var halfZ:Number = boxes[int(at + 5)] * size;
            var margin:Number = Tolerances.ROUNDING * (Math.abs(x) + Math.abs(y) + Math.abs(z) + halfX + halfY + halfZ);
            kind = INNER_NODE;
            box.x = point.x = _placement.r00 * x + _placement.r01 * y + _placement.r02 * z + _placement.x;
            box.y = point.y = _placement.r10 * x + _placement.r11 * y + _placement.r12 * z + _placement.y;
            box.z = point.z = _placement.r20 * x + _placement.r21 * y + _placement.r22 * z + _placement.z;
            box.halfX = Math.abs(_placement.r00) * halfX + Math.abs(_placement.r01) * halfY + Math.abs(_placement.r02) * halfZ + margin + modelMargin;
            box.halfY = Math.abs(_placement.r10) * halfX + Math.abs(_placement.r11) * halfY + Math.abs(_placement.r12) * halfZ + margin + modelMargin;
            box.halfZ = Math.abs(_placement.r20) * halfX + Math.abs(_placement.r21) * halfY + Math.abs(_placement.r22) * halfZ + margin + modelMargin;
        }

        // Becomes a structure of the model.
        private function setToStructure(structure:BoundingStructure):void
        {
            var shape:ConvexShape = kernel.shape;
            setBoxAround(structure);
            kernel.setStructure(structure, _placement);
            shape.margin += modelMargin;
            shapeMargin = shape.margin;
            point.copyFrom(shape.origin);
        }

        // Sets the box to the one around a structure of the model.
        private function setBoxAround(structure:BoundingStructure):void
        {
            structure.findPlacedBox(_placement, _middleAndHalves);
            box.x = _middleAndHalves[0] + _placement.x;
            box.y = _middleAndHalves[1] + _placement.y;
            box.z = _middleAndHalves[2] + _placement.z;
            box.halfX = _middleAndHalves[3] + modelMargin;
            box.halfY = _middleAndHalves[4] + modelMargin;
            box.halfZ = _middleAndHalves[5] + modelMargin;
        }
    }
}
