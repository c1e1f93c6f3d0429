package starlogo.models
{
    import flash.geom.Vector3D;

    /**
     * Turns, scales and moves a source: a ModelTransform. A GreatLand knows one by this interface, so a program that never uses a ModelTransform need
     * not contain that class.
     *
     * @private
     */
    public interface SourceTransform
    {
        /** Degrees about x, y and z. */
        function get rotation():Vector3D;

        /** Factors along x, y and z, applied after the rotation. */
        function get scale():Vector3D;

        /** Distances along x, y and z, applied last. */
        function get translation():Vector3D;

        /** Whether it changes nothing. */
        function get isIdentity():Boolean;
    }
}
