package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /**
     * Finds the gap between a capsule's axis and a box. It works in the box's axes, mirrored so that no component of the capsule's axis is
     * negative.
     *
     * <p>The squared distance to the box is convex along the segment, and quadratic between the points where the segment crosses the planes of
     * the box's faces. So its minimum has a closed form.</p>
     */
    internal final class CapsuleBoxGapFinder extends GapFinder
    {
        /** For <code>capsuleBox()</code>. */
        public static const STANDING:CapsuleBoxGapFinder = new CapsuleBoxGapFinder();

        // The segment as seen from the box's middle: its start, and the vector from there to its end. -1 for each axis that is mirrored.
        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 0;
        private var _alongX:Number = 0;
        private var _alongY:Number = 0;
        private var _alongZ:Number = 0;
        private var _signX:int = 1;
        private var _signY:int = 1;
        private var _signZ:int = 1;

        // Places on the segment's line, from 0 at its start to 1 at its end: the nearest one to the box, where the line has entered all slabs of
        // the box, and where it leaves the first one.
        private var _share:Number = 0;
        private var _lastIn:Number = 0;
        private var _firstOut:Number = 0;

        /** See capsuleBox. */
        override public function areTouching(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            var capsule:Capsule = a as Capsule;
            var box:Box = b as Box;
            setSegment(capsule, box);
            var radius:Number = capsule.radius * Tolerances.TOUCHING;
            var halfX:Number = box.halfX;
            var halfY:Number = box.halfY;
            var halfZ:Number = box.halfZ;
            if (_x > halfX + radius || _x + _alongX < -halfX - radius || _y > halfY + radius || _y + _alongY < -halfY - radius
                    || _z > halfZ + radius || _z + _alongZ < -halfZ - radius)
            {
                return false;
            }
            findShare(box);
            var share:Number = _share > 0 ? _share : 0;
            share = share < 1 ? share : 1;
            // The segment is not outside if a part of it is inside of all slabs that it crosses. Then only slabs parallel to it are tested. For
            // the others no point is computed, because rounding might put it outside, and a radius of 0 allows no error.
            var isOutside:Boolean = _lastIn > _firstOut || _lastIn > 1 || _firstOut < 0;
            var x:Number = isOutside || _alongX == 0 ? _x + share * _alongX : 0;
            var y:Number = isOutside || _alongY == 0 ? _y + share * _alongY : 0;
            var z:Number = isOutside || _alongZ == 0 ? _z + share * _alongZ : 0;
            include "squaredToBox.inc";
            return squaredDistance <= radius * radius;
        }

        /**
         * If several points are closest, the one in the middle of them is taken.
         *
         * @inheritDoc
         */
        override public function find(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:CoreGap):void
        {
            var capsule:Capsule = a as Capsule;
            var box:Box = b as Box;
            setSegment(capsule, box);
            moveSegment(box, motion);
            findShare(box);
            var share:Number = _share;
            if (_lastIn <= _firstOut)
            {
                var from:Number = _lastIn > 0 ? (_lastIn < 1 ? _lastIn : 1) : 0;
                var to:Number = _firstOut > 0 ? (_firstOut < 1 ? _firstOut : 1) : 0;
                share = (from + to) / 2;
            }
            // The comparison is false for NaN too.
            share = share > 0 ? (share < 1 ? share : 1) : 0;
            out.x = _signX * (_x + share * _alongX);
            out.y = _signY * (_y + share * _alongY);
            out.z = _signZ * (_z + share * _alongZ);
            measureToBox(box, motion, out);
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            var time:Number = motion.time;
            out.pointX = motion.startX + time * motion.x + (start.x + share * (end.x - start.x));
            out.pointY = motion.startY + time * motion.y + (start.y + share * (end.y - start.y));
            out.pointZ = motion.startZ + time * motion.z + (start.z + share * (end.z - start.z));
            out.radiusA = capsule.radius;
            out.radiusB = 0;
            out.extent = _alongX + _alongY + _alongZ + box.halfX + box.halfY + box.halfZ + capsule.radius;
        }

        private function setSegment(capsule:Capsule, box:Box):void
        {
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            var middle:Vector3D = box.center;
            var x:Number = start.x - middle.x;
            var y:Number = start.y - middle.y;
            var z:Number = start.z - middle.z;
            var toX:Number = end.x - start.x;
            var toY:Number = end.y - start.y;
            var toZ:Number = end.z - start.z;
            var axis:Vector3D = box.axisX;
            var along:Number = axis.x * toX + axis.y * toY + axis.z * toZ;
            _signX = along < 0 ? -1 : 1;
            _alongX = _signX * along;
            _x = _signX * (axis.x * x + axis.y * y + axis.z * z);
            axis = box.axisY;
            along = axis.x * toX + axis.y * toY + axis.z * toZ;
            _signY = along < 0 ? -1 : 1;
            _alongY = _signY * along;
            _y = _signY * (axis.x * x + axis.y * y + axis.z * z);
            axis = box.axisZ;
            along = axis.x * toX + axis.y * toY + axis.z * toZ;
            _signZ = along < 0 ? -1 : 1;
            _alongZ = _signZ * along;
            _z = _signZ * (axis.x * x + axis.y * y + axis.z * z);
        }

        // Moves the segment to where the capsule is at its motion's time.
        private function moveSegment(box:Box, motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            var axis:Vector3D = box.axisX;
            _x += _signX * (axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ);
            _x += time * (_signX * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z));
            axis = box.axisY;
            _y += _signY * (axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ);
            _y += time * (_signY * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z));
            axis = box.axisZ;
            _z += _signZ * (axis.x * motion.startX + axis.y * motion.startY + axis.z * motion.startZ);
            _z += time * (_signZ * (axis.x * motion.x + axis.y * motion.y + axis.z * motion.z));
        }

        // Finds the nearest place of the segment's line; it may be beyond the segment's ends. If the line passes through the box, it is where the
        // line enters the last slab. First, find where the line enters and leaves each slab of the box.
        private function findShare(box:Box):void
        {
            var px:Number = _x;
            var py:Number = _y;
            var pz:Number = _z;
            var dx:Number = _alongX;
            var dy:Number = _alongY;
            var dz:Number = _alongZ;
            var halfX:Number = box.halfX;
            var halfY:Number = box.halfY;
            var halfZ:Number = box.halfZ;
            var inX:Number = dx > 0 ? (-halfX - px) / dx : -Infinity;
            var outX:Number = dx > 0 ? (halfX - px) / dx : Infinity;
            var inY:Number = dy > 0 ? (-halfY - py) / dy : -Infinity;
            var outY:Number = dy > 0 ? (halfY - py) / dy : Infinity;
            var inZ:Number = dz > 0 ? (-halfZ - pz) / dz : -Infinity;
            var outZ:Number = dz > 0 ? (halfZ - pz) / dz : Infinity;
            var lastIn:Number = inX > inY ? inX : inY;
            lastIn = lastIn > inZ ? lastIn : inZ;
            var firstOut:Number = outX < outY ? outX : outY;
            firstOut = firstOut < outZ ? firstOut : outZ;
            var share:Number = lastIn;
            if (lastIn > firstOut)
            {
                // The line misses the box: it leaves one slab before it enters another, and is closest between these two places.
                // These two slabs count. The third slab also counts if the line is outside of it at the minimum found without it.
                var isOnX:Boolean = outX == firstOut || inX == lastIn;
                var isOnY:Boolean = outY == firstOut || inY == lastIn;
                var isOnZ:Boolean = outZ == firstOut || inZ == lastIn;
                var slope:Number = 0;
                var curvature:Number = 0;
                var beyond:Number;
                if (isOnX)
                {
                    beyond = outX == firstOut ? px - halfX : px + halfX;
                    slope = dx * beyond;
                    curvature = dx * dx;
                }
                if (isOnY)
                {
                    beyond = outY == firstOut ? py - halfY : py + halfY;
                    slope += dy * beyond;
                    curvature += dy * dy;
                }
                if (isOnZ)
                {
                    beyond = outZ == firstOut ? pz - halfZ : pz + halfZ;
                    slope += dz * beyond;
                    curvature += dz * dz;
                }
                share = -slope / curvature;
                if (!isOnX && (share < inX || share > outX))
                {
                    beyond = share < inX ? px + halfX : px - halfX;
                    share = -(slope + dx * beyond) / (curvature + dx * dx);
                }
                else if (!isOnY && (share < inY || share > outY))
                {
                    beyond = share < inY ? py + halfY : py - halfY;
                    share = -(slope + dy * beyond) / (curvature + dy * dy);
                }
                else if (!isOnZ && (share < inZ || share > outZ))
                {
                    beyond = share < inZ ? pz + halfZ : pz - halfZ;
                    share = -(slope + dz * beyond) / (curvature + dz * dz);
                }
            }
            _share = share;
            _lastIn = lastIn;
            _firstOut = firstOut;
        }
    }
}
