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
         * Finds a point of a part of one model that is inside of the other. There is none if a tree has no triangles. The surfaces must not touch. If
         * the boxes of the two roots are apart, the insides are prepared in vain.
         *
         * @param out receives the point twice, in the world, if there is one; null if only the answer is needed
         * @return whether there is one
         */
        public function findInside(query:TreeTreeQuery, out:ClosestPoints):Boolean
        {
            if (!query.a.hasTriangles || !query.b.hasTriangles)
            {
                return false;
            }
            var insideA:Interior = query.a.preparedInterior();
            var insideB:Interior = query.b.preparedInterior();
            var treeA:BoxTree = query.a.boxTree;
            var treeB:BoxTree = query.b.boxTree;
            var pose:Placement = query.pose.placement;
            var size:Number = pose.size;
            var isInA:Boolean = insideA.hasClosedShell && insideB.leastPartExtent * size <= 2 * treeA.radius
                && findPartInside(treeA, insideA, insideB, pose, _point);
            if (!isInA)
            {
                if (!insideB.hasClosedShell || insideA.leastPartExtent > 2 * treeB.radius * size)
                {
                    return false;
                }
                Placement.invert(pose, _inverse);
                if (!findPartInside(treeB, insideB, insideA, _inverse, _point))
                {
                    return false;
                }
            }
            if (out != null)
            {
                out.setPoint(_point);
                out.placePoints(isInA ? query.placementA : query.placementB);
            }
            return true;
        }

        // Finds a point of a part of the inner model that is inside of the outer one. Returns whether there is such a point. The pose is that of the
        // inner model in the outer model's space, and the tree is the outer one's.
        private static function findPartInside(tree:BoxTree, outer:Interior, inner:Interior, pose:Placement, out:Vector3D):Boolean
        {
            var points:Vector.<Number> = inner.partPoints;
            for (var at:int = 0; at < points.length; at += OutermostPoints.STRIDE)
            {
                if (placeIfInBox(points, at, pose, tree.boxes, out) && outer.isInside(out))
                {
                    return true;
                }
            }
            return false;
        }

        // Places the outermost points of a part by a pose, until one is outside of the box of the root. Returns whether all are inside; the last one is
        // written then. Most points are outside along x.
        private static function placeIfInBox(points:Vector.<Number>, first:int, pose:Placement, box:Vector.<Number>, out:Vector3D):Boolean
        {
            var scale:Number = pose.size;
            var x:Number;
            var y:Number;
            var z:Number;
            for (var at:int = first; at < first + OutermostPoints.STRIDE; at += 3)
            {
                var px:Number = points[at];
                var py:Number = points[int(at + 1)];
                var pz:Number = points[int(at + 2)];
                x = pose.r00 * scale * px + pose.r01 * scale * py + pose.r02 * scale * pz + (pose.x - box[0]);
                if (x > box[3] || x < -box[3])
                {
                    return false;
                }
                y = pose.r10 * scale * px + pose.r11 * scale * py + pose.r12 * scale * pz + (pose.y - box[1]);
                if (y > box[4] || y < -box[4])
                {
                    return false;
                }
                z = pose.r20 * scale * px + pose.r21 * scale * py + pose.r22 * scale * pz + (pose.z - box[2]);
                if (z > box[5] || z < -box[5])
                {
                    return false;
                }
            }
            out.setTo(x + box[0], y + box[1], z + box[2]);
            return true;
        }
    }
}
