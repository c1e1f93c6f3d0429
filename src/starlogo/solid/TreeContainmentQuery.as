package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.solid.interior.Interior;
    import starlogo.solid.interior.OutermostPoints;

    use namespace engine;

    /**
     * Decides whether a part of one model is inside of the other model's closed surface. It is asked only if the two surfaces do not touch,
     * so one point of the part decides. A part that is not closed has no inside.
     *
     * <p>It is asked for all agents that are close but do not touch, so it must mostly end after a few products. If a part is inside, its
     * outermost points are inside of the box around the other model. A ray is cast only for parts that pass this test.</p>
     */
    internal final class TreeContainmentQuery
    {
        // A point of one model, in the space of the model that may be around it.
        private var _point:Vector3D = new Vector3D();

        private var _inverse:Placement = new Placement();

        /**
         * Finds a point of a part of one model that is inside of the other. There is none if a tree has no triangles. The surfaces must not touch, and
         * the boxes of the two roots must overlap.
         *
         * @param out receives the point twice, in the world, if there is one; null if only the answer is needed
         * @return whether there is one
         */
        public function findInside(pair:TwoTrees, out:ClosestPoints):Boolean
        {
            var outer:Placement = findOuter(pair);
            if (outer != null && out != null)
            {
                out.setPoint(_point);
                out.placePoints(outer);
            }
            return outer != null;
        }

        // Returns the placement of the tree that has a part of the other one inside; null if none has.
        private function findOuter(pair:TwoTrees):Placement
        {
            if (!pair.a.hasTriangles || !pair.b.hasTriangles)
            {
                return null;
            }
            var insideA:Interior = pair.a.interior;
            var insideB:Interior = pair.b.interior;
            var treeA:BoxTree = pair.a.boxTree;
            var treeB:BoxTree = pair.b.boxTree;
            var pose:Placement = pair.pose.placement;
            var size:Number = pose.size;
            if (insideA.hasClosedShell && insideB.leastPartExtent * size <= 2 * treeA.radius && findPartInside(treeA, insideA, insideB, pose))
            {
                return pair.placementA;
            }
            if (!insideB.hasClosedShell || insideA.leastPartExtent > 2 * treeB.radius * size)
            {
                return null;
            }
            Placement.invert(pose, _inverse);
            return findPartInside(treeB, insideB, insideA, _inverse) ? pair.placementB : null;
        }

        // Finds a point of a part of the inner model that is inside of the outer one. Returns whether there is such a point. The pose is that of the
        // inner model in the outer model's space, and the tree is the outer one's.
        private function findPartInside(tree:BoxTree, outer:Interior, inner:Interior, pose:Placement):Boolean
        {
            var points:Vector.<Number> = inner.partPoints;
            for (var end:int = OutermostPoints.STRIDE; end <= points.length; end += OutermostPoints.STRIDE)
            {
                var at:int = end - OutermostPoints.STRIDE;
                while (at < end && moveInto(tree.boxes, pose, points, at))
                {
                    at += 3;
                }
                if (at == end && outer.isInside(_point))
                {
                    return true;
                }
            }
            return false;
        }

        // Sets _point to a point, moved by a pose, if it is then in the box of the root. Returns whether it is. Most points are outside along x.
        private function moveInto(box:Vector.<Number>, pose:Placement, points:Vector.<Number>, at:int):Boolean
        {
            var scale:Number = pose.size;
            var px:Number = points[at];
            var py:Number = points[int(at + 1)];
            var pz:Number = points[int(at + 2)];
            var x:Number = pose.r00 * scale * px + pose.r01 * scale * py + pose.r02 * scale * pz + (pose.x - box[0]);
            if (x > box[3] || x < -box[3])
            {
                return false;
            }
            var y:Number = pose.r10 * scale * px + pose.r11 * scale * py + pose.r12 * scale * pz + (pose.y - box[1]);
            if (y > box[4] || y < -box[4])
            {
                return false;
            }
            var z:Number = pose.r20 * scale * px + pose.r21 * scale * py + pose.r22 * scale * pz + (pose.z - box[2]);
            if (z > box[5] || z < -box[5])
            {
                return false;
            }
            _point.setTo(x + box[0], y + box[1], z + box[2]);
            return true;
        }
    }
}
