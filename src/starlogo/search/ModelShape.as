package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.agents.Breeds;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.ground.HeightGrid;
    import starlogo.models.Model;
    import starlogo.solid.ModelTree;

    use namespace engine;

    /**
     * The shape that a Collider uses for a model, in the model's space. Agents with the same model and the same
     * variant (<code>BaseShapeChoice.variantOf()</code>) share it. A BaseShapeChoice sets it.
     */
    public final class ModelShape
    {
        /**
         * @private The kind of a tree. The kinds of structures are lower: BoundingStructure.SPHERE to HULL.
         */
        engine static const TREE:int = 16;

        /** @private The kinds of the ground and of the edges of the world. The kinds of agents are lower. */
        engine static const GROUND:int = 17;

        /** @private @copy #GROUND */
        engine static const EDGES:int = 18;

        /** @private The variant of a shape that is the only one of its model. */
        engine static const ONLY_VARIANT:int = 0;

        /** The model's name. */
        public var modelName:String;

        /** Which of the model's shapes it is: the number that BaseShapeChoice.variantOf() has returned. */
        public var variant:int;

        /** @private The revision of the model in the GreatLand. */
        internal var revision:int;

        /** @private Whether the model has a newer revision, so that this shape is stale. */
        engine var isStale:Boolean = false;

        /** @private The kind of the structure, or TREE, GROUND or EDGES. */
        engine var kind:int = -1;

        /** @private The structure, or the structure around the tree. */
        engine var structure:BoundingStructure = null;

        /** @private The tree, or null. */
        engine var tree:ModelTree = null;

        /** @private Whether the shape stays upright and faces along the x axis, however its agent is turned. */
        engine var ignoresRotation:Boolean = false;

        /** @private The model; null for shapes that have none. */
        engine var model:Model = null;

        /** @private The heights of the ground; null for other shapes. */
        engine var grid:HeightGrid = null;

        /** @private The edges of the world: the least and the greatest x, then y, then z. Null for other shapes. They do not change. */
        engine var edges:Vector.<Number> = null;

        /**
         * @private For the ground and the edges: adds the tests of pairs with them to a narrow phase, so a game without them does not load the
         *     code. <code>function(narrowPhase:NarrowPhase):void</code>
         */
        engine var addEnvironmentTests:Function = null;

        /**
         * For colliders only.
         *
         * @param modelName the model's name
         * @param variant the number that BaseShapeChoice.variantOf() has returned
         * @param revision the revision of the model in the GreatLand
         */
        public function ModelShape(modelName:String, variant:int, revision:int)
        {
            this.modelName = modelName;
            this.variant = variant;
            this.revision = revision;
        }

        /**
         * @private Makes a shape of the ground or of the edges of the world. Its structure is a point, so no tolerance is a fraction of it.
         *
         * @param grid the heights of the ground, or null
         * @param edges the edges, or null
         * @param addEnvironmentTests adds the tests of pairs with them to a narrow phase
         */
        engine static function ofEnvironment(grid:HeightGrid, edges:Vector.<Number>, addEnvironmentTests:Function):ModelShape
        {
            var isGround:Boolean = grid != null;
            var shape:ModelShape = new ModelShape(isGround ? Breeds.TERRAIN : Breeds.EDGE, ONLY_VARIANT, 0);
            shape.structure = new Sphere(new Vector3D(), 0);
            shape.kind = isGround ? GROUND : EDGES;
            shape.ignoresRotation = true;
            shape.grid = grid;
            shape.edges = edges;
            shape.addEnvironmentTests = addEnvironmentTests;
            return shape;
        }

        /**
         * Uses a structure as the model's shape.
         *
         * @param structure a Sphere, Capsule, Box or Hull in the model's space. Do not change it afterwards
         * @throws ArgumentError if it is null, or another structure. The shape is then unchanged
         */
        public function setStructure(structure:BoundingStructure):void
        {
            requireStructure(structure);
            this.structure = structure;
            kind = structure.kind;
        }

        /** @private Throws an ArgumentError if a structure is null, or not a sphere, box, capsule or hull. */
        engine static function requireStructure(structure:BoundingStructure):void
        {
            if (structure == null || structure.kind > BoundingStructure.HULL)
            {
                throw new ArgumentError("a sphere, box, capsule or hull is needed, not " + structure);
            }
        }

        /** @private Uses the model's tree as its shape. */
        engine function setTree(tree:ModelTree):void
        {
            this.tree = tree;
            kind = TREE;
            followPose();
        }

        /** @private Takes the structure around the tree as the model's present pose has it. */
        engine function followPose():void
        {
            structure = tree.root.bounds;
        }
    }
}
