package flash.geom
{
    /** How decompose and recompose write a rotation. */
    public final class Orientation3D
    {
        /** Angle w about the axis (x, y, z). */
        public static const AXIS_ANGLE:String = "axisAngle";

        /** Angles about x, y and z, in this order. */
        public static const EULER_ANGLES:String = "eulerAngles";

        /** The quaternion with the vector (x, y, z) and the scalar w. */
        public static const QUATERNION:String = "quaternion";
    }
}
