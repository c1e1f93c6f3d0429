package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.hierarchy.Hierarchy;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * A model's hierarchy, together with the solid that its triangles make. For the engine.
     *
     * @private
     */
    public final class SolidHierarchy extends Hierarchy
    {
        private static const OPEN:AxisEscapeTest = new AxisEscapeTest();

        /** @private The surface, or null if nothing is known of it. */
        engine var surface:SurfaceTopology = null;

        /** The value of <code>solid</code>, or null if that is not prepared yet. */
        internal var readySolid:Solid = null;

        /** The value of <code>facets</code>, or null if that is not prepared yet. */
        internal var readyFacets:Solid = null;

        public function SolidHierarchy(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            super(vertices, triangles);
        }

        /**
         * The triangles and their inside, as exact tests need them. If the builder has not prepared them, the first call does, which takes
         * tens of milliseconds for tens of thousands of triangles. Only for models with triangles.
         */
        internal function get solid():Solid
        {
            if (readySolid == null)
            {
                prepare();
            }
            return readySolid;
        }

        /** The triangles, perhaps without their inside. Preparing them takes less than half as long as <code>solid</code>. */
        internal function get facets():Solid
        {
            if (readyFacets == null)
            {
                finish(new TrianglesBuilder(this));
            }
            return readyFacets;
        }

        /**
         * Whether a ball is inside. The ball must not touch the surface. False if there are no triangles, or if no piece of the surface is
         * closed.
         */
        internal function isInside(middle:Vector3D, radius:Number):Boolean
        {
            var isOutside:Boolean = !hasTriangles || Math.abs(middle.x - root.x) > root.halfX - radius
                || Math.abs(middle.y - root.y) > root.halfY - radius || Math.abs(middle.z - root.z) > root.halfZ - radius;
            if (!isOutside && readySolid == null)
            {
                isOutside = OPEN.hasOpenSide(middle, root, facets.tree);
            }
            return !isOutside && solid.isInside(middle);
        }

        /**
         * Writes the places to which a triangle's corners are welded.
         *
         * @param corner the index of the triangle's first corner
         * @param welded for each vertex, the vertex whose place it has
         * @param out receives nine numbers
         * @param to the index of the first
         */
        internal function writeCorners(corner:int, welded:Vector.<int>, out:Vector.<Number>, to:int):void
        {
            for (var end:int = corner + 3; corner < end; corner++)
            {
                var at:int = 3 * welded[triangles[corner]];
                out[to] = vertices[at];
                out[int(to + 1)] = vertices[int(at + 1)];
                out[int(to + 2)] = vertices[int(at + 2)];
                to += 3;
            }
        }

        /** @private The corners of the triangles, in the order of the hierarchy: nine numbers each. Only for models with triangles. */
        engine function get corners():Vector.<Number>
        {
            return facets.corners;
        }

        /** @private Prepares the triangles for exact tests if they are not prepared yet. */
        engine function prepare():void
        {
            if (hasTriangles && readySolid == null)
            {
                finish(new SolidBuilder(this));
            }
        }

        /** @private Whether the triangles are prepared for exact tests. */
        engine function get isPrepared():Boolean
        {
            return readySolid != null;
        }
    }
}
