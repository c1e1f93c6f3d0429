package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    /** The kernel of a capsule and a box: in the box's axes, mirrored so that the capsule's axis points up each of them. */
    internal class SegmentBox extends PointBox
    {
        private static const DEEP:BoxPair = new BoxPair();

        /** From the start of the segment to its end, in these axes: not negative. */
        protected var alongX:Number;

        /** @copy #alongX */
        protected var alongY:Number;

        /** @copy #alongX */
        protected var alongZ:Number;

        // -1 where an axis of the box is mirrored, else 1.
        private var _signX:Number = 1;
        private var _signY:Number = 1;
        private var _signZ:Number = 1;

        // What turn() turns.
        private var _turnedX:Number;
        private var _turnedY:Number;
        private var _turnedZ:Number;

        // From the box's middle to the segment's start, for findShare.
        private var _x:Number;
        private var _y:Number;
        private var _z:Number;

        /** Nothing related yet. */
        public function SegmentBox()
        {
        }

        override protected function relate(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var capsule:Capsule = a as Capsule;
            var box:Box = b as Box;
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            var middle:Vector3D = box.center;
            _turnedX = end.x - start.x;
            _turnedY = end.y - start.y;
            _turnedZ = end.z - start.z;
            turn(box);
            var signX:Number = _turnedX < 0 ? -1 : 1;
            var signY:Number = _turnedY < 0 ? -1 : 1;
            var signZ:Number = _turnedZ < 0 ? -1 : 1;
            alongX = signX * _turnedX;
            alongY = signY * _turnedY;
            alongZ = signZ * _turnedZ;
            _turnedX = start.x - middle.x;
            _turnedY = start.y - middle.y;
            _turnedZ = start.z - middle.z;
            turn(box);
            fromX = _turnedX;
            fromY = _turnedY;
            fromZ = _turnedZ;
            _turnedX = motion.startX;
            _turnedY = motion.startY;
            _turnedZ = motion.startZ;
            turn(box);
            fromX = signX * (fromX + _turnedX);
            fromY = signY * (fromY + _turnedY);
            fromZ = signZ * (fromZ + _turnedZ);
            _turnedX = motion.x;
            _turnedY = motion.y;
            _turnedZ = motion.z;
            turn(box);
            motionX = signX * _turnedX;
            motionY = signY * _turnedY;
            motionZ = signZ * _turnedZ;
            _signX = signX;
            _signY = signY;
            _signZ = signZ;
            halfX = box.halfX;
            halfY = box.halfY;
            halfZ = box.halfZ;
            radii = capsule.radius;
        }

        // Turns a vector into the box's axes. A field, because V8 makes objects of Numbers that are passed.
        private function turn(box:Box):void
        {
            var x:Number = _turnedX;
            var y:Number = _turnedY;
            var z:Number = _turnedZ;
            var axis:Vector3D = box.axisX;
            _turnedX = axis.x * x + axis.y * y + axis.z * z;
            axis = box.axisY;
            _turnedY = axis.x * x + axis.y * y + axis.z * z;
            axis = box.axisZ;
            _turnedZ = axis.x * x + axis.y * y + axis.z * z;
        }

        override protected function find():void
        {
            var time:Number = moment;
            var x:Number = fromX + time * motionX;
            var y:Number = fromY + time * motionY;
            var z:Number = fromZ + time * motionZ;
            _x = x;
            _y = y;
            _z = z;
            findShare();
            var along:Number = share;
            x += along * alongX;
            y += along * alongY;
            z += along * alongZ;
            var half:Number = halfX;
            x = x > half ? x - half : (x < -half ? x + half : 0);
            half = halfY;
            y = y > half ? y - half : (y < -half ? y + half : 0);
            half = halfZ;
            z = z > half ? z - half : (z < -half ? z + half : 0);
            gapX = x;
            gapY = y;
            gapZ = z;
        }

        override protected function measure():void
        {
            size = alongX + alongY + alongZ + halfX + halfY + halfZ + radii;
        }

        override protected function turnGap(b:BoundingStructure):void
        {
            gapX *= _signX;
            gapY *= _signY;
            gapZ *= _signZ;
            super.turnGap(b);
        }

        override protected function findOverlap(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            DEEP.radius = radii;
            DEEP.findContact(a, b, displacement, out);
        }

        /**
         * Finds where on the segment, from 0 to 1, the point is that is nearest to the box; of several, one in their midst.
         */
        private function findShare():void
        {
            var px:Number = _x;
            var py:Number = _y;
            var pz:Number = _z;
            var hx:Number = halfX;
            var hy:Number = halfY;
            var hz:Number = halfZ;
            var dx:Number = alongX;
            var dy:Number = alongY;
            var dz:Number = alongZ;
            include "segmentToBox.inc";

            if (lastIn <= firstOut)
            {
                lastIn = lastIn > 0 ? (lastIn < 1 ? lastIn : 1) : 0;
                firstOut = firstOut > 0 ? (firstOut < 1 ? firstOut : 1) : 0;
                share = (lastIn + firstOut) / 2;
                return;
            }
            // false for NaN too
            share = t > 0 ? (t < 1 ? t : 1) : 0;
        }
    }
}
