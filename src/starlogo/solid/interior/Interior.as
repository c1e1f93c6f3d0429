// The package solid.interior says which points are inside of a model whose triangles come from a file: with seams, holes, shells that overlap and
// cavities. A shell is connected over edges, a part over vertices. Engines whose meshes are hollow need none of it.
// 
// An InteriorBuilder makes an Interior, in steps:
// Welding           finds the vertices that are at the same place
// SurfaceBuilder    finds the SurfaceTopology, with three classes:
// - EdgeMatcher     pairs the triangles that continue each other over an edge
// - ShellFinder     follows these pairs, and so finds the shells
// - CavityFinder    decides which shells bound cavities
// 
// When it is made, the WindingCounter answers. Read Interior first, then WindingCounter, then SurfaceTopology and SurfaceBuilder.

package starlogo.solid.interior
{
    import flash.geom.Vector3D;

    /**
     * What is inside of the surface that a model's triangles make: the surface's parts, and what counts its windings. An InteriorBuilder makes it.
     *
     * @private
     */
    public final class Interior
    {
        /** Counts how often the surface winds around a point. */
        public var windingCounter:WindingCounter;

        /** Whether at least one shell of the surface is closed, so that it has an inside. */
        public var hasClosedShell:Boolean;

        /**
         * A point of each part of the surface: x, y, z. A part is connected. So a part that does not touch another surface is inside or outside of it as a
         * whole, and its point decides. Of parts that overlap there is one: it stands for the others.
         */
        public var partPoints:Vector.<Number>;

        /**
         * @param windingCounter counts the windings of a complete surface
         * @param partPoints a point of each part
         */
        public function Interior(windingCounter:WindingCounter, partPoints:Vector.<Number>)
        {
            this.windingCounter = windingCounter;
            this.partPoints = partPoints;
            hasClosedShell = windingCounter.surface.hasClosedShell;
        }

        /** Whether a point is inside. The point must not be on the surface. */
        public function isInside(point:Vector3D):Boolean
        {
            return hasClosedShell && windingCounter.isInside(point);
        }
    }
}
