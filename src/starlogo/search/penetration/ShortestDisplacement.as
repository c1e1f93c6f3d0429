package starlogo.search.penetration
{
    import flash.geom.Vector3D;

    /**
     * The shortest displacement out of half-spaces. HalfSpaceSolver writes it.
     *
     * @private
     */
    public final class ShortestDisplacement
    {
        /** The displacement. */
        public var displacement:Vector3D = new Vector3D();

        /** Its length; Infinity if no displacement leads out. */
        public var length:Number = Infinity;

        /** On how many planes the displacement ends: the half-spaces of these decide. */
        public var planeCount:int = 0;

        /** Becomes no displacement. */
        public function setToNone():void
        {
            displacement.setTo(0, 0, 0);
            length = 0;
            planeCount = 0;
        }
    }
}
