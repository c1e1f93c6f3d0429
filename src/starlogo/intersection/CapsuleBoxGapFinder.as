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

        /**
         * If several points are closest, the one in the middle of them is taken.
         *
         * @inheritDoc
         */
        override public function find(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:CoreGap):void
        {
            var axis:BoxSegment = _axis;
            var capsule:Capsule = a as Capsule;
            var box:Box = b as Box;
            axis.setTo(capsule, box);
            axis.move(box, motion);
            axis.findNearest(box);
            var share:Number = axis.nearest;
            if (axis.lastIn <= axis.firstOut)
            {
                var from:Number = axis.lastIn > 0 ? (axis.lastIn < 1 ? axis.lastIn : 1) : 0;
                var to:Number = axis.firstOut > 0 ? (axis.firstOut < 1 ? axis.firstOut : 1) : 0;
                share = (from + to) / 2;
            }
            // The comparison is false for NaN too.
            share = share > 0 ? (share < 1 ? share : 1) : 0;
            out.x = axis.signX * (axis.x + share * axis.alongX);
            out.y = axis.signY * (axis.y + share * axis.alongY);
            out.z = axis.signZ * (axis.z + share * axis.alongZ);
            measureToBox(box, motion, out);
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            out.pointX = start.x + share * (end.x - start.x);
            out.pointY = start.y + share * (end.y - start.y);
            out.pointZ = start.z + share * (end.z - start.z);
            out.movePoint(motion);
            out.radiusA = capsule.radius;
            out.radiusB = 0;
            out.extent = axis.alongX + axis.alongY + axis.alongZ + box.halfX + box.halfY + box.halfZ + capsule.radius;
        }
    }
}
