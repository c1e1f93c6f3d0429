package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.solid.SolidHierarchy;

    use namespace engine;

    /**
     * The shape that represents a model in a collider, in the model's space: one object for all agents that have the model.
     *
     * @private
     */
    public final class ModelShape
    {
        // In place of a kind of structure: the hierarchy.
        engine static const HIERARCHY:int = 3;

        // What was asked for: of this model, a kind of BoundingStructure, Agent.ANY_KIND or HIERARCHY.
        engine var model:String;
        engine var kind:int;

        // The revision of what the GreatLand knows of the model, and whether there has been another since.
        engine var revision:int;
        engine var isVoid:Boolean = false;

        // The structure that represents the model, or the one around its hierarchy; null for a unit sphere.
        engine var structure:BoundingStructure = null;
        engine var hierarchy:SolidHierarchy = null;

        // Whether it is a sphere and nothing else; whether the structure decides, and has to be placed in the world.
        engine var isSphere:Boolean = false;
        engine var decides:Boolean = false;

        // What is tried before the structure, a little wider; or null.
        internal var outer:OuterStructures = null;

        /** Sets the key: model, kind and revision; the strategy finds the rest. */
        public function ModelShape(model:String, kind:int, revision:int)
        {
            this.model = model;
            this.kind = kind;
            this.revision = revision;
        }
    }
}
