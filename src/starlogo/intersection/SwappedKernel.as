package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;

    /** The kernel of two kinds in the order opposite to that of another kernel. It asks the other kernel, and swaps the answer back. */
    internal final class SwappedKernel extends PairKernel
    {
        private var _kernel:PairKernel;
        private var _reversed:RelativeMotion = new RelativeMotion();

        /** @param kernel the kernel of the two kinds in the other order */
        public function SwappedKernel(kernel:PairKernel)
        {
            _kernel = kernel;
        }

        /** @inheritDoc */
        override public function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return _kernel.areTouching(b, a);
        }

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            _reversed.setReversed(motion);
            _kernel.findTime(b, a, _reversed);
            motion.time = _reversed.time;
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:ContactPoint):void
        {
            _reversed.setReversed(motion);
            _kernel.findContact(b, a, _reversed, out);
            out.swap(motion);
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            _kernel.findClosest(b, a, out);
            out.swap();
        }
    }
}
