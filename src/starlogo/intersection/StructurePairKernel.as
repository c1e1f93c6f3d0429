package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;

    /**
     * Decides about two structures of certain kinds: finds when they first touch, how they overlap and how far apart they are. Each kernel is an object of
     * a class that extends this one. StructurePairs chooses it, explains the questions, and puts the two in order: a comes before b. This class itself is
     * the kernel of pairs with a structure of the kind OTHER, which have no answers: its methods throw.
     *
     * @private
     */
    public class StructurePairKernel
    {
        /** Finds the time of impact. @param motion the motion of a; receives the time */
        public function findTimeOfImpact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            throw missing("time of impact", a, b);
        }

        /** Finds the contact. @param motion the motion of a, which is where it is at the motion's time */
        public function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            throw missing("contact", a, b);
        }

        /** Finds the distance and the closest points. */
        public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            throw missing("distance", a, b);
        }

        /** The error that says that a pair has no answer to a question. */
        public static function missing(what:String, a:BoundingStructure, b:BoundingStructure):ArgumentError
        {
            return new ArgumentError("there is no " + what + " for " + a + " and " + b);
        }
    }
}
