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
     * Goes through the convex pieces of a model, which are one structure or those of its tree, and the triangles of the ground near each, with one of four
     * goals.
     */
    internal class GroundSearch
    {
        // What is looked for: whether a piece overlaps the ground; when one first touches the surface; the deepest contact; the closest points.
        protected static const OVERLAP:int = 0;
        protected static const TIME:int = 1;
        protected static const CONTACT:int = 2;
        protected static const CLOSEST:int = 3;

        /** How far the surface of the ground is moved inwards. */
        public var inset:Number = 0;

        /** For <code>isOverlapping()</code>: the gap. */
        public var gap:Number = 0;

        protected var grid:HeightGrid;
        protected var tree:SolidHierarchy;
        protected var structure:BoundingStructure;
        protected var depth:int;
        protected var corners:Vector.<Number>;
        protected var isExact:Boolean;

        // Where the model is at the time under way, and how much wider it is.
        protected var placed:Placement = new Placement();
        protected var margin:Number = 0;

        protected var goal:int = 0;
        private var _motion:RelativeMotion;

        // What was found: whether there is anything; the time, the distance, or the depth below 0; the piece and the triangle.
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

        /** No model yet. */
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
            // less than the nodes are wider than the triangles
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

        // Around a node and its descendants.
        private function structureOf(node:HierarchyNode):BoundingStructure
        {
            if (tree.boundsKind != BoundingStructure.BOX)
            {
                return node.cover || node.structure;
            }
            return node.writeBox(_box);
        }

        // Whether the surface comes near a node. One away from it that is under the ground overlaps it.
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

        // Makes a box the extents of a structure where the model stands.
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

        // Begins with the box that stands: as far on its way, or as far around it, as something better may be found.
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

        /** The piece with the surface near it; the box is that around the piece. */
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

        // Whether a triangle is better than all before, or as good as the bound that there is at the beginning.
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
