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
     * Searches the triangles of the ground's surface near a placed model, for what TerrainPair asks: when a piece of the model first touches one,
     * how deep it is, or how far away. The model is a structure or a tree.
     *
     * <p>Each convex piece is tested against the triangles of the surface near it (GroundFaces). A piece is a structure or a triangle. Nodes at
     * the depth limit are pieces. Nodes that are divided only say, by their boxes, whether the surface is near.</p>
     */
    internal class GroundSearch
    {
        // The goals of a search: when a piece first touches the surface; the closest points; the deepest contact of a piece whose deepest point
        // is known to be about as deep in the ground; the deepest contact of others; and the planes of triangles that a piece is behind. A search
        // for the time without a motion finds whether a piece overlaps the ground.
        protected static const TIME:int = 0;
        protected static const DISTANCE:int = 1;
        protected static const FACES:int = 2;
        protected static const EDGES:int = 3;
        protected static const WAYS:int = 4;

        protected var _grid:HeightGrid;
        protected var _tree:SolidHierarchy;
        protected var _structure:BoundingStructure;
        private var _depth:int;
        private var _isExact:Boolean;

        // The model's place, and where it stands at the current time relative to that place.
        protected var _origin:Placement = new Placement();
        protected var _placed:Placement = new Placement();

        protected var _goal:int = 0;
        protected var _motion:RelativeMotion;

        // The results: whether anything was found; the time, the distance or the negative depth; the contact and the closest points.
        protected var _isFound:Boolean = false;
        protected var _best:Number = 0;
        protected var _contact:ContactPoint = null;
        protected var _closest:ClosestPair = null;

        protected var _piece:ConvexTriangle = new ConvexTriangle();
        protected var _faces:GroundFaces = new GroundFaces();
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        /** Creates a search without a model. */
        public function GroundSearch()
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

        // Moves the model to where the motion has brought it at a time.
        protected function placeAt(motion:RelativeMotion, time:Number):void
        {
            _placed.x = motion.startX + time * motion.x;
            _placed.y = motion.startY + time * motion.y;
            _placed.z = motion.startZ + time * motion.z;
        }

        // Looks for something that is better than a bound, or as good. The contact is null if it is not needed.
        protected function search(goal:int, motion:RelativeMotion, bound:Number, contact:ContactPoint):void
        {
            _goal = goal;
            _contact = contact;
            _motion = motion;
            _best = bound;
            _isFound = false;
            if (_tree == null || goal == WAYS)
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
            var structure:BoundingStructure = node.writeBox(_box);
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
            beginPiece(structure);
            meet(structure);
            _faces.structure = null;
        }

        // A function of its own, so that V8 makes no object for the margin.
        private function beginPiece(structure:BoundingStructure):void
        {
            _piece.begin(structure, _placed, _motion);
            _faces.structure = _piece.structure;
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

        // Puts the box around a structure of the model.
        protected function placeBox(structure:BoundingStructure):void
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
            _faces.reach = _goal == DISTANCE || _goal == WAYS ? _best : 0;
            _faces.begin(_grid);
            if (_goal == FACES && _isFound)
            {
                _faces.raise(-_best);
            }
        }

        // Tests the piece against the triangles near the structure around it.
        private function meet(structure:BoundingStructure):void
        {
            beginFaces(structure);
            meetFaces();
            meetInside(_piece.point);
        }

        protected function meetFaces():void
        {
            while (!isDone() && _faces.next())
            {
                _piece.setTriangle(_faces.corners, 0);
                _piece.gap = _faces.gap;
                meetFace();
            }
        }

        // A standing piece with a point that is under the ground overlaps it. If the ground is narrower, it must be higher than the point at the
        // four places that are the inset beside it along x and y.
        private function meetInside(point:Vector3D):void
        {
            if (_goal != TIME || _motion !== RelativeMotion.NONE || _isFound)
            {
                return;
            }
            var inset:Number = _faces.inset;
            for (var side:int = inset > 0 ? 0 : 3; side < 4; side++)
            {
                var toX:Number = (side & 1) == 0 ? -inset : inset;
                var toY:Number = (side & 2) == 0 ? -inset : inset;
                _grid.placeX = point.x + _origin.x + toX;
                _grid.placeY = point.y + _origin.y + toY;
                _grid.findHeight();
                if (!(_grid.height - inset >= point.z + _origin.z))
                {
                    return;
                }
            }
            _isFound = true;
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
                found = findDepth();
            }
            if (!(found < _best || found == _best && !_isFound && found < Infinity))
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
            else if (_goal != TIME)
            {
                keepDepth();
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

        // Finds the negative depth for the other goals; Infinity for none.
        protected function findDepth():Number
        {
            return Infinity;
        }

        // Keeps the contact of that depth.
        protected function keepDepth():void
        {
        }
    }
}
