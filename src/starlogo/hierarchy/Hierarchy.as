package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * A model's hierarchy with what its nodes share. For the engine; a client has its root.
     *
     * @private
     */
    public final class Hierarchy
    {
        /**
         * The node around the whole model.
         *
         * @private
         */
        engine var root:HierarchyNode;

        /**
         * Which structure each node has: one of BoundingStructure's constants.
         *
         * @private
         */
        engine var boundsKind:int;

        /**
         * Whether the items are triangles; otherwise they are vertices.
         *
         * @private
         */
        engine var hasTriangles:Boolean;

        /**
         * The numbers of the triangles or vertices, those of a leaf side by side.
         *
         * @private
         */
        engine var order:Vector.<int>;

        /**
         * What is known of the surface; null for nothing.
         *
         * @private
         */
        engine var notes:SurfaceNotes = null;

        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;
        private var _solid:Solid = null;

        /** Made by a HierarchyBuilder. */
        public function Hierarchy(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            _vertices = vertices;
            _triangles = triangles;
            hasTriangles = triangles != null;
        }

        /**
         * How many vertices some items have, each counted once.
         *
         * @private
         */
        engine function countVertices(first:int, end:int):int
        {
            if (!hasTriangles)
            {
                return end - first;
            }
            var isCounted:Object = {};
            var count:int = 0;
            for (var i:int = first; i < end; i++)
            {
                var corner:int = 3 * order[i];
                for (var last:int = corner + 3; corner < last; corner++)
                {
                    if (isCounted[_triangles[corner]] == undefined)
                    {
                        isCounted[_triangles[corner]] = true;
                        count++;
                    }
                }
            }
            return count;
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

        /**
         * Sees to it that what exact tests need of the triangles is there.
         *
         * @private
         */
        engine function prepare():void
        {
            if (hasTriangles && _solid == null)
            {
                var builder:SolidBuilder = beginSolid();
                finish(builder);
                takeSolid(builder);
            }
        }

        /**
         * Whether what exact tests need of the triangles is there.
         *
         * @private
         */
        engine function get isPrepared():Boolean
        {
            return _solid != null;
        }

        /** Takes what was prepared. */
        internal function takeSolid(builder:SolidBuilder):void
        {
            _solid = builder.solid;
            notes = builder.notes;
        }

        /** Begins to prepare the solid. */
        internal function beginSolid():SolidBuilder
        {
            return new SolidBuilder(root, _vertices, _triangles, order, notes);
        }
    }
}
