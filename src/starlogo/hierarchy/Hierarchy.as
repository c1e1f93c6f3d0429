package starlogo.hierarchy
{
    import starlogo.engine;

    use namespace engine;

    /**
     * The tree around a model's items with what its nodes share. For the engine; a client has its root.
     *
     * @private
     */
    public class Hierarchy
    {
        /** @private The node around the whole model. */
        engine var root:HierarchyNode;

        /** @private Which structure each node has: one of BoundingStructure's constants. */
        engine var boundsKind:int;

        /** @private Whether the items are triangles; otherwise they are vertices. */
        engine var hasTriangles:Boolean;

        /** @private The numbers of the triangles or vertices, those of a leaf side by side. */
        engine var order:Vector.<int>;

        /** @private The model's vertices: x, y, z each. */
        engine var vertices:Vector.<Number>;

        /** @private The model's triangles, three vertex indices each; null where only vertices are known. */
        engine var triangles:Vector.<uint>;

        /**
         * Without nodes: a HierarchyBuilder makes them.
         *
         * @param vertices x, y, z each
         * @param triangles three vertex indices each, or null if the vertices are the items
         * @param boundsKind which structure each node has
         */
        public function Hierarchy(vertices:Vector.<Number>, triangles:Vector.<uint>, boundsKind:int)
        {
            this.vertices = vertices;
            this.triangles = triangles;
            this.boundsKind = boundsKind;
            hasTriangles = triangles != null;
        }

        /** @private How many vertices some items have, each counted once. */
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
                    if (isCounted[triangles[corner]] == undefined)
                    {
                        isCounted[triangles[corner]] = true;
                        count++;
                    }
                }
            }
            return count;
        }
    }
}
