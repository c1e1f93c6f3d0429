package starlogo.terrain
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
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
    public final class TerrainPair extends GroundSearch
    {
        private var _placement:Placement;

        /** Creates a test without a model. */
        public function TerrainPair()
        {
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
            this.grid = grid;
            this.tree = tree;
            this.structure = structure;
            _placement = placement;
            isExact = tree != null && exact && tree.hasTriangles;
            this.depth = isExact ? int.MAX_VALUE : depth;
            corners = isExact ? tree.corners : null;
            // The margin is as large as if another agent stood at the place of the touch.
            margin = 2 * Tolerances.PLACES * (Math.abs(placement.x) + Math.abs(placement.y) + Math.abs(placement.z));
            gap = 0;
            faces.inset = nodeFaces.inset = inset;
        }

        /**
         * Whether a structure in the world overlaps the ground, or touches it across a gap.
         *
         * @param extents of the structure, by row
         */
        public function isOverlapping(grid:HeightGrid, structure:BoundingStructure, extents:Extents, row:int):Boolean
        {
            var box:PassingBox = faces.box;
            this.grid = grid;
            faces.inset = inset;
            goal = OVERLAP;
            box.x = extents.x[row];
            box.y = extents.y[row];
            box.z = extents.z[row];
            box.halfX = extents.halfX[row] + gap;
            box.halfY = extents.halfY[row] + gap;
            box.halfZ = extents.halfZ[row] + gap;
            piece.setPlaced(structure);
            meet();
            return isFound;
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
            moveTo(motion, 0);
            best = 1;
            run(TIME, motion);
            motion.time = isFound ? best : RelativeMotion.NEVER;
            if (isFound && out != null)
            {
                findContactOfBest(out);
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
            moveTo(motion, time);
            if (!findDeepest(out))
            {
                findWayUp(out);
            }
        }

        /** Finds the contact that lifts the standing model above the ground at its middle. */
        public function findOuterContact(out:ContactPoint):void
        {
            moveTo(RelativeMotion.NONE, 0);
            findWayUp(out);
        }

        /**
         * Finds how far the two are apart where the model stands, and between which points.
         *
         * @param areTouching whether they overlap. If so, a point of both is found
         */
        public function findClosest(areTouching:Boolean, out:ClosestPair):void
        {
            moveTo(RelativeMotion.NONE, 0);
            if (areTouching)
            {
                if (!findDeepest(tried))
                {
                    findWayUp(tried);
                }
                out.aX = out.bX = tried.x;
                out.aY = out.bY = tried.y;
                out.aZ = out.bZ = tried.z;
            }
            else
            {
                best = findBound();
                run(CLOSEST, RelativeMotion.NONE);
                bestPiece.writeClosest(out);
            }
            out.settle(areTouching);
        }

        private function moveTo(motion:RelativeMotion, time:Number):void
        {
            placed.copyFrom(_placement);
            placed.x += motion.startX + time * motion.x;
            placed.y += motion.startY + time * motion.y;
            placed.z += motion.startZ + time * motion.z;
        }

        private function overlapsAt(motion:RelativeMotion, time:Number):Boolean
        {
            moveTo(motion, time);
            run(OVERLAP, RelativeMotion.NONE);
            return isFound;
        }

        private function findDeepest(out:ContactPoint):Boolean
        {
            best = Infinity;
            run(CONTACT, RelativeMotion.NONE);
            if (isFound)
            {
                findContactOfBest(out);
            }
            return isFound;
        }

        // Finds the way from the model's lowest place up to the ground at the model's middle. There may be higher ground beside it.
        private function findWayUp(out:ContactPoint):void
        {
            var box:PassingBox = nodeFaces.box;
            writeBox(structure, box);
            grid.placeX = box.x;
            grid.placeY = box.y;
            grid.findHeight();
            out.setNormal(0, 0, 1);
            // If the height is NaN, the depth is 0.
            out.depth = grid.height > box.z - box.halfZ ? grid.height - box.z + box.halfZ : 0;
            out.x = box.x;
            out.y = box.y;
            out.z = box.z - box.halfZ + out.depth / 2;
        }

        // An upper bound of the distance of the two: the distance from the model's middle to the nearest height, plus how far the model
        // extends.
        private function findBound():Number
        {
            var box:PassingBox = nodeFaces.box;
            writeBox(structure, box);
            var width:Number = grid.cellWidth;
            var column:int = Math.max(0, Math.min(grid.columns - 1, Math.round((box.x - grid.x) / width)));
            var row:int = Math.max(0, Math.min(grid.rows - 1, Math.round((box.y - grid.y) / width)));
            var toX:Number = grid.x + column * width - box.x;
            var toY:Number = grid.y + row * width - box.y;
            var toZ:Number = grid.heights[row * grid.columns + column] - box.z;
            return Tolerances.OUTER * (Math.sqrt(toX * toX + toY * toY + toZ * toZ) + box.halfX + box.halfY + box.halfZ);
        }
    }
}
