package starlogo.solid
{
    import flash.geom.Vector3D;

    /** What is inside of the surface that a model's triangles make: the surface's parts, and what counts its windings. An InteriorBuilder makes it. */
    internal final class Interior
    {
        /** Counts how often the surface winds around a point. */
        public var windingCounter:WindingCounter;

        /** Whether at least one shell of the surface is closed, so that it has an inside. */
        public var hasClosedShell:Boolean;

        /**
         * For each part of the surface, the vertices with the smallest and largest x, y and z. A part is connected, or overlaps itself. So a
         * part that does not touch another surface is inside or outside of it as a whole, or that surface is inside of the part.
         */
        public var partPoints:Vector.<Number>;

        /** The extent of the smallest part: the longest of its three extents. */
        public var leastPartExtent:Number;

        /**
         * @param windingCounter counts the windings of a complete surface
         * @param parts the outermost points of its parts
         */
        public function Interior(windingCounter:WindingCounter, parts:OutermostPoints)
        {
            this.windingCounter = windingCounter;
            hasClosedShell = windingCounter.surface.hasClosedShell;
            partPoints = parts.points;
            leastPartExtent = parts.leastExtent;
        }

        /** Whether a point is inside. The point must not be on the surface. */
        public function isInside(point:Vector3D):Boolean
        {
            return hasClosedShell && windingCounter.isInside(point);
        }
    }
}
