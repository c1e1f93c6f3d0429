package starlogo.libraries
{
    import starlogo.engine;
    import starlogo.geometry.vertices.triangleProblem;
    import starlogo.geometry.vertices.vertexProblem;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.BoxTreeBuilder;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.models.Model;
    import starlogo.solid.ModelTree;

    use namespace engine;

    /**
     * The hierarchy of boxes of each model, found by the name of its shape (thesis §4.3, §4.4). The hierarchy is built when a
     * model is added. A setting that you change counts for models that are added afterwards.
     *
     * <p>The thesis builds hierarchies from vertices, and their boxes have holes. For example, a wall has four vertices. Below the first
     * split no box covers its middle. This library divides the triangles of a model, if it has any. The box of a node then encloses all
     * triangles of the node completely. So every level covers the whole surface. See HierarchyNode.</p>
     *
     * <p>The nodes are shared by all agents of a shape: do not change them.</p>
     */
    public final class HierarchiesLibrary
    {
        /**
         * Whether a node is split at a mean along the longest axis of its box: the mean of its vertices, or of the middles of its
         * triangles' boxes. Otherwise it is split halfway along that axis (§4.4).
         */
        public var splitByMean:Boolean = false;

        /**
         * Whether a model's surface is prepared for exact colliders when the model is added. Then loading takes longer, but no frame of
         * the game takes longer. Otherwise it is prepared during the game, when a collider first needs it: see
         * <code>GreatLand.prepareExact</code>.
         */
        public var prepareExact:Boolean = false;

        /** @private What was computed for each shape. The libraries of a GreatLand share its table. */
        engine var models:ModelTable = new ModelTable();

        private var _minVerticesToSplit:int = BoxTreeBuilder.DEFAULT_LEAF_VERTICES;
        private var _maxDepth:int = BoxTreeBuilder.DEFAULT_DEPTH;

        /** Creates a library without models. */
        public function HierarchiesLibrary()
        {
        }

        /**
         * A node with at most this many vertices is a leaf (§4.4). In another place the thesis splits a node with exactly this many (§4.8).
         * A single triangle is always a leaf, and so are several vertices in one place, or triangles whose boxes have the same middle. A
         * vertex that several triangles of the node share counts once. The default is 5.
         *
         * @throws RangeError if you set it to less than 1
         */
        public function get minVerticesToSplit():int
        {
            return _minVerticesToSplit;
        }

        public function set minVerticesToSplit(value:int):void
        {
            requirePositive("minVerticesToSplit", value);
            _minVerticesToSplit = value;
        }

        /**
         * A node on this level is a leaf (§4.4). The root is on level 1. The default is 10.
         *
         * @throws RangeError if you set it to less than 1
         */
        public function get maxDepth():int
        {
            return _maxDepth;
        }

        public function set maxDepth(value:int):void
        {
            requirePositive("maxDepth", value);
            _maxDepth = value;
        }

        /**
         * Builds and stores the hierarchy of a model. It replaces the one stored under the same name. If it throws, nothing has changed.
         * The time is proportional to the number of triangles or vertices times the number of levels.
         *
         * <p>If the vertices are the list <code>vertices</code> of the GreatLand's model of this name, the hierarchy follows its poses. If
         * the triangles are the model's list, hits tell their materials and meshes. Otherwise the lists are copied.</p>
         *
         * @param name the shape's name
         * @param vertices x, y, z of each vertex, in the model's space
         * @param triangles three vertex indices each; null or empty if only vertices are known. Triangles without area are allowed
         * @throws ArgumentError if the name is null or empty; if the vertices are null or empty, or a coordinate is missing, not finite or beyond 1e60;
         * if a triangle names a vertex that does not exist
         */
        public function add(name:String, vertices:Vector.<Number>, triangles:Vector.<uint> = null):void
        {
            ModelTable.requireName(name);
            var hasTriangles:Boolean = triangles != null && triangles.length > 0;
            var problem:String = vertexProblem(vertices) || (hasTriangles ? triangleProblem(triangles, vertices.length / 3) : null);
            if (problem != null)
            {
                throw ModelTable.errorOf(name, problem);
            }
            ModelTable.requireCoordinates(name, vertices);
            var entry:ModelEntry = models.entryOf(name);
            var model:Model = entry.model;
            var keptVertices:Vector.<Number> = model != null && vertices == model.vertices ? vertices : vertices.concat();
            var keptTriangles:Vector.<uint> = model != null && triangles == model.triangles ? triangles : (hasTriangles ? triangles.concat() : null);
            var tree:ModelTree = newTree(keptVertices, keptTriangles);
            tree.finishBuilding();
            models.entryToWrite(name).replace(model, entry.structures, tree);
        }

        /** Whether the library has a hierarchy for a shape. */
        public function has(name:String):Boolean
        {
            return models.entryOf(name).tree != null;
        }

        /**
         * The root of a shape's hierarchy: the node around the whole model.
         *
         * @throws ArgumentError if the library has nothing of this name
         */
        public function root(name:String):HierarchyNode
        {
            return treeOf(name).root;
        }

        /**
         * The tree whose nodes are the hierarchy of a shape. If it is not built yet, it is built now.
         *
         * @throws ArgumentError if the library has nothing of this name
         *
         * @private
         */
        engine function treeOf(name:String):ModelTree
        {
            if (!has(name))
            {
                throw models.missing("hierarchy", name, "loadHierarchies");
            }
            return models.entryOf(name).builtTree();
        }

        /** @private A tree whose nodes are not made yet. The work that makes them is begun, by the settings as they are now. Both lists are kept. */
        engine function newTree(vertices:Vector.<Number>, triangles:Vector.<uint>):ModelTree
        {
            var tree:ModelTree = new ModelTree(new BoxTree(vertices, triangles));
            tree.beginBuilding(minVerticesToSplit, maxDepth, splitByMean, prepareExact);
            return tree;
        }

        private static function requirePositive(setting:String, value:int):void
        {
            if (value < 1)
            {
                throw new RangeError(setting + " must be at least 1: " + value);
            }
        }
    }
}
