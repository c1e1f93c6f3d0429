package evaluation.literal
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;

    /** The thesis's own pair tests, for structures whose kinds are only known at run time. */
    public final class LiteralTests
    {
        /** Sphere against box (§3.6.6). */
        public static function sphereBox(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return evaluation.literal.sphereBox(a as Sphere, b as Box);
        }

        /** Capsule against capsule (§3.6.3). */
        public static function capsuleCapsule(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return evaluation.literal.capsuleCapsule(a as Capsule, b as Capsule);
        }

        /** Capsule against box (§3.6.7). */
        public static function capsuleBox(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return evaluation.literal.capsuleBox(a as Capsule, b as Box);
        }

        /** Box against box (§3.6.4). */
        public static function boxBox(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return evaluation.literal.boxBox(a as Box, b as Box);
        }
    }
}
