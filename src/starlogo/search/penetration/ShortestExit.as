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

        /** The numbers of the half-spaces that decide: first the one that was added last, which is -1 if none decides. */
        public var numbers:Vector.<int> = new <int>[-1, 0, 0];
    }
}
