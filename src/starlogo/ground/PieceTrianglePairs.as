package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.solid.ModelTree;

    /**
     * Finds the pairs of a placed model's convex pieces and the triangles of the ground's surface near each. The model is a structure or a tree.
     * An inner node is divided if the surface comes near it. Otherwise it has no triangles, and stands for all pieces inside of it.
     *
     * <p>After <code>begin()</code>, <code>next()</code> goes through the pairs. If the pieces count too, <code>nextPiece()</code> goes through them, and
     * <code>nextTriangle()</code> through the triangles near the current one. The limits may be narrowed meanwhile.</p>
     *
     * <p>A GroundTriangles finds the triangles near the box of a piece, square by square. An inner node whose box comes to few cells lists them all. Each
     * piece inside of it then chooses from the list of the node around it, so lists are nested as the nodes are, and become shorter from level to level.</p>
     */
    internal final class PieceTrianglePairs
    {
        /** The current piece. A query may move the model before it begins. */
        public var piece:ModelPiece = new ModelPiece();

        /** The current triangle of the ground. Read only. */
        public var triangle:GroundTriangle = null;

        /**
         * The search for the triangles near the current piece. Its origin is the place that the model was set to: pieces, triangles and contacts are
         * relative to it. Read only.
         */
        public var search:GroundSearch = new GroundSearch();

        /** A limit: how deep a piece must be behind a triangle's plane. Triangles of which it clearly is not are left out. */
        public var minDepth:Number = 0;

        // Whether the pairs are for depths behind planes.
        private var _isForDepths:Boolean = false;

        private var _source:GroundTriangles = new GroundTriangles();

        // The triangles that the search has found near an inner node. Near any other piece, it writes each to the first one. Later searches use the same objects,
        // so frames allocate nothing.
        private var _found:TriangleList = new TriangleList();

        // The lists by level. The current piece has a level: how many lists are around it. Its own list is at this level, and the list that it is chosen from
        // one level before. At level 0 there is none, and only an inner node lists what the search finds.
        private var _lists:Vector.<TriangleList> = new <TriangleList>[new TriangleList()];
        private var _level:int = 0;

        // The index of the next triangle in the current piece's own list.
        private var _next:int = 0;

        // The pieces that come next, from the last one on. Each has two numbers: its node, or -1 - i for the tree's triangle i; and its level.
        private var _waiting:Vector.<int> = new Vector.<int>();
        private var _waitingEnd:int = 0;

        // The box around the whole motion of the current piece.
        private var _swept:GroundBox = new GroundBox();

        /** Sets the model and the ground, as <code>GroundModelQuery.setTo()</code> takes them. */
        public function setTo(grid:HeightGrid, tree:ModelTree, structure:BoundingStructure, placement:Placement, depth:int):void
        {
            search.grid = grid;
            // the search is for the current piece, whichever it is
            search.box = piece.box;
            search.origin.x = placement.x;
            search.origin.y = placement.y;
            search.origin.z = placement.z;
            piece.setModel(tree, structure, placement, depth);
        }

        /**
         * Begins.
         *
         * @param motion of the pieces from where they are: triangles count that they may meet until its latest time. It is kept, and the caller may
         *     make its latest time earlier
         * @param maxDistance triangles count that are at most this far away; 0 if the pieces move
         */
        public function begin(motion:RelativeMotion, maxDistance:Number):void
        {
            search.motion = motion;
            search.maxDistance = maxDistance;
            _isForDepths = false;
            minDepth = 0;
            _source.stop();
            _level = 0;
            _lists[0].count = 0;
            _next = 0;
            _waitingEnd = 0;
            push(0);
        }

        /**
         * Begins with pieces that stand, for depths behind planes. A triangle of the model counts with each listed triangle of the ground that it is behind the
         * plane of, because it may be deepest behind one that is wholly above it.
         */
        public function beginBehindPlanes():void
        {
            begin(RelativeMotion.NONE, 0);
            _isForDepths = true;
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

        /** Goes on to the next triangle near the piece: in its list, or if no list is around it, in the search. Returns false if there is none. */
        public function nextTriangle():Boolean
        {
            var list:TriangleList = _lists[_level];
            if (_next < list.count)
            {
                triangle = list.triangles[_next];
                _next++;
            }
            else if (_level == 0 && find(0))
            {
                triangle = _found.triangles[0];
            }
            else
            {
                return false;
            }
            // SquareSeparation may read the margin of any triangle: none is more than its slack
            piece.kernel.shape.margin = piece.shapeMargin + triangle.margin;
            return true;
        }

        /** Goes on to the next piece. Returns false if there is none. */
        public function nextPiece():Boolean
        {
            while (_waitingEnd > 0)
            {
                _waitingEnd -= 2;
                _level = _waiting[int(_waitingEnd + 1)];
                var node:int = _waiting[_waitingEnd];
                if (node < 0)
                {
                    piece.setToTriangle(-1 - node);
                }
                else
                {
                    piece.setToNode(node);
                }
                if (!findTriangles() || piece.kind != ModelPiece.INNER_NODE)
                {
                    return true;
                }
                divide(node);
            }
            return false;
        }

        // Divides the current piece, an inner node: the pieces inside of it come next, and its list is around them, if it has one. The lower one of two nodes
        // comes first, because the ground is below.
        private function divide(node:int):void
        {
            var tree:BoxTree = piece.tree;
            var left:int = tree.left[node];
            if (_lists[_level].count > 0)
            {
                _level++;
            }
            if (left > 0)
            {
                var lower:int = piece.heightOf(left) < piece.heightOf(left + 1) ? left : left + 1;
                push(left + left + 1 - lower);
                push(lower);
                return;
            }
            for (var i:int = tree.endPrimitive[node] - 1; i >= tree.firstPrimitive[node]; i--)
            {
                push(-1 - i);
            }
        }

        // Puts a node or a triangle of the current level before the pieces that come next.
        private function push(node:int):void
        {
            _waiting[_waitingEnd] = node;
            _waiting[int(_waitingEnd + 1)] = _level;
            _waitingEnd += 2;
        }

        // Finds the triangles near the current piece: in the list around it, or else by a search. Returns false if surely none is near.
        private function findTriangles():Boolean
        {
            if (_level == _lists.length)
            {
                _lists.push(new TriangleList());
            }
            var own:TriangleList = _lists[_level];
            own.count = 0;
            _next = 0;
            if (_level > 0)
            {
                choose(_lists[int(_level - 1)], own);
                return own.count > 0;
            }
            search.shape = piece.hasShapeInBox ? piece.kernel.shape : null;
            var comesToFewCells:Boolean = _source.begin(search);
            return piece.kind != ModelPiece.INNER_NODE || (comesToFewCells ? listAll(own) : comesNear(own));
        }

        // Lists the triangles of the search that an inner node comes near. Returns whether there are any.
        private function listAll(out:TriangleList):Boolean
        {
            _found.count = 0;
            while (find(_found.count))
            {
                _found.count++;
            }
            choose(_found, out);
            return out.count > 0;
        }

        // Whether a large inner node comes near a triangle. The list stays empty, because each piece inside of the node has a search of its own.
        private function comesNear(list:TriangleList):Boolean
        {
            _found.count = 1;
            while (find(0))
            {
                choose(_found, list);
                if (list.count > 0)
                {
                    list.count = 0;
                    return true;
                }
            }
            return false;
        }

        // Writes the next triangle of the search to one that is found. Returns false if there is none.
        private function find(index:int):Boolean
        {
            if (index == _found.triangles.length)
            {
                _found.triangles.push(new GroundTriangle());
            }
            var found:GroundTriangle = _found.triangles[index];
            if (!_source.next(found))
            {
                return false;
            }
            found.setPlane();
            found.box.setToTriangle(found.corners);
            return true;
        }

        // Adds those of some triangles to a list that the current piece comes near: the box around its motion meets the triangle's own box, and is not all in front of its
        // plane.
        private function choose(from:TriangleList, out:TriangleList):void
        {
            var maxDistance:Number = search.maxDistance;
            var countsWhereverItIs:Boolean = _isForDepths && piece.kind == ModelPiece.TRIANGLE;
            var gap:Number = maxDistance + _source.path.slack;
            var around:GroundBox = piece.box;
            if (!search.motion.isStill)
            {
                _swept.copyFrom(around);
                _swept.extendAlong(search.motion);
                around = _swept;
            }
            var minX:Number = around.x - around.halfX;
            var minY:Number = around.y - around.halfY;
            var minZ:Number = around.z - around.halfZ;
            var maxX:Number = around.x + around.halfX;
            var maxY:Number = around.y + around.halfY;
            var maxZ:Number = around.z + around.halfZ;
            for (var i:int = 0; i < from.count; i++)
            {
                var near:GroundTriangle = from.triangles[i];
                var box:GroundBox = near.box;
                var normal:Vector3D = near.plane.normal;
                // the corner that is farthest behind the plane
                var x:Number = normal.x > 0 ? minX : maxX;
                var y:Number = normal.y > 0 ? minY : maxY;
                var z:Number = normal.z > 0 ? minZ : maxZ;
                // a flat triangle has no plane: then this is NaN, and the triangle counts
                var isInFront:Boolean = normal.x * x + normal.y * y + normal.z * z - near.plane.max > gap - minDepth;
                if (!isInFront && (countsWhereverItIs
                            || box.x - box.halfX - gap <= maxX && box.x + box.halfX + gap >= minX
                            && box.y - box.halfY - gap <= maxY && box.y + box.halfY + gap >= minY
                            && box.z - box.halfZ - gap <= maxZ && box.z + box.halfZ + gap >= minZ))
                {
                    out.triangles[out.count] = near;
                    out.count++;
                }
            }
        }

        /** Whether the point of the current piece is at least this deep under the ground. */
        public function hasPointUnder(depth:Number):Boolean
        {
            var point:Vector3D = piece.point;
            return search.grid.heightAt(point.x + search.origin.x, point.y + search.origin.y) - depth >= point.z + search.origin.z;
        }

        /** Moves a contact of the piece and the triangle into the world. */
        public function moveToWorld(contact:ContactPoint):void
        {
            contact.x += search.origin.x;
            contact.y += search.origin.y;
            contact.z += search.origin.z;
        }
    }
}
