package starlogo.models.collada
{
    import starlogo.models.FileLimits;

    /** What all elements of a COLLADA document share, as a record. */
    internal final class ColladaDocument
    {
        /** What the document may have and cost. */
        public var limits:FileLimits;

        /** The first element of each name and id, by name, "#" and id. The "#" keeps a key different from every property of an Object. */
        public var elementsById:Object = {};

        /** @param limits what the document may have and cost */
        public function ColladaDocument(limits:FileLimits)
        {
            this.limits = limits;
        }
    }
}
