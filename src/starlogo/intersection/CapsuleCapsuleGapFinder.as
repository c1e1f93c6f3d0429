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
        override public function find(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:RoundGap):void
        {
            var gap:CoreGap = out.cores;
            var axes:SegmentPair = _axes;
            var capsuleA:Capsule = a as Capsule;
            var capsuleB:Capsule = b as Capsule;
            var start:Vector3D = capsuleA.start;
            axes.setTo(capsuleA, capsuleB);
            axes.move(motion);
            axes.findClosest();
            gap.x = axes.x;
            gap.y = axes.y;
            gap.z = axes.z;
            out.measure(motion);
            gap.pointX = start.x + axes.shareOfU * axes.uX;
            gap.pointY = start.y + axes.shareOfU * axes.uY;
            gap.pointZ = start.z + axes.shareOfU * axes.uZ;
            gap.radiusA = capsuleA.radius;
            gap.radiusB = capsuleB.radius;
            out.extent = Math.abs(axes.uX) + Math.abs(axes.uY) + Math.abs(axes.uZ) + (Math.abs(axes.vX) + Math.abs(axes.vY) + Math.abs(axes.vZ))
                + (capsuleA.radius + capsuleB.radius);
        }
    }
}
