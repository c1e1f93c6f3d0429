package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;

    /** Finds the gap between a capsule's axis and a box. */
    internal final class CapsuleBoxGapFinder extends GapFinder
    {
        private var _axis:BoxSegment = new BoxSegment();

        /** @inheritDoc */
        override public function find(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:RoundGap):void
        {
            var gap:CoreGap = out.cores;
            var axis:BoxSegment = _axis;
            var capsule:Capsule = a as Capsule;
            var box:Box = b as Box;
            axis.setTo(capsule, box);
            axis.move(box, motion);
            axis.findNearest(box);
            var share:Number = axis.nearest;
            gap.x = axis.signX * (axis.x + share * axis.alongX);
            gap.y = axis.signY * (axis.y + share * axis.alongY);
            gap.z = axis.signZ * (axis.z + share * axis.alongZ);
            out.measureToBox(box, motion);
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            gap.pointX = start.x + share * (end.x - start.x);
            gap.pointY = start.y + share * (end.y - start.y);
            gap.pointZ = start.z + share * (end.z - start.z);
            gap.radiusA = capsule.radius;
            gap.radiusB = 0;
            out.extent = axis.alongX + axis.alongY + axis.alongZ + box.halfX + box.halfY + box.halfZ + capsule.radius;
        }
    }
}
