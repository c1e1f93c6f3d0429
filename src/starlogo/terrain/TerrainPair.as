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
        // The goals of a search: when a piece first touches the surface, the deepest contact, and the closest points. A search for the time
        // without a motion finds whether a piece overlaps the ground.
        private static const TIME:int = 0;
        private static const DEPTH:int = 1;
        private static const DISTANCE:int = 2;

        private var _grid:HeightGrid;
        private var _tree:SolidHierarchy;
        private var _structure:BoundingStructure;
        private var _depth:int;
        private var _isExact:Boolean;

        // The model's place, and where it stands at the current time relative to that place.
        private var _origin:Placement = new Placement();
        private var _placed:Placement = new Placement();

        private var _goal:int = 0;
        private var _motion:RelativeMotion;

        // The results: whether anything was found; the time, the distance or the negative depth; the contact and the closest points.
        private var _isFound:Boolean = false;
        private var _best:Number = 0;
        private var _contact:ContactPoint = null;
        private var _closest:ClosestPair = null;

        private var _piece:ConvexTriangle = new ConvexTriangle();
        private var _faces:GroundFaces = new GroundFaces();
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);
        private var _tried:ContactPoint = new ContactPoint();

        /** Creates a test without a model. */
        public function TerrainPair()
        {
            _piece.isOneSided = true;
            _faces.origin = _origin;
        }

        /**
         * Sets the model and the ground.
         *
         * @param grid the ground
         * @param inset how far the ground's surface is moved inwards
         * @param tree the model's hierarchy; null if a structure represents it
         * @param structure the structure, or the one around the tree, in the model's space
         * @param placement where the model stands
         * @param depth how many levels of the tree are visited
         * @param exact whether triangles decide in place of depths, if the tree has triangles
         */
        public function setTo(grid:HeightGrid, inset:Number, tree:SolidHierarchy, structure:BoundingStructure, placement:Placement, depth:int,
                exact:Boolean):void
        {
            _grid = grid;
            _tree = tree;
            _structure = structure;
            _placed.copyFrom(placement);
            _origin.x = placement.x;
            _origin.y = placement.y;
            _origin.z = placement.z;
            _isExact = tree != null && exact && tree.hasTriangles;
            _depth = _isExact ? int.MAX_VALUE : depth;
            // The margin is as large as if another agent stood at the place of the touch.
            _piece.margin = 2 * Tolerances.PLACES * (Math.abs(placement.x) + Math.abs(placement.y) + Math.abs(placement.z));
            if (_isExact)
            {
                _piece.margin += Tolerances.SURFACES / 2 * tree.root.radius * placement.size;
            }
            _faces.inset = inset;
            placeAt(RelativeMotion.NONE, 0);
        }

        /** Whether the two overlap or touch where the model stands. */
        public function areOverlapping():Boolean
        {
            return overlapsAt(RelativeMotion.NONE, 0);
        }

        /**
         * Finds the first moment at which the two overlap while the model moves. The motion receives the time, from 0 to 1, or
         * RelativeMotion.NEVER.
         */
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
         * @param out receives the contact, with a normal that points out of the ground; null if only the time is needed
         */
        public function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            placeAt(motion, 0);
            search(TIME, motion, 1, out);
            motion.time = _isFound ? _best : RelativeMotion.NEVER;
            if (_isFound && out != null)
            {
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
            placeAt(motion, time);
            search(DEPTH, RelativeMotion.NONE, Infinity, out);
            if (_isFound)
            {
                moveToWorld(out);
            }
            else
            {
                findOuterContact(out);
            }
        }

        /**
         * Finds the contact that lifts the model from its lowest place up to the ground at the model's middle. There may be higher ground
         * beside it.
         */
        public function findOuterContact(out:ContactPoint):void
        {
            placeBox(_structure);
            var middle:Vector3D = _faces.middle;
            var low:Number = middle.z - _faces.half.z;
            var height:Number = heightAt(middle.x, middle.y);
            out.setNormal(0, 0, 1);
            // The height may be NaN.
            out.depth = height > low ? height - low : 0;
            out.x = middle.x;
            out.y = middle.y;
            out.z = low + out.depth / 2;
            moveToWorld(out);
        }

        /**
         * Finds how far the two are apart where the model stands, and between which points.
         *
         * @param areTouching whether they overlap. If so, a point of both is found
         */
        public function findClosest(areTouching:Boolean, out:ClosestPair):void
        {
            // Looks farther and farther away. The first guess is the distance to the surface above or below the model's middle.
            placeBox(_structure);
            var half:Vector3D = _faces.half;
            var height:Number = heightAt(_faces.middle.x, _faces.middle.y);
            var above:Number = isNaN(height) ? _grid.cellWidth : Math.abs(height - _faces.middle.z);
            var bound:Number = Math.max(half.x + half.y + half.z + above, Tolerances.SURFACES * _grid.cellWidth);
            _closest = out;
            do
            {
                search(DISTANCE, RelativeMotion.NONE, bound, null);
                bound *= 2;
            }
            while (!_isFound);
            if (areTouching)
            {
                // either the model's point is in the ground, or the surface's point is in the model
                var isUnder:Boolean = heightAt(out.aX, out.aY) >= out.aZ;
                out.aX = out.bX = isUnder ? out.aX : out.bX;
                out.aY = out.bY = isUnder ? out.aY : out.bY;
                out.aZ = out.bZ = isUnder ? out.aZ : out.bZ;
            }
            out.settle(areTouching);
            out.place(_origin);
        }

        // Moves the model to where the motion has brought it at a time.
        private function placeAt(motion:RelativeMotion, time:Number):void
        {
            _placed.x = motion.startX + time * motion.x;
            _placed.y = motion.startY + time * motion.y;
            _placed.z = motion.startZ + time * motion.z;
        }

        private function overlapsAt(motion:RelativeMotion, time:Number):Boolean
        {
            placeAt(motion, time);
            search(TIME, RelativeMotion.NONE, 0, null);
            return _isFound;
        }

        private function moveToWorld(out:ContactPoint):void
        {
            out.x += _origin.x;
            out.y += _origin.y;
            out.z += _origin.z;
        }

        // Looks for something that is better than a bound, or as good. The contact is null if it is not needed.
        private function search(goal:int, motion:RelativeMotion, bound:Number, contact:ContactPoint):void
        {
            _goal = goal;
            _contact = contact;
            _motion = motion;
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
            var structure:BoundingStructure = structureOf(node);
            if (node.cutoffLevel < _depth)
            {
                beginFaces(structure);
                if (_faces.next())
                {
                    visit(node.low);
                    visit(node.high);
                }
                else
                {
                    meetInside(_faces.middle);
                }
            }
            else if (_isExact)
            {
                meetTriangles(node, structure);
            }
            else
            {
                meetStructure(structure);
            }
        }

        private function meetStructure(structure:BoundingStructure):void
        {
            _piece.begin(structure, _placed, _motion);
            meet(structure);
        }

        private function meetTriangles(node:HierarchyNode, structure:BoundingStructure):void
        {
            for (var i:int = node.first; i < node.end && !isDone(); i++)
            {
                _piece.beginTriangle(_tree.corners, 9 * i, _placed, _motion);
                meet(structure);
            }
        }

        // Whether nothing better can be found.
        private function isDone():Boolean
        {
            return _isFound && _goal == TIME && _best == 0;
        }

        // The structure around a node and its descendants.
        private function structureOf(node:HierarchyNode):BoundingStructure
        {
            return _tree.boundsKind == BoundingStructure.BOX ? node.writeBox(_box) : node.cover || node.bounds;
        }

        private function heightAt(x:Number, y:Number):Number
        {
            _grid.placeX = x + _origin.x;
            _grid.placeY = y + _origin.y;
            _grid.findHeight();
            return _grid.height - _origin.z;
        }

        // Puts the box around a structure of the model.
        private function placeBox(structure:BoundingStructure):void
        {
            var middle:Vector3D = _faces.middle;
            var half:Vector3D = _faces.half;
            var margin:Number = _piece.margin;
            structure.turnedExtentsInto(_placed, _extents);
            middle.x = _extents[0] + _placed.x;
            middle.y = _extents[1] + _placed.y;
            middle.z = _extents[2] + _placed.z;
            half.x = _extents[3] + margin;
            half.y = _extents[4] + margin;
            half.z = _extents[5] + margin;
        }

        // Begins with the triangles near the box around a structure of the model, on its way, or as far to all sides as something better may
        // be found.
        private function beginFaces(structure:BoundingStructure):void
        {
            placeBox(structure);
            _faces.way = _motion;
            _faces.limit = _goal == TIME ? _best : 0;
            _faces.reach = _goal == DISTANCE ? _best : 0;
            _faces.begin(_grid);
        }

        // Tests the piece against the triangles near the structure around it.
        private function meet(structure:BoundingStructure):void
        {
            beginFaces(structure);
            while (!isDone() && _faces.next())
            {
                _piece.setTriangle(_faces.corners, 0);
                _piece.gap = _faces.gap;
                meetFace();
            }
            meetInside(_piece.point);
        }

        // A standing piece with a point that is under the ground overlaps it. If the ground is narrower, this is also so as seen from its sides.
        private function meetInside(point:Vector3D):void
        {
            if (_goal == TIME && _motion === RelativeMotion.NONE && !_isFound)
            {
                var inset:Number = _faces.inset;
                _isFound = true;
                // The four places that are an inset beside it along x and y, or its own place if there is no inset. This repeats heightAt(), because
                // V8 would make objects for its Numbers.
                for (var side:int = inset > 0 ? 0 : 3; side < 4 && _isFound; side++)
                {
                    var toX:Number = (side & 1) == 0 ? -inset : inset;
                    var toY:Number = (side & 2) == 0 ? -inset : inset;
                    _grid.placeX = point.x + toX + _origin.x;
                    _grid.placeY = point.y + toY + _origin.y;
                    _grid.findHeight();
                    _isFound = _grid.height - _origin.z - inset >= point.z;
                }
            }
        }

        // Tests the piece against a triangle. Keeps the result if it is better than all before it. The first one may also be only as good as
        // the bound at the beginning.
        private function meetFace():void
        {
            var found:Number = Infinity;
            if (_goal == TIME)
            {
                _piece.time = _best;
                _piece.findTime();
                found = _piece.time;
            }
            else if (_goal == DISTANCE)
            {
                _piece.measure();
                found = _piece.distance;
            }
            else
            {
                // A piece deep under the ground touches no triangle. Then the first one near it gives a direction.
                var isTouching:Boolean = _piece.touches();
                if (isTouching || !_isFound)
                {
                    _piece.time = 0;
                    _piece.findContact(_tried);
                    found = isTouching ? -_tried.depth : Infinity;
                }
            }
            if (!(found < _best || found == _best && !_isFound))
            {
                return;
            }
            _isFound = true;
            _best = found;
            if (_goal == DISTANCE)
            {
                _piece.writeClosest(_closest);
                _faces.reach = found;
            }
            else if (_goal == DEPTH)
            {
                _contact.copyFrom(_tried);
            }
            else
            {
                _faces.limit = found;
                if (_contact != null)
                {
                    _piece.findContact(_contact);
                }
            }
        }
    }
}
