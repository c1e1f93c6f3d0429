package starlogo.solid
{
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
        engine var notes:SurfaceNotes = null;

        private var _solid:Solid = null;

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
            if (_solid == null)
            {
                prepare();
            }
            return _solid;
        }

        /** @private Sees to it that what exact tests need of the triangles is there. */
        engine function prepare():void
        {
            if (hasTriangles && _solid == null)
            {
                finish(new SolidBuilder(this));
            }
        }

        /** @private Whether what exact tests need of the triangles is there. */
        engine function get isPrepared():Boolean
        {
            return _solid != null;
        }

        /** Keeps what was prepared. */
        internal function setSolid(solid:Solid, notes:SurfaceNotes):void
        {
            _solid = solid;
            this.notes = notes;
        }
    }
}
