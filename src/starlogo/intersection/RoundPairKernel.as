package starlogo.intersection
{
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import starlogo.bounding.AxialStructure;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.contact.placeContact;
    import starlogo.intersection.distance.CoreGap;
    import starlogo.intersection.distance.DistanceResult;
    import starlogo.intersection.distance.moveToSurfaces;
    import starlogo.intersection.sweep.RelativeMotion;

    /**
     * Finds the closest points of two cores while the first one moves. Abstract kernel of all pairs whose first structure is a sphere or a
     * capsule.
     *
     * <p>A core is a sphere's centre, a capsule's axis or a whole box. Two structures touch when the distance of their cores is the sum of
     * their radii.</p>
     */
    internal class RoundPairKernel extends PairKernel
    {
        /**
         * The vector from b to a at the start of the motion, in the kernel's axes. The subclass chooses the two points that it connects.
         */
        public var fromX:Number;
        public var fromY:Number;
        public var fromZ:Number;

        /** The motion of a, in the kernel's axes. */
        public var motionX:Number;
        public var motionY:Number;
        public var motionZ:Number;

        /** The vector from b's closest point to a's, in the kernel's axes. */
        public var gapX:Number;
        public var gapY:Number;
        public var gapZ:Number;

        /** The place of a's closest point on a capsule's axis, from 0 at its start to 1 at its end. */
        public var share:Number = 0;

        /** The sum of the radii: the distance of the cores when the structures touch. */
        public var radiusSum:Number;

        /**
         * The time at which <code>find()</code> finds the closest points. A field, because V8 would allocate an object for a Number that is
         * passed.
         */
        protected var timeParameter:Number = 0;

        /** The size of both structures together. The rounding error of the gap is relative to it. */
        protected var size:Number = 0;

        /** What the shared functions get of the gap and the radii. */
        protected var gap:CoreGap = new CoreGap();

        /** Prepares two structures: computes everything that does not depend on the time. */
        protected function relate(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            throw new IllegalOperationError("abstract");
        }

        /** Finds the closest points at the time in <code>timeParameter</code>. */
        protected function find():void
        {
            throw new IllegalOperationError("abstract");
        }

        /** Computes the size. */
        protected function measure():void
        {
            throw new IllegalOperationError("abstract");
        }

        /** Writes the contact of structures whose cores overlap. The gap has no direction then. */
        protected function findOverlap(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError("abstract");
        }

        /** Rotates the gap from the kernel's axes into the axes of the structures' space. */
        protected function rotateGap(b:BoundingStructure):void
        {
        }

        /**
         * Applies Newton's method to the distance of the cores. This distance is a convex function of time, so the method never steps over
         * the first zero when it starts to the left of it. It takes at most 80 steps, because each step shrinks the product of the gap and
         * its slope to a quarter, and both are numbers of 53 bits.
         *
         * <p>If the cores are very close, rounding hides the direction of the gap, and with it the slope. Then a chord takes the place of the
         * tangent: it goes through this distance and that of the step before, and does not step over the first zero either. A step that went
         * too far because of rounding is halved.</p>
         *
         * @inheritDoc
         */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            relate(a, b, motion);
            motion.findRounding();
            var reach:Number = radiusSum * Tolerances.TOUCHING + motion.rounding;
            reach *= reach;
            var latest:Number = motion.latest;
            var time:Number = 0;
            var lastTime:Number = 0;
            var lastDistance:Number = 0;
            var least:Number = 0;
            for (var step:int = 0; step < 80; step++)
            {
                timeParameter = time;
                find();
                var x:Number = gapX;
                var y:Number = gapY;
                var z:Number = gapZ;
                var squared:Number = x * x + y * y + z * z;
                if (step == 1)
                {
                    // A gap that is no longer than this has no certain direction.
                    measure();
                    least = Tolerances.DIRECTION * size;
                    if (radiusSum < least)
                    {
                        reach = radiusSum * Tolerances.TOUCHING + motion.rounding + Tolerances.ROUNDING * size;
                        reach *= reach;
                    }
                }
                if (step > 0 && 4 * squared < radiusSum * radiusSum)
                {
                    // The slope had so large a rounding error that the step went beyond the zero.
                    time = (lastTime + time) / 2;
                    least = Infinity;
                    continue;
                }
                var isTouching:Boolean = squared <= reach;
                if (isTouching)
                {
                    // If they touch at time 0, that is the time of impact. Cores that touch have no direction from one to the other, so
                    // there is no next step.
                    var rounding:Number = Math.sqrt(reach) - radiusSum;
                    if (time == 0 || squared <= radiusSum * radiusSum || squared <= rounding * rounding)
                    {
                        break;
                    }
                }
                var next:Number = RelativeMotion.NEVER;
                var closing:Number = -(x * motionX + y * motionY + z * motionZ);
                var distance:Number = Math.sqrt(squared);
                if (distance < least && distance < lastDistance)
                {
                    next = time + (distance - radiusSum) * (time - lastTime) / (lastDistance - distance);
                }
                else if (closing > 0)
                {
                    // The time at which the plane between the closest points, moved along, has no gap left.
                    next = time + (distance - radiusSum) * distance / closing;
                }
                lastTime = time;
                lastDistance = distance;
                if (isTouching)
                {
                    // They touch to within rounding. One more step makes up for a step that rounding may have skipped.
                    time = next <= 1 ? next : time;
                    break;
                }
                if (!(next > time))
                {
                    break;
                }
                time = next;
                if (next > latest)
                {
                    time = RelativeMotion.NEVER;
                    break;
                }
            }
            motion.time = time;
        }

        /**
         * Finds a capsule's contact. The kernels of spheres override this with a faster method.
         *
         * @inheritDoc
         */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            relate(a, b, displacement);
            timeParameter = 0;
            find();
            measure();
            var squared:Number = gapX * gapX + gapY * gapY + gapZ * gapZ;
            // If the gap is longer than this, it has a direction in spite of rounding.
            var least:Number = Tolerances.DIRECTION * size;
            if (squared > least * least)
            {
                rotateGap(b);
                out.setNormal(gapX, gapY, gapZ);
                out.normalise();
                out.depth = radiusSum - Math.sqrt(squared);
                placeCapsule(a, displacement, out);
            }
            else
            {
                findOverlap(a, b, displacement, out);
            }
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:DistanceResult):void
        {
            relate(a, b, RelativeMotion.NONE);
            timeParameter = 0;
            find();
            rotateGap(b);
            if (a.kind == BoundingStructure.SPHERE)
            {
                var sphere:Sphere = a as Sphere;
                out.aX = sphere.center.x;
                out.aY = sphere.center.y;
                out.aZ = sphere.center.z;
                gap.radiusA = sphere.radius;
            }
            else
            {
                var capsule:Capsule = a as Capsule;
                var start:Vector3D = capsule.start;
                var end:Vector3D = capsule.end;
                out.aX = start.x + share * (end.x - start.x);
                out.aY = start.y + share * (end.y - start.y);
                out.aZ = start.z + share * (end.z - start.z);
                gap.radiusA = capsule.radius;
            }
            gap.x = gapX;
            gap.y = gapY;
            gap.z = gapZ;
            var axial:AxialStructure = b as AxialStructure;
            gap.radiusB = axial == null ? 0 : axial.radius;
            moveToSurfaces(gap, out);
        }

        /** Places a capsule's contact once its normal and depth are known. The point lies behind a's closest point, against the normal. */
        protected final function placeCapsule(a:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            var x:Number = displacement.startX;
            var y:Number = displacement.startY;
            var z:Number = displacement.startZ;
            var capsule:Capsule = a as Capsule;
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            out.x = x + start.x + share * (end.x - start.x);
            out.y = y + start.y + share * (end.y - start.y);
            out.z = z + start.z + share * (end.z - start.z);
            gap.radiusA = capsule.radius;
            placeContact(gap, out);
        }
    }
}
