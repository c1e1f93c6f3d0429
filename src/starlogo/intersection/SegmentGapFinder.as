package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /** Finds the gap between the axis of a sphere or a capsule and that of a capsule. A sphere's axis is its centre, a segment without length. */
    internal final class SegmentGapFinder extends GapFinder
    {
        private var _axes:SegmentPair = new SegmentPair();

        /** @inheritDoc */
        override public function find(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:RoundGap):void
        {
            var gap:CoreGap = out.cores;
            var axes:SegmentPair = _axes;
            var sphere:Sphere = a as Sphere;
            var capsule:Capsule = b as Capsule;
            var start:Vector3D;
            if (sphere != null)
            {
                start = sphere.center;
                axes.setTo(start, start, capsule);
                gap.radiusA = sphere.radius;
            }
            else
            {
                var first:Capsule = a as Capsule;
                start = first.start;
                axes.setTo(start, first.end, capsule);
                gap.radiusA = first.radius;
            }
            axes.move(motion);
            axes.findClosest();
            gap.x = axes.x;
            gap.y = axes.y;
            gap.z = axes.z;
            out.squaredLength = gap.x * gap.x + gap.y * gap.y + gap.z * gap.z;
            out.closing = -(gap.x * motion.x + gap.y * motion.y + gap.z * motion.z);
            gap.pointX = start.x + axes.shareOfU * axes.uX;
            gap.pointY = start.y + axes.shareOfU * axes.uY;
            gap.pointZ = start.z + axes.shareOfU * axes.uZ;
            gap.radiusB = capsule.radius;
            out.extent = Math.abs(axes.uX) + Math.abs(axes.uY) + Math.abs(axes.uZ) + (Math.abs(axes.vX) + Math.abs(axes.vY) + Math.abs(axes.vZ))
                + (gap.radiusA + gap.radiusB);
        }
    }
}
