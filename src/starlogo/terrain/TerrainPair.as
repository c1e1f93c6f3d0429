package starlogo.terrain
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.solid.SolidHierarchy;

    use namespace engine;

    /**
     * A model that is placed in the world, as a structure or a tree, and the ground: whether they overlap, when, how, and how far they are apart.
     *
     * <p>What hangs together and does not touch the surface of the ground is under it or not, as a whole: a point decides. So each convex piece, a structure
     * or a triangle, meets the triangles of the surface near it (GroundFaces), and then a point of it is tried. Nodes of a tree that are divided
     * only say by their boxes which surface is near. Nodes at the depth limit are pieces.</p>
     *
     * <p>Answers are nested: a node's piece holds those of its descendants, covers included, and all its triangles.</p>
     *
     * @private
     */
    public final class TerrainPair
    {
        // What is looked for: whether a piece overlaps the ground; when one first touches the surface; the deepest contact; the closest points.
        private static const OVERLAP:int = 0;
        private static const TIME:int = 1;
        private static const CONTACT:int = 2;
        private static const CLOSEST:int = 3;

        /** How far the surface of the ground is moved inwards. */
        public var inset:Number = 0;

        private var _terrain:Terrain;
        private var _tree:SolidHierarchy;
        private var _structure:BoundingStructure;
        private var _placement:Placement;
        private var _depth:int;
        private var _corners:Vector.<Number>;
        private var _isExact:Boolean;

        // Where the model is at the time under way, and how much wider it is.
        private var _placed:Placement = new Placement();
        private var _margin:Number = 0;

        private var _goal:int = 0;
        private var _motion:RelativeMotion;

        // What was found: whether there is anything; the time, the distance, or the depth below 0; the piece and the triangle.
        private var _isFound:Boolean = false;
        private var _best:Number = 0;
        private var _piece:GroundPiece = new GroundPiece();
        private var _bestPiece:GroundPiece = new GroundPiece();
        private var _bestFace:Vector.<Number> = new Vector.<Number>(9, true);
        private var _tried:ContactPoint = new ContactPoint();

        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);
        private var _faces:GroundFaces = new GroundFaces();
        private var _nodeFaces:GroundFaces = new GroundFaces();

        /** No model yet. */
        public function TerrainPair()
        {
        }

        /**
         * Sets the two.
         *
         * @param terrain the ground
         * @param tree the model's hierarchy; null if a structure represents it
         * @param structure the structure, or the one around the tree, in the model's space
         * @param placement where the model stands
         * @param depth how many levels of the tree are visited
         * @param exact whether, if the tree has triangles, depths do not count and triangles decide
         */
        public function setTo(terrain:Terrain, tree:SolidHierarchy, structure:BoundingStructure, placement:Placement, depth:int, exact:Boolean):void
        {
            _terrain = terrain;
            _tree = tree;
            _structure = structure;
            _placement = placement;
            _isExact = tree != null && exact && tree.hasTriangles;
            _depth = _isExact ? int.MAX_VALUE : depth;
            _corners = _isExact ? tree.corners : null;
            // as if another agent stood where it touches
            _margin = 2 * Tolerances.PLACES * (Math.abs(placement.x) + Math.abs(placement.y) + Math.abs(placement.z));
            _faces.inset = _nodeFaces.inset = inset;
        }

        /** Whether the two overlap or touch where the model stands. */
        public function areOverlapping():Boolean
        {
            return overlapsAt(RelativeMotion.NONE, 0);
        }

        /** Finds the first moment of a motion of the model at which the two overlap: its time, from 0 to 1, or RelativeMotion.NEVER. */
        public function findTime(motion:RelativeMotion):void
        {
            if (overlapsAt(motion, 0))
            {
                motion.time = 0;
                return;
            }
            findImpact(motion, null);
            // rounding can miss a touch at the end of the motion
            if (motion.time == RelativeMotion.NEVER && overlapsAt(motion, 1))
            {
                motion.time = 1;
            }
        }

        /**
         * Finds when the model first touches the surface as it moves, and how.
         *
         * @param motion of the model; takes the time, from 0 to 1, or RelativeMotion.NEVER
         * @param out takes how, the normal pointing out of the ground; null if only the time is wanted
         */
        public function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            moveTo(motion, 0);
            _best = 1;
            run(TIME, motion);
            motion.time = _isFound ? _best : RelativeMotion.NEVER;
            if (_isFound && out != null)
            {
                findContactOfBest(out);
            }
        }

        /**
         * How the model, which overlaps the ground at a motion's time, does so: as it first touches the surface, or, where it stands, as the deepest of its pieces
         * does. One that is wholly under the ground is to be lifted.
         *
         * @param out takes it, the normal pointing out of the ground
         */
        public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            var time:Number = motion.time;
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
            moveTo(motion, time);
            if (!findDeepest(out))
            {
                findWayUp(out);
            }
        }

        /** How far the model, where it stands, has to be lifted to be above the ground at its middle. */
        public function findOuterContact(out:ContactPoint):void
        {
            moveTo(RelativeMotion.NONE, 0);
            findWayUp(out);
        }

        /**
         * Finds how far the two are apart where the model stands, and between which points.
         *
         * @param areTouching whether they overlap: then a point of both is found
         */
        public function findClosest(areTouching:Boolean, out:ClosestPair):void
        {
            moveTo(RelativeMotion.NONE, 0);
            if (areTouching)
            {
                if (!findDeepest(_tried))
                {
                    findWayUp(_tried);
                }
                out.aX = out.bX = _tried.x;
                out.aY = out.bY = _tried.y;
                out.aZ = out.bZ = _tried.z;
            }
            else
            {
                _best = findBound();
                run(CLOSEST, RelativeMotion.NONE);
                _bestPiece.writeClosest(out);
            }
            out.settle(areTouching);
        }

        private function moveTo(motion:RelativeMotion, time:Number):void
        {
            _placed.copyFrom(_placement);
            _placed.x += motion.startX + time * motion.x;
            _placed.y += motion.startY + time * motion.y;
            _placed.z += motion.startZ + time * motion.z;
        }

        private function overlapsAt(motion:RelativeMotion, time:Number):Boolean
        {
            moveTo(motion, time);
            run(OVERLAP, RelativeMotion.NONE);
            return _isFound;
        }

        private function findDeepest(out:ContactPoint):Boolean
        {
            _best = Infinity;
            run(CONTACT, RelativeMotion.NONE);
            if (_isFound)
            {
                findContactOfBest(out);
            }
            return _isFound;
        }

        private function run(goal:int, motion:RelativeMotion):void
        {
            _goal = goal;
            _motion = motion;
            _isFound = false;
            if (_tree == null)
            {
                _piece.setStructure(_structure, _placed, _margin);
                meet();
            }
            else
            {
                visit(_tree.root);
            }
        }

        private function visit(node:HierarchyNode):void
        {
            if (isDone() || !isNear(node))
            {
                return;
            }
            if (node.cutoffLevel < _depth)
            {
                visit(node.low);
                visit(node.high);
                return;
            }
            if (!_isExact)
            {
                _piece.setStructure(structureOf(node), _placed, _margin);
                meet();
                return;
            }
            // less than the nodes are wider than the triangles
            var margin:Number = _margin + Tolerances.SURFACES / 2 * _tree.root.radius * _placed.size;
            for (var i:int = node.first; i < node.end && !isDone(); i++)
            {
                _piece.setTriangle(_corners, 9 * i, _placed, margin);
                meet();
            }
        }

        // Whether nothing better can be found.
        private function isDone():Boolean
        {
            return _isFound && (_goal == OVERLAP || _goal == TIME && _best == 0);
        }

        // Around a node and its descendants.
        private function structureOf(node:HierarchyNode):BoundingStructure
        {
            if (_tree.boundsKind != BoundingStructure.BOX)
            {
                return node.cover || node.structure;
            }
            _box.center.setTo(node.x, node.y, node.z);
            _box.halfX = node.halfX;
            _box.halfY = node.halfY;
            _box.halfZ = node.halfZ;
            return _box;
        }

        // Whether the surface comes near a node. One away from it that is under the ground overlaps it.
        private function isNear(node:HierarchyNode):Boolean
        {
            var box:PassingBox = _nodeFaces.box;
            writeBox(structureOf(node), box);
            beginFaces(_nodeFaces);
            if (_nodeFaces.next())
            {
                return true;
            }
            if (_goal == OVERLAP)
            {
                _terrain.placeX = box.x;
                _terrain.placeY = box.y;
                _terrain.findHeight();
                _isFound = _terrain.height >= box.z;
            }
            return false;
        }

        // Makes a box the extents of a structure where the model stands.
        private function writeBox(structure:BoundingStructure, box:PassingBox):void
        {
            structure.turnedExtentsInto(_placed, _extents);
            box.x = _extents[0] + _placed.x;
            box.y = _extents[1] + _placed.y;
            box.z = _extents[2] + _placed.z;
            box.halfX = _extents[3] + _margin;
            box.halfY = _extents[4] + _margin;
            box.halfZ = _extents[5] + _margin;
        }

        // Begins with the box that stands: as far on its way, or as far around it, as something better may be found.
        private function beginFaces(faces:GroundFaces):void
        {
            var box:PassingBox = faces.box;
            var isMoving:Boolean = _goal == TIME;
            box.wayX = isMoving ? _motion.x : 0;
            box.wayY = isMoving ? _motion.y : 0;
            box.wayZ = isMoving ? _motion.z : 0;
            box.limit = isMoving ? _best : 0;
            if (_goal == CLOSEST)
            {
                box.halfX += _best;
                box.halfY += _best;
                box.halfZ += _best;
            }
            faces.begin(_terrain);
        }

        // The piece with the surface near it.
        private function meet():void
        {
            var piece:GroundPiece = _piece;
            var faces:GroundFaces = _faces;
            var isBetter:Boolean = false;
            piece.writeBox(faces.box);
            beginFaces(faces);
            piece.begin(_motion);
            while (faces.next())
            {
                piece.gap = faces.gap;
                if (_goal == OVERLAP)
                {
                    _isFound = piece.touches(faces.corners);
                    if (_isFound)
                    {
                        return;
                    }
                }
                else if (meetFace(piece, faces))
                {
                    isBetter = _isFound = true;
                    for (var i:int = 0; i < 9; i++)
                    {
                        _bestFace[i] = faces.corners[i];
                    }
                }
            }
            if (_goal == OVERLAP)
            {
                _isFound = piece.isUnder(_terrain);
            }
            if (isBetter)
            {
                _piece = _bestPiece;
                _bestPiece = piece;
            }
        }

        // Whether a triangle is better than all before, or as good as the bound that there is at the beginning.
        private function meetFace(piece:GroundPiece, faces:GroundFaces):Boolean
        {
            var found:Number;
            if (_goal == TIME)
            {
                piece.time = _best;
                piece.findTime(faces.corners);
                found = piece.time;
            }
            else if (_goal == CLOSEST)
            {
                piece.measure(faces.corners);
                found = piece.distance;
            }
            else
            {
                found = Infinity;
                if (piece.touches(faces.corners))
                {
                    piece.time = 0;
                    piece.findContact(faces.corners, _tried);
                    found = -_tried.depth;
                }
            }
            if (!(found < _best || found == _best && !_isFound))
            {
                return false;
            }
            _best = found;
            if (_goal == TIME)
            {
                faces.box.limit = found;
            }
            return true;
        }

        private function findContactOfBest(out:ContactPoint):void
        {
            _bestPiece.time = _goal == TIME ? _best : 0;
            _bestPiece.findContact(_bestFace, out);
        }

        // From the lowest place of the model to the ground over or under its middle: there may be higher ground beside it.
        private function findWayUp(out:ContactPoint):void
        {
            var box:PassingBox = _nodeFaces.box;
            writeBox(_structure, box);
            _terrain.placeX = box.x;
            _terrain.placeY = box.y;
            _terrain.findHeight();
            out.setNormal(0, 0, 1);
            // 0 for NaN
            out.depth = _terrain.height > box.z - box.halfZ ? _terrain.height - box.z + box.halfZ : 0;
            out.x = box.x;
            out.y = box.y;
            out.z = box.z - box.halfZ + out.depth / 2;
        }

        // No less than how far the two are apart: as far as the nearest height is from the middle of the model, and how far that reaches.
        private function findBound():Number
        {
            var box:PassingBox = _nodeFaces.box;
            writeBox(_structure, box);
            var width:Number = _terrain.cellWidth;
            var column:int = Math.max(0, Math.min(_terrain.columns - 1, Math.round((box.x - _terrain.x) / width)));
            var row:int = Math.max(0, Math.min(_terrain.rows - 1, Math.round((box.y - _terrain.y) / width)));
            var toX:Number = _terrain.x + column * width - box.x;
            var toY:Number = _terrain.y + row * width - box.y;
            var toZ:Number = _terrain.heights[row * _terrain.columns + column] - box.z;
            return Tolerances.OUTER * (Math.sqrt(toX * toX + toY * toY + toZ * toZ) + box.halfX + box.halfY + box.halfZ);
        }
    }
}
