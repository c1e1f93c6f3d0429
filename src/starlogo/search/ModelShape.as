package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.solid.SolidHierarchy;

    use namespace engine;

    /**
     * The shape that represents a model in a Collider, in the model's space: one object for all agents that have the model. A ShapeChoice sets it.
     */
    public final class ModelShape
    {
        /** @private The form of a hierarchy: a bit of its own. The other forms are the kinds of BoundingStructure. */
        engine static const TREE:int = 4;

        /** @private The form of the ground: a bit of its own too. */
        engine static const GROUND:int = 8;

        /** The model's name. */
        public var model:String;

        /** The number that ShapeChoice.kindOf() has given. */
        public var kind:int;

        /** @private The revision of what the GreatLand knows of the model. */
        internal var revision:int;

        /** @private Whether there has been another revision since. */
        internal var isVoid:Boolean = false;

        /** @private BoundingStructure.SPHERE, CAPSULE, BOX, or TREE or GROUND. */
        engine var form:int = -1;

        // The structure that decides, or the one around the tree; the tree.
        engine var structure:BoundingStructure = null;
        engine var hierarchy:SolidHierarchy = null;

        // Whether the shape stands upright and faces the x axis, however its agent is turned.
        engine var isUpright:Boolean = false;

        /** @private Whether triangles decide about the structure in exact mode: it is no model's, but one that a question is about. */
        engine var meetsTriangles:Boolean = false;

        /** @private What is tried before the structure, a little wider; or null. */
        internal var outer:OuterStructures = null;

        /**
         * For colliders only.
         *
         * @param model the model's name
         * @param kind the number that ShapeChoice.kindOf() has given
         * @param revision of what the GreatLand knows of the model
         */
        public function ModelShape(model:String, kind:int, revision:int)
        {
            this.model = model;
            this.kind = kind;
            this.revision = revision;
        }

        /**
         * Represents the model by a structure.
         *
         * @param structure a Sphere, Capsule or Box in the model's space; not to be changed afterwards
         */
        public function setStructure(structure:BoundingStructure):void
        {
            this.structure = structure;
            form = structure.kind;
        }

        /** @private Represents the ground: its structure is one cell, the scale of what happens there. */
        engine function setGround(cell:BoundingStructure):void
        {
            structure = cell;
            isUpright = true;
            form = GROUND;
        }

        /** @private Represents the model by its hierarchy. */
        engine function setTree(hierarchy:SolidHierarchy):void
        {
            this.hierarchy = hierarchy;
            structure = hierarchy.root.bounds;
            form = TREE;
        }
    }
}
