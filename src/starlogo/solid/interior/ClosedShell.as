package starlogo.solid.interior
{
    /** A closed, orientable shell, as a record of CavityFinder. */
    internal final class ClosedShell
    {
        /** Where the coordinates of the vertex begin from which its volume is measured. */
        public var origin:int;

        /** Six times its volume. It is negative if most triangles face inwards, after those to be reversed are reversed. */
        public var sixfoldVolume:Number = 0;

        /** 1 if its triangles face outwards as the model has them, -1 if they face inwards, 0 without a volume. */
        public var orientation:int = 0;

        /** The lowest number of a vertex to which one of its corners is welded, and the sum of hashes of all such numbers, which wraps round. */
        public var firstCorner:int = int.MAX_VALUE;
        public var cornersHash:int = 0;

        /** The larger shells that enclose all of its points tested so far. Null before the first point. */
        public var enclosing:Vector.<int> = null;

        /** @param origin where the coordinates of one of its vertices begin */
        public function ClosedShell(origin:int)
        {
            this.origin = origin;
        }
    }
}
