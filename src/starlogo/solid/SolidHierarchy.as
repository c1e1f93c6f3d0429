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
        /** @private The surface, or null if nothing is known of it. */
        engine var surface:Surface = null;

        /** The value of <code>solid</code>, or null if it is not prepared yet. */
        internal var prepared:Solid = null;

        /** Not to be called: a SolidHierarchyBuilder makes it. */
        public function SolidHierarchy(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            super(vertices, triangles);
        }

        /**
         * The triangles as exact tests need them. If the builder has not prepared them, the first call does, which takes tens of
         * milliseconds for thousands of triangles. Only for models with triangles.
         */
        internal function get solid():Solid
        {
            if (prepared == null)
            {
                prepare();
            }
            return prepared;
        }

        /**
         * Whether a ball is inside. The ball must not touch the surface. False if there are no triangles, or if no piece of the surface is closed.
         */
        internal function isInside(middle:Vector3D, radius:Number):Boolean
        {
            return hasTriangles && Math.abs(middle.x - root.x) <= root.halfX - radius && Math.abs(middle.y - root.y) <= root.halfY - radius
                && Math.abs(middle.z - root.z) <= root.halfZ - radius && solid.isInside(middle);
        }

        /** @private The corners of the triangles, in the order of the hierarchy: nine numbers each. Only for models with triangles. */
        engine function get corners():Vector.<Number>
        {
            return solid.corners;
        }

        /** @private Prepares the triangles for exact tests if they are not prepared yet. */
        engine function prepare():void
        {
            if (hasTriangles && prepared == null)
            {
                finish(new SolidBuilder(this));
            }
        }

        /** @private Whether the triangles are prepared for exact tests. */
        engine function get isPrepared():Boolean
        {
            return prepared != null;
        }
    }
}
