package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /** Finds the gap between the axes of two capsules. */
    internal final class CapsuleCapsuleGapFinder extends GapFinder
    {
        private var _axes:SegmentPair = new SegmentPair();

        /** @inheritDoc */
        override public function areSwapped(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            var startA:Vector3D = (a as Capsule).start;
            var startB:Vector3D = (b as Capsule).start;
            // Capsules with the same start touch, so their order does not matter.
            return isAfter(startA, startB);
        }

        /** @inheritDoc */
        override public function find(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:CoreGap):void
        {
            var axes:SegmentPair = _axes;
            var capsuleA:Capsule = a as Capsule;
            var capsuleB:Capsule = b as Capsule;
            var start:Vector3D = capsuleA.start;
            axes.setTo(capsuleA, capsuleB);
            axes.move(motion);
            axes.findClosest();
            out.x = axes.x;
            out.y = axes.y;
            out.z = axes.z;
            out.measure(motion);
            out.pointX = start.x + axes.shareOfU * axes.uX;
            out.pointY = start.y + axes.shareOfU * axes.uY;
            out.pointZ = start.z + axes.shareOfU * axes.uZ;
            out.movePoint(motion);
            out.radiusA = capsuleA.radius;
            out.radiusB = capsuleB.radius;
            out.extent = Math.abs(axes.uX) + Math.abs(axes.uY) + Math.abs(axes.uZ) + (Math.abs(axes.vX) + Math.abs(axes.vY) + Math.abs(axes.vZ))
                + (capsuleA.radius + capsuleB.radius);
        }
    }
}
