package starlogo.hierarchy
{
    import starlogo.engine;

    use namespace engine;

    /**
     * A model's hierarchy as the engine uses it: the root, and the data that all nodes share. Clients see the root only.
     *
     * @private
     */
    public class Hierarchy
    {
        /** @private The node around the whole model. */
        engine var root:HierarchyNode;

        /** @private Whether the items are triangles; otherwise they are vertices. */
        engine var hasTriangles:Boolean;

        /** @private The indices of the triangles or vertices. The indices of a leaf stand side by side. */
        engine var order:Vector.<int>;

        /** @private The model's vertices: x, y, z of each. */
        engine var vertices:Vector.<Number>;

        /** @private The model's triangles, three vertex indices each; null if only vertices are known. */
        engine var triangles:Vector.<uint>;

        /** @private The measured triangles, until they are divided for exact tests; null if they are not measured. */
        engine var items:TreeItems = null;

        /** @private The boxes down to a few triangles each, or null if they are not prepared. */
        engine var tree:PackedTree = null;

        /**
         * Creates a hierarchy without nodes. A HierarchyBuilder makes them.
         *
         * @param vertices x, y, z of each
         * @param triangles three vertex indices each, or null if the vertices are the items
         */
        public function Hierarchy(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            this.vertices = vertices;
            this.triangles = triangles;
            hasTriangles = triangles != null;
        }

        /** @private The number of vertices of some items. Each vertex is counted once. */
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
