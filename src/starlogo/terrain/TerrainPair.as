package starlogo.terrain
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.intersection.ConvexTriangle;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.solid.SolidHierarchy;

    use namespace engine;

    /**
     * Tests a placed model against the ground: whether the two overlap, when and how they first touch, and how far they are apart. The model is
     * a structure or a tree.
     *
     * <p>A connected piece that does not touch the ground's surface is wholly under the ground or wholly outside of it, so one point decides.
     * First, each convex piece is tested against the triangles of the surface near it (GroundFaces). Then a point of the piece is tested. A
     * piece is a structure or a triangle. Nodes at the depth limit are pieces. Nodes that are divided only say, by their boxes, whether the
     * surface is near.</p>
     *
     * <p>Answers are nested, because a node's piece contains the pieces of its descendants, their covers, and all its triangles.</p>
     *
     * @private
     */
    public final class TerrainPair
    {
        // The goals of a search: whether a piece overlaps the ground; when a piece first touches the surface; the deepest contact; the closest
        // points.
        private static const OVERLAP:int = 0;
        private static const TIME:int = 1;
        private static const CONTACT:int = 2;
        private static const CLOSEST:int = 3;

        /** How far the surface of the ground is moved inwards. */
        public var inset:Number = 0;

        private var _grid:HeightGrid;
        private var _tree:SolidHierarchy;
        private var _structure:BoundingStructure;
        private var _depth:int;
        private var _isExact:Boolean;
        private var _placement:Placement;

        // The model's placement at the current time, and the margin by which the model is enlarged.
        private var _placed:Placement = new Placement();
        private var _margin:Number = 0;

        private var _goal:int = 0;
        private var _motion:RelativeMotion;

        // The result: whether anything was found; the time, the distance or the negative depth. The current piece, the best piece and its
        // triangle.
        private var _isFound:Boolean = false;
        private var _best:Number = 0;
        private var _piece:ConvexTriangle = new ConvexTriangle();
        private var _bestPiece:ConvexTriangle = new ConvexTriangle();
        private var _bestFace:Vector.<Number> = new Vector.<Number>(9, true);

        private var _faces:GroundFaces = new GroundFaces();
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);
        private var _tried:ContactPoint = new ContactPoint();

        /** Creates a test without a model. */
        public function TerrainPair()
        {
            _piece.isOneSided = _bestPiece.isOneSided = true;
        }

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
            _grid = grid;
            _tree = tree;
            _structure = structure;
            _placement = placement;
            _placed.copyFrom(placement);
            _isExact = tree != null && exact && tree.hasTriangles;
            _depth = _isExact ? int.MAX_VALUE : depth;
            // The margin is as large as if another agent stood at the place of the touch.
            _margin = 2 * Tolerances.PLACES * (Math.abs(placement.x) + Math.abs(placement.y) + Math.abs(placement.z));
            if (_isExact)
            {
                _margin += Tolerances.SURFACES / 2 * tree.root.radius * placement.size;
            }
            _piece.margin = _bestPiece.margin = _margin;
            _faces.inset = inset;
        }

        /** Whether the two overlap or touch where the model stands. */
        public function areOverlapping():Boolean
        {
            search(OVERLAP, RelativeMotion.NONE, 0, 0);
            return _isFound;
        }

        /**
         * Finds the first moment at which the two overlap while the model moves. The motion receives the time, from 0 to 1, or
         * RelativeMotion.NEVER.
         */
        public function findTime(motion:RelativeMotion):void
        {
            search(OVERLAP, motion, 0, 0);
            if (_isFound)
            {
                motion.time = 0;
                return;
            }
            findImpact(motion, null);
            if (motion.time == RelativeMotion.NEVER)
            {
                // rounding can miss a touch at the end of the motion
                search(OVERLAP, motion, 1, 0);
                motion.time = _isFound ? 1 : RelativeMotion.NEVER;
            }
        }

        /**
         * Finds when the model first touches the surface as it moves, and how.
         *
         * @param motion of the model; takes the time, from 0 to 1, or RelativeMotion.NEVER
         * @param out receives the contact, with a normal that points out of the ground; null if only the time is needed
         */
        public function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            search(TIME, motion, 0, 1);
            motion.time = _isFound ? _best : RelativeMotion.NEVER;
            if (_isFound && out != null)
            {
                findContactOfBest(_best, out);
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
            findDeepest(motion, time, out);
        }

        /**
         * Finds the contact that lifts the model from its lowest place up to the ground at the model's middle. There may be higher ground
         * beside it.
         */
        public function findOuterContact(out:ContactPoint):void
        {
            var box:PassingBox = boxOf(_structure);
            var low:Number = box.z - box.halfZ;
            var height:Number = heightAt(box.x, box.y);
            out.setNormal(0, 0, 1);
            // The height may be NaN.
            out.depth = height > low ? height - low : 0;
            out.x = box.x;
            out.y = box.y;
            out.z = low + out.depth / 2;
        }

        /**
         * Finds how far the two are apart where the model stands, and between which points.
         *
         * @param areTouching whether they overlap. If so, a point of both is found
         */
        public function findClosest(areTouching:Boolean, out:ClosestPair):void
        {
            search(CLOSEST, RelativeMotion.NONE, 0, findBound());
            _bestPiece.writeClosest(out);
            if (areTouching)
            {
                // either the model's point is in the ground, or the surface's point is in the model
                var isUnder:Boolean = heightAt(out.aX, out.aY) >= out.aZ;
                out.aX = out.bX = isUnder ? out.aX : out.bX;
                out.aY = out.bY = isUnder ? out.aY : out.bY;
                out.aZ = out.bZ = isUnder ? out.aZ : out.bZ;
            }
            out.settle(areTouching);
        }

        private function findDeepest(motion:RelativeMotion, time:Number, out:ContactPoint):void
        {
            search(CONTACT, motion, time, Infinity);
            if (_isFound)
            {
                findContactOfBest(0, out);
            }
            else
            {
                findOuterContact(out);
            }
        }

        private function findContactOfBest(time:Number, out:ContactPoint):void
        {
            _bestPiece.setTriangle(_bestFace, 0);
            _bestPiece.time = time;
            _bestPiece.findContact(out);
        }

        // An upper bound of the distance of the two: the distance from the model's middle to the surface above or below it, or to the nearest
        // height of the border or the wall below it, plus how far the model extends.
        private function findBound():Number
        {
            var box:PassingBox = boxOf(_structure);
            var toX:Number = 0;
            var toY:Number = 0;
            var toZ:Number = heightAt(box.x, box.y) - box.z;
            if (isNaN(toZ))
            {
                var column:int = Math.max(0, Math.min(_grid.columns - 1, Math.round((box.x - _grid.x) / _grid.cellWidth)));
                var row:int = Math.max(0, Math.min(_grid.rows - 1, Math.round((box.y - _grid.y) / _grid.cellWidth)));
                toX = _grid.x + column * _grid.cellWidth - box.x;
                toY = _grid.y + row * _grid.cellWidth - box.y;
                toZ = Math.min(0, _grid.heights[int(row * _grid.columns + column)] - box.z);
            }
            return Tolerances.OUTER * (Math.sqrt(toX * toX + toY * toY + toZ * toZ) + box.halfX + box.halfY + box.halfZ);
        }

        // Looks for something that is better than a bound, or as good. The model is where the motion has brought it at a time.
        private function search(goal:int, motion:RelativeMotion, time:Number, bound:Number):void
        {
            _placed.x = _placement.x + motion.startX + time * motion.x;
            _placed.y = _placement.y + motion.startY + time * motion.y;
            _placed.z = _placement.z + motion.startZ + time * motion.z;
            _goal = goal;
            _motion = goal == TIME ? motion : RelativeMotion.NONE;
            _best = bound;
            _isFound = false;
            if (_tree == null)
            {
                meetStructure(_structure);
            }
            else
            {
                visit(_tree.root);
            }
        }

        private function visit(node:HierarchyNode):void
        {
            if (isDone())
            {
                return;
            }
            if (node.cutoffLevel < _depth)
            {
                if (isNear(node))
                {
                    visit(node.low);
                    visit(node.high);
                }
            }
            else if (!_isExact)
            {
                meetStructure(structureOf(node));
            }
            else if (isNear(node))
            {
                meetTriangles(node);
            }
        }

        private function meetTriangles(node:HierarchyNode):void
        {
            for (var i:int = node.first; i < node.end && !isDone(); i++)
            {
                _piece.beginTriangle(_tree.corners, 9 * i, _placed, _motion);
                meet();
            }
        }

        // Whether nothing better can be found.
        private function isDone():Boolean
        {
            return _isFound && (_goal == OVERLAP || _goal == TIME && _best == 0);
        }

        // The structure around a node and its descendants.
        private function structureOf(node:HierarchyNode):BoundingStructure
        {
            return _tree.boundsKind == BoundingStructure.BOX ? node.writeBox(_box) : node.cover || node.structure;
        }

        // Whether the surface comes near a node. If it does not, and the node is under the ground, the node overlaps the ground.
        private function isNear(node:HierarchyNode):Boolean
        {
            var box:PassingBox = boxOf(structureOf(node));
            beginFaces();
            if (_faces.next())
            {
                return true;
            }
            _isFound ||= _goal == OVERLAP && heightAt(box.x, box.y) >= box.z;
            return false;
        }

        private function heightAt(x:Number, y:Number):Number
        {
            _grid.placeX = x;
            _grid.placeY = y;
            _grid.findHeight();
            return _grid.height;
        }

        // The box around a structure at the model's current placement.
        private function boxOf(structure:BoundingStructure):PassingBox
        {
            var box:PassingBox = _faces.box;
            structure.turnedExtentsInto(_placed, _extents);
            box.x = _extents[0] + _placed.x;
            box.y = _extents[1] + _placed.y;
            box.z = _extents[2] + _placed.z;
            box.halfX = _extents[3] + _margin;
            box.halfY = _extents[4] + _margin;
            box.halfZ = _extents[5] + _margin;
            return box;
        }

        // Begins with the standing box. Extends it along its way, or to all sides, as far as something better may be found.
        private function beginFaces():void
        {
            var box:PassingBox = _faces.box;
            box.wayX = _motion.x;
            box.wayY = _motion.y;
            box.wayZ = _motion.z;
            box.limit = _goal == TIME ? _best : 0;
            if (_goal == CLOSEST)
            {
                box.halfX += _best;
                box.halfY += _best;
                box.halfZ += _best;
            }
            _faces.begin(_grid);
        }

        private function meetStructure(structure:BoundingStructure):void
        {
            _piece.begin(structure, _placed, _motion);
            meet();
        }

        // Tests the piece against the surface near it.
        private function meet():void
        {
            var isBetter:Boolean = false;
            var point:Vector3D = _piece.point;
            var box:PassingBox = _faces.box;
            _piece.extentsInto(_extents);
            box.x = (_extents[0] + _extents[1]) / 2;
            box.y = (_extents[2] + _extents[3]) / 2;
            box.z = (_extents[4] + _extents[5]) / 2;
            box.halfX = (_extents[1] - _extents[0]) / 2;
            box.halfY = (_extents[3] - _extents[2]) / 2;
            box.halfZ = (_extents[5] - _extents[4]) / 2;
            beginFaces();
            while (_faces.next())
            {
                _piece.setTriangle(_faces.corners, 0);
                _piece.gap = _faces.gap;
                if (_goal == OVERLAP)
                {
                    _isFound = _piece.touches();
                    if (_isFound)
                    {
                        return;
                    }
                }
                else if (isBetterFace())
                {
                    isBetter = _isFound = true;
                    for (var i:int = 0; i < 9; i++)
                    {
                        _bestFace[i] = _faces.corners[i];
                    }
                }
            }
            if (_goal == OVERLAP)
            {
                _isFound = heightAt(point.x, point.y) >= point.z;
            }
            if (isBetter)
            {
                var other:ConvexTriangle = _bestPiece;
                _bestPiece = _piece;
                _piece = other;
            }
        }

        // Whether a triangle is better than all before it. The first triangle found may also be only as good as the bound at the beginning.
        private function isBetterFace():Boolean
        {
            var found:Number = Infinity;
            if (_goal == TIME)
            {
                _piece.time = _best;
                _piece.findTime();
                found = _piece.time;
            }
            else if (_goal == CLOSEST)
            {
                _piece.measure();
                found = _piece.distance;
            }
            else if (_piece.touches())
            {
                _piece.time = 0;
                _piece.findContact(_tried);
                found = -_tried.depth;
            }
            if (!(found < _best || found == _best && !_isFound))
            {
                return false;
            }
            _best = found;
            _faces.box.limit = _goal == TIME ? found : 0;
            return true;
        }
    }
}
