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
    public final class TerrainPair extends GroundSearch
    {
        private var _placement:Placement;

        /** No model yet. */
        public function TerrainPair()
        {
        }

        /**
         * Sets the two.
         *
         * @param grid the ground
         * @param tree the model's hierarchy; null if a structure represents it
         * @param structure the structure, or the one around the tree, in the model's space
         * @param placement where the model stands
         * @param depth how many levels of the tree are visited
         * @param exact whether, if the tree has triangles, depths do not count and triangles decide
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
            // as if another agent stood where it touches
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
            best = 1;
            run(TIME, motion);
            motion.time = isFound ? best : RelativeMotion.NEVER;
            if (isFound && out != null)
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

        // From the lowest place of the model to the ground over or under its middle: there may be higher ground beside it.
        private function findWayUp(out:ContactPoint):void
        {
            var box:PassingBox = nodeFaces.box;
            writeBox(structure, box);
            grid.placeX = box.x;
            grid.placeY = box.y;
            grid.findHeight();
            out.setNormal(0, 0, 1);
            // 0 for NaN
            out.depth = grid.height > box.z - box.halfZ ? grid.height - box.z + box.halfZ : 0;
            out.x = box.x;
            out.y = box.y;
            out.z = box.z - box.halfZ + out.depth / 2;
        }

        // No less than how far the two are apart: as far as the nearest height is from the middle of the model, and how far that reaches.
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
