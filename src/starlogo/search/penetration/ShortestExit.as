package starlogo.search.penetration
{
    import flash.geom.Vector3D;

    /**
     * The shortest displacement out of half-spaces. HalfSpaceSolver writes it.
     *
     * @private
     */
    public final class ShortestExit
    {
        /** The displacement. */
        public var displacement:Vector3D = new Vector3D();

        /** Its length; Infinity if no displacement leads out. */
        public var length:Number = Infinity;

        /** How many half-spaces decide: the displacement ends on the planes of these. */
        public var deciding:int = 0;

        /** The numbers of up to three half-spaces that decide: the one that was added last, and those before it. If none decides, last is -1. */
        public var last:int = -1;
        public var second:int = 0;
        public var third:int = 0;
    }
}
