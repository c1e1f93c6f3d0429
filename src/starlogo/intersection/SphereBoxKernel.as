package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.placeContact;
    import starlogo.intersection.distance.RoundGap;
    import starlogo.intersection.distance.moveToSurfaces;
    import starlogo.intersection.sweep.NewtonSteps;

    /** The kernel of a sphere and a box. It works in the box's axes. */
    internal final class SphereBoxKernel extends PairKernel
    {
        // The motion of the sphere's centre as seen from the box's middle, in the box's axes.
        private var _way:RelativeMotion = new RelativeMotion();
        private var _gap:RoundGap = new RoundGap();
        private var _steps:NewtonSteps = new NewtonSteps();

        /** @inheritDoc */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            var box:Box = b as Box;
            relate(a as Sphere, box, motion);
            findGap(box);
            if (_steps.begin(motion, _way, _gap))
            {
                _gap.size = box.halfX + box.halfY + box.halfZ + _gap.radiusA;
                do
                {
                    findGap(box);
                }
                while (_steps.next(_way, _gap));
            }
            motion.time = _way.time;
        }

        /**
         * A sphere's contact is written out here, because calls of relate() and findGap() are slow in Adobe's VM.
         *
         * @inheritDoc
         */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            var sphere:Sphere = a as Sphere;
            var box:Box = b as Box;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = box.center;
            var axisX:Vector3D = box.axisX;
            var axisY:Vector3D = box.axisY;
            var axisZ:Vector3D = box.axisZ;
            out.x = displacement.startX + center.x;
            out.y = displacement.startY + center.y;
            out.z = displacement.startZ + center.z;
            var toX:Number = out.x - middle.x;
            var toY:Number = out.y - middle.y;
            var toZ:Number = out.z - middle.z;
            var x:Number = axisX.x * toX + axisX.y * toY + axisX.z * toZ;
            var y:Number = axisY.x * toX + axisY.y * toY + axisY.z * toZ;
            var z:Number = axisZ.x * toX + axisZ.y * toY + axisZ.z * toZ;
            var gap:RoundGap = _gap;
            gap.x = x;
            gap.y = y;
            gap.z = z;
            var halfX:Number = box.halfX;
            var halfY:Number = box.halfY;
            var halfZ:Number = box.halfZ;
            include "pointToBox.inc";
            var radius:Number = sphere.radius;
            var squared:Number = x * x + y * y + z * z;
            var least:Number = Tolerances.DIRECTION * (halfX + halfY + halfZ + radius);
            if (squared > least * least)
            {
                out.setNormal(x * axisX.x + y * axisY.x + z * axisZ.x, x * axisX.y + y * axisY.y + z * axisZ.y,
                        x * axisX.z + y * axisY.z + z * axisZ.z);
                out.normalise();
                out.depth = radius - Math.sqrt(squared);
            }
            else
            {
                pointThroughFace(box, gap, out);
                out.depth += radius;
            }
            gap.radiusA = radius;
            placeContact(gap, out);
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPoints):void
        {
            var sphere:Sphere = a as Sphere;
            var box:Box = b as Box;
            relate(sphere, box, RelativeMotion.NONE);
            findGap(box);
            rotateFromBox(box, _gap);
            var center:Vector3D = sphere.center;
            out.aX = center.x;
            out.aY = center.y;
            out.aZ = center.z;
            moveToSurfaces(_gap, out);
        }

        // Sets the way at time 0, and the radius.
        private function relate(sphere:Sphere, box:Box, motion:RelativeMotion):void
        {
            var way:RelativeMotion = _way;
            var center:Vector3D = sphere.center;
            var middle:Vector3D = box.center;
            var x:Number = center.x - middle.x + motion.startX;
            var y:Number = center.y - middle.y + motion.startY;
            var z:Number = center.z - middle.z + motion.startZ;
            var axis:Vector3D = box.axisX;
            way.startX = axis.x * x + axis.y * y + axis.z * z;
            way.x = axis.x * motion.x + axis.y * motion.y + axis.z * motion.z;
            axis = box.axisY;
            way.startY = axis.x * x + axis.y * y + axis.z * z;
            way.y = axis.x * motion.x + axis.y * motion.y + axis.z * motion.z;
            axis = box.axisZ;
            way.startZ = axis.x * x + axis.y * y + axis.z * z;
            way.z = axis.x * motion.x + axis.y * motion.y + axis.z * motion.z;
            way.time = 0;
            _gap.radiusA = sphere.radius;
        }

        // Finds the gap at the way's time, in the box's axes.
        private function findGap(box:Box):void
        {
            var way:RelativeMotion = _way;
            var time:Number = way.time;
            var x:Number = way.startX + time * way.x;
            var y:Number = way.startY + time * way.y;
            var z:Number = way.startZ + time * way.z;
            var halfX:Number = box.halfX;
            var halfY:Number = box.halfY;
            var halfZ:Number = box.halfZ;
            include "pointToBox.inc";
            var gap:RoundGap = _gap;
            gap.x = x;
            gap.y = y;
            gap.z = z;
        }

        // Points a contact's normal from a place inside of the box out through the nearest face. The depth is the distance to that face.
        private static function pointThroughFace(box:Box, place:RoundGap, out:ContactPoint):void
        {
            var axis:Vector3D = box.axisX;
            var along:Number = place.x;
            var depth:Number = box.halfX - Math.abs(along);
            if (box.halfY - Math.abs(place.y) < depth)
            {
                axis = box.axisY;
                along = place.y;
                depth = box.halfY - Math.abs(along);
            }
            if (box.halfZ - Math.abs(place.z) < depth)
            {
                axis = box.axisZ;
                along = place.z;
                depth = box.halfZ - Math.abs(along);
            }
            var side:Number = along < 0 ? -1 : 1;
            out.setNormal(side * axis.x, side * axis.y, side * axis.z);
            out.normalise();
            out.depth = depth;
        }
    }
}
