package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.solid.interior.Interior;

    use namespace engine;

    /**
     * Decides whether a part of one model is inside of the other model's closed surface. It is asked only if the two surfaces do not touch,
     * so one point of the part decides. A part that is not closed has no inside.
     *
     * <p>It is asked for all agents that are close but do not touch. So a ray is cast only if the point is in the box around the other model.</p>
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
            var isInA:Boolean = findPartInside(query.a, query.b, query.pose.placement, _point);
            if (!isInA)
            {
                Placement.invert(query.pose.placement, _inverse);
                if (!findPartInside(query.b, query.a, _inverse, _point))
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
        // inner model in the outer model's space.
        private static function findPartInside(outer:ModelTree, inner:ModelTree, pose:Placement, out:Vector3D):Boolean
        {
            var interior:Interior = outer.preparedInterior();
            var points:Vector.<Number> = inner.preparedInterior().partPoints;
            var box:Vector.<Number> = outer.boxTree.boxes;
            for (var at:int = 0; at < points.length && interior.hasClosedShell; at += 3)
            {
                var x:Number = pose.size * points[at];
                var y:Number = pose.size * points[int(at + 1)];
                var z:Number = pose.size * points[int(at + 2)];
                out.x = pose.r00 * x + pose.r01 * y + pose.r02 * z + pose.x;
                out.y = pose.r10 * x + pose.r11 * y + pose.r12 * z + pose.y;
                out.z = pose.r20 * x + pose.r21 * y + pose.r22 * z + pose.z;
                if (Math.abs(out.x - box[0]) <= box[3] && Math.abs(out.y - box[1]) <= box[4] && Math.abs(out.z - box[2]) <= box[5] && interior.isInside(out))
                {
                    return true;
                }
            }
            return false;
        }
    }
}
