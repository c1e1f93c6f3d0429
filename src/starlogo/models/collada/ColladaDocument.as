package starlogo.models.collada
{
    import starlogo.models.ModelBudget;

    /** What all elements of a COLLADA document share, as a record. */
    internal final class ColladaDocument
    {
        /** What reading the document may cost. */
        public var budget:ModelBudget;

        /** The first element of each name and id, by name, "#" and id. The "#" keeps a key different from every property of an Object. */
        public var elementsById:Object = {};

        /** @param budget what reading the document may cost */
        public function ColladaDocument(budget:ModelBudget)
        {
            this.budget = budget;
        }
    }
}
