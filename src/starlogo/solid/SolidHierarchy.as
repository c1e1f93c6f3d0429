package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.hierarchy.Hierarchy;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * A model's hierarchy with the solid that its triangles make. For the engine.
     *
     * @private
     */
    public final class SolidHierarchy extends Hierarchy
    {
        /** @private What is known of the surface; null for nothing. */
        engine var surface:Surface = null;

        /** What <code>solid</code> returns; null until it is prepared. */
        internal var prepared:Solid = null;

        /** Made by a SolidHierarchyBuilder. */
        public function SolidHierarchy(vertices:Vector.<Number>, triangles:Vector.<uint>, boundsKind:int)
        {
            super(vertices, triangles, boundsKind);
        }

        /**
         * The triangles as exact tests and tests for insides need them. Where the builder has not prepared them, the first call
         * does: that takes tens of milliseconds for thousands of triangles. Only where there are triangles.
         */
        internal function get solid():Solid
        {
            if (prepared == null)
            {
                prepare();
            }
            return prepared;
        }

        /** Whether a ball is inside that does not meet the surface. False where there are no triangles, or the surface is not closed. */
        internal function isInside(middle:Vector3D, radius:Number):Boolean
        {
            return hasTriangles && Math.abs(middle.x - root.x) <= root.halfX - radius && Math.abs(middle.y - root.y) <= root.halfY - radius
                && Math.abs(middle.z - root.z) <= root.halfZ - radius && solid.isInside(middle);
        }

        /** @private The corners of the triangles, in the order of the hierarchy: nine numbers each. Only where there are triangles. */
        engine function get corners():Vector.<Number>
        {
            return solid.corners;
        }

        /** @private Sees to it that what exact tests need of the triangles is there. */
        engine function prepare():void
        {
            if (hasTriangles && prepared == null)
            {
                finish(new SolidBuilder(this));
            }
        }

        /** @private Whether what exact tests need of the triangles is there. */
        engine function get isPrepared():Boolean
        {
            return prepared != null;
        }
    }
}
