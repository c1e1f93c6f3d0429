package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.solid.SolidHierarchy;

    /**
     * What stands for a model in a collider, in the model's space: one object for all agents that have it.
     *
     * @private
     */
    public final class ModelShape
    {
        /** In place of a kind of structure: the hierarchy. */
        public static const HIERARCHY:int = 3;

        /** The model's name. */
        public var model:String;

        /** What was asked for: a kind of BoundingStructure, Agent.ANY_KIND or HIERARCHY. */
        public var kind:int;

        /** The revision of what the GreatLand knows of the model. */
        public var revision:int;

        /** Whether the model was replaced or removed since. */
        public var isVoid:Boolean = false;

        /** Whether a sphere stands for the model, and nothing else. */
        public var isSphere:Boolean = false;

        /** Whether the structure stands for the model, and is to be had in the world. */
        public var decides:Boolean = false;

        /** What stands for the model, or the structure around its hierarchy; null for a unit sphere. */
        public var structure:BoundingStructure = null;

        /** The hierarchy, where one is used. */
        public var hierarchy:SolidHierarchy = null;

        /** What is tried before the structure, a little wider; or null. */
        public var outer:OuterStructures = null;

        /** What is asked for of a model; the strategy finds the rest. */
        public function ModelShape(model:String, kind:int, revision:int)
        {
            this.model = model;
            this.kind = kind;
            this.revision = revision;
        }
    }
}
