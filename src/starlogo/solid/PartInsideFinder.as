package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.solid.interior.Interior;

    use namespace engine;

    /**
     * Finds whether a part of one model is inside of the other model's closed surface. The two surfaces must not touch, so one point of the part
     * decides. A surface that is not closed has no inside.
     *
     * <p>It is asked for all agents that are close but do not touch. So a ray is cast only if the point is in the box around the other model.</p>
     */
    internal final class PartInsideFinder
    {
        // A point of the inner model, in the outer one's space.
        private static const POINT:Vector3D = new Vector3D();

        /**
         * Finds a point of a part of the inner model that is inside of the outer one. Both have triangles.
         *
         * @param pose of the inner model in the outer one's space
         * @param placement of the outer model in the world
         * @param out receives the point twice, in the world, if there is one; null if only the answer is needed
         * @return whether there is one
         */
        public static function find(outer:ModelTree, inner:ModelTree, pose:Placement, placement:Placement, out:ClosestPoints):Boolean
        {
            var point:Vector3D = POINT;
            var interior:Interior = outer.preparedInterior();
            if (!interior.hasClosedShell)
            {
                return false;
            }
            var points:Vector.<Number> = inner.preparedInterior().partPoints;
            var box:Vector.<Number> = outer.boxTree.boxes;
            for (var at:int = 0; at < points.length; at += 3)
            {
                point.x = points[at];
                point.y = points[int(at + 1)];
                point.z = points[int(at + 2)];
                pose.place(point, point);
                if (Math.abs(point.x - box[0]) <= box[3] && Math.abs(point.y - box[1]) <= box[4] && Math.abs(point.z - box[2]) <= box[5]
                        && interior.isInside(point))
                {
                    if (out != null)
                    {
                        out.setPoint(point);
                        out.placePoints(placement);
                    }
                    return true;
                }
            }
            return false;
        }
    }
}
