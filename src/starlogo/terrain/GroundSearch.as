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
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.solid.SolidHierarchy;

    use namespace engine;

    /**
     * Tests the convex pieces of a model against the triangles of the ground near each piece, with one of four goals. The pieces are the
     * model's structure, or the structures or triangles of its tree.
     */
    internal class GroundSearch
    {
        // The goals: whether a piece overlaps the ground; when a piece first touches the surface; the deepest contact; the closest points.
        protected static const OVERLAP:int = 0;
        protected static const TIME:int = 1;
        protected static const CONTACT:int = 2;
        protected static const CLOSEST:int = 3;

        /** How far the surface of the ground is moved inwards. */
        public var inset:Number = 0;

        /** The largest gap across which a structure still touches the ground. Input of <code>isOverlapping()</code>. */
        public var gap:Number = 0;

        protected var grid:HeightGrid;
        protected var tree:SolidHierarchy;
        protected var structure:BoundingStructure;
        protected var depth:int;
        protected var corners:Vector.<Number>;
        protected var isExact:Boolean;

        // The model's placement at the current time, and the margin by which the model is enlarged.
        protected var placed:Placement = new Placement();
        protected var margin:Number = 0;

        protected var goal:int = 0;
        private var _motion:RelativeMotion;

        // The result: whether anything was found; the time, the distance or the negative depth. The current piece, the best piece and its
        // triangle.
        protected var isFound:Boolean = false;
        protected var best:Number = 0;
        protected var piece:GroundPiece = new GroundPiece();
        protected var bestPiece:GroundPiece = new GroundPiece();
        private var _bestFace:Vector.<Number> = new Vector.<Number>(9, true);
        protected var tried:ContactPoint = new ContactPoint();

        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);
        protected var faces:GroundFaces = new GroundFaces();
        protected var nodeFaces:GroundFaces = new GroundFaces();

        /** Creates a search without a model. */
        public function GroundSearch()
        {
        }

        protected final function run(goal:int, motion:RelativeMotion):void
        {
            this.goal = goal;
            _motion = motion;
            isFound = false;
            if (tree == null)
            {
                meetStructure(structure);
            }
            else
            {
                visit(tree.root);
            }
        }

        private function visit(node:HierarchyNode):void
        {
            if (isDone() || !isNear(node))
            {
                return;
            }
            if (node.cutoffLevel < depth)
            {
                visit(node.low);
                visit(node.high);
                return;
            }
            if (!isExact)
            {
                meetStructure(structureOf(node));
                return;
            }
            // The nodes are enlarged by more than this, so they still contain the triangles.
            var reach:Number = margin + Tolerances.SURFACES / 2 * tree.root.radius * placed.size;
            for (var i:int = node.first; i < node.end && !isDone(); i++)
            {
                piece.setTriangle(corners, 9 * i, placed, reach);
                piece.writeBox(faces.box);
                meet();
            }
        }

        // Whether nothing better can be found.
        private function isDone():Boolean
        {
            return isFound && (goal == OVERLAP || goal == TIME && best == 0);
        }

        // The structure around a node and its descendants.
        private function structureOf(node:HierarchyNode):BoundingStructure
        {
            if (tree.boundsKind != BoundingStructure.BOX)
            {
                return node.cover || node.structure;
            }
            return node.writeBox(_box);
        }

        // Whether the surface comes near a node. If it does not, and the node is under the ground, the node overlaps the ground.
        private function isNear(node:HierarchyNode):Boolean
        {
            var box:PassingBox = nodeFaces.box;
            writeBox(structureOf(node), box);
            beginFaces(nodeFaces);
            if (nodeFaces.next())
            {
                return true;
            }
            if (goal == OVERLAP)
            {
                grid.placeX = box.x;
                grid.placeY = box.y;
                grid.findHeight();
                isFound = grid.height >= box.z;
            }
            return false;
        }

        // Sets a box to the extents of a structure at the model's current placement.
        protected final function writeBox(structure:BoundingStructure, box:PassingBox):void
        {
            structure.turnedExtentsInto(placed, _extents);
            box.x = _extents[0] + placed.x;
            box.y = _extents[1] + placed.y;
            box.z = _extents[2] + placed.z;
            box.halfX = _extents[3] + margin;
            box.halfY = _extents[4] + margin;
            box.halfZ = _extents[5] + margin;
        }

        // Begins with the standing box. Extends it along its way, or to all sides, as far as something better may be found.
        private function beginFaces(of:GroundFaces):void
        {
            var box:PassingBox = of.box;
            var isMoving:Boolean = goal == TIME;
            box.wayX = isMoving ? _motion.x : 0;
            box.wayY = isMoving ? _motion.y : 0;
            box.wayZ = isMoving ? _motion.z : 0;
            box.limit = isMoving ? best : 0;
            if (goal == CLOSEST)
            {
                box.halfX += best;
                box.halfY += best;
                box.halfZ += best;
            }
            of.begin(grid);
        }

        private function meetStructure(structure:BoundingStructure):void
        {
            piece.setStructure(structure, placed, margin);
            writeBox(structure, faces.box);
            meet();
        }

        /** Tests the piece against the surface near it. The box of <code>faces</code> must be the box around the piece. */
        protected final function meet():void
        {
            var isBetter:Boolean = false;
            beginFaces(faces);
            if (goal != OVERLAP)
            {
                piece.begin(_motion);
            }
            while (faces.next())
            {
                piece.gap = faces.gap + gap;
                if (goal == OVERLAP)
                {
                    isFound = piece.touches(faces.corners);
                    if (isFound)
                    {
                        return;
                    }
                }
                else if (isBetterFace())
                {
                    isBetter = isFound = true;
                    for (var i:int = 0; i < 9; i++)
                    {
                        _bestFace[i] = faces.corners[i];
                    }
                }
            }
            if (goal == OVERLAP)
            {
                isFound = piece.isUnder(grid);
            }
            if (isBetter)
            {
                var other:GroundPiece = bestPiece;
                bestPiece = piece;
                piece = other;
            }
        }

        // Whether a triangle is better than all before it. The first triangle found may also be only as good as the bound at the beginning.
        private function isBetterFace():Boolean
        {
            var found:Number = Infinity;
            if (goal == TIME)
            {
                piece.time = best;
                piece.findTime(faces.corners);
                found = piece.time;
            }
            else if (goal == CLOSEST)
            {
                piece.measure(faces.corners);
                found = piece.distance;
            }
            else if (piece.touches(faces.corners))
            {
                piece.time = 0;
                piece.findContact(faces.corners, tried);
                found = -tried.depth;
            }
            if (!(found < best || found == best && !isFound))
            {
                return false;
            }
            best = found;
            if (goal == TIME)
            {
                faces.box.limit = found;
            }
            return true;
        }

        protected final function findContactOfBest(out:ContactPoint):void
        {
            bestPiece.time = goal == TIME ? best : 0;
            bestPiece.findContact(_bestFace, out);
        }
    }
}
