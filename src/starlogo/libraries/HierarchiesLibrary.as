package starlogo.libraries
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.VertexData;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.models.Model;
    import starlogo.solid.SolidHierarchy;
    import starlogo.solid.SolidHierarchyBuilder;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * The hierarchy of bounding structures of each model, by the name of its shape (thesis §4.3, §4.4). A model's hierarchy
     * is built when it is added; what is set here later counts for models added from then on.
     *
     * <p>The thesis builds hierarchies of a model's vertices. Their boxes leave holes: a wall is four vertices, and below
     * the first split nothing covers its middle. Where a model has triangles, they are what is divided here, and the box
     * of a node encloses the whole triangles under it: no level misses a part of the surface. See HierarchyNode.</p>
     *
     * <p>The nodes are the library's own, shared by every agent of the shape: do not change them.</p>
     */
    public final class HierarchiesLibrary
    {
        /**
         * Whether a node is split at the mean of its vertices along the longest axis of its box, or of its triangles'
         * centres, rather than at the halfway point of that axis (§4.4).
         */
        public var splitByMean:Boolean = false;

        /**
         * Whether what exact colliders need of a model's triangles is prepared when the model is added, rather than when an
         * exact collider, or one of models that are close, first meets the model. Then a load takes longer, and no frame does.
         */
        public var prepareExact:Boolean = false;

        /**
         * What is known of each shape; both libraries of a GreatLand share it.
         *
         * @private
         */
        engine var shapes:ShapeTable = new ShapeTable();

        private var _minVerticesToSplit:int = 5;
        private var _maxDepth:int = 10;
        private var _boundsKind:int = BoundingStructure.BOX;

        /** A library without models. */
        public function HierarchiesLibrary()
        {
        }

        /**
         * A node of no more vertices than this is a leaf (§4.4; §4.8 would split one of just as many), and so is a single
         * triangle. The vertices of a node's triangles count once each. The default is 5.
         *
         * @throws RangeError if it is set to less than 1
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
         * A node on this level is a leaf (§4.4); the root is on level 1. The default is 10.
         *
         * @throws RangeError if it is set to less than 1
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
         * Which kind of structure the nodes have: BoundingStructure.BOX, the default, SPHERE or CAPSULE (§7.7). The splits are those of the
         * boxes in any case. A sphere is about the middle of the node's box, a capsule along the box's longest axis; both
         * are as small as the vertices then allow.
         *
         * @throws ArgumentError if it is set to anything else
         */
        public function get boundsKind():int
        {
            return _boundsKind;
        }

        public function set boundsKind(value:int):void
        {
            if (value != BoundingStructure.BOX && value != BoundingStructure.SPHERE && value != BoundingStructure.CAPSULE)
            {
                throw new ArgumentError("boundsKind, a GreatLand's hierarchyBounds, must be BoundingStructure.BOX, SPHERE or CAPSULE: " + value);
            }
            _boundsKind = value;
        }

        /**
         * Builds and stores the hierarchy of a model; the one stored under the name before is replaced. If it throws,
         * nothing has changed. The time goes with the number of triangles or vertices times the number of levels.
         *
         * @param name the shape's name
         * @param vertices x, y, z of each of the model's vertices, in the model's space; copied
         * @param triangles three vertex indices each, or null where only vertices are known; an empty one is taken for
         *     null; copied. Triangles without area are allowed
         * @throws ArgumentError if the name is null or empty; if the vertices are null or empty, or a coordinate is missing or
         *     not finite; if a triangle names a vertex that is not there
         */
        public function add(name:String, vertices:Vector.<Number>, triangles:Vector.<uint> = null):void
        {
            var builder:SolidHierarchyBuilder = newBuilder(name, vertices, triangles);
            finish(builder);
            shapes.of(name).setHierarchy(builder);
        }

        /** Whether there is a hierarchy for a shape. */
        public function has(name:String):Boolean
        {
            return name != null && shapes.of(name).hasHierarchy;
        }

        /**
         * The node around the whole model.
         *
         * @throws ArgumentError if no model of this name was added
         */
        public function root(name:String):HierarchyNode
        {
            return hierarchy(name).root;
        }

        /**
         * The hierarchy of a shape; throws an ArgumentError if there is none.
         *
         * @private
         */
        engine function hierarchy(name:String):SolidHierarchy
        {
            if (!has(name))
            {
                throw ShapeTable.missing("hierarchy", name, "loadHierarchies");
            }
            return shapes.of(name).hierarchy;
        }

        /**
         * The work that builds the hierarchy of a shape, not begun.
         *
         * @private
         */
        engine function newBuilder(name:String, vertices:Vector.<Number>, triangles:Vector.<uint>):SolidHierarchyBuilder
        {
            ShapeTable.checkName(name);
            refuse(name, VertexData.vertexProblem(vertices));
            if (triangles == null || triangles.length == 0)
            {
                return builderOf(vertices.concat(), null);
            }
            refuse(name, VertexData.triangleProblem(triangles, vertices.length / 3));
            return builderOf(vertices.concat(), triangles.concat());
        }

        /**
         * The work that builds the hierarchy of a model, not begun. A model is known to be valid, and never changes.
         *
         * @private
         */
        engine function newBuilderOf(model:Model):SolidHierarchyBuilder
        {
            return builderOf(model.vertices, model.triangles);
        }

        private function builderOf(vertices:Vector.<Number>, triangles:Vector.<uint>):SolidHierarchyBuilder
        {
            return new SolidHierarchyBuilder(vertices, triangles, boundsKind, minVerticesToSplit, maxDepth, splitByMean, prepareExact);
        }

        private static function requirePositive(setting:String, value:int):void
        {
            if (value < 1)
            {
                throw new RangeError(setting + " must be at least 1: " + value);
            }
        }

        private static function refuse(name:String, problem:String):void
        {
            if (problem != null)
            {
                throw new ArgumentError("shape \"" + name + "\": " + problem);
            }
        }
    }
}
