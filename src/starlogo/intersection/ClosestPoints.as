package starlogo.intersection
{
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.AxialStructure;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;

    /**
     * The kernel of a pair of which the first is a sphere or a capsule: the closest points of the two cores, while the first moves. A
     * core is a sphere's centre, a capsule's axis, or all of a box; structures touch when the cores are as close as their radii. Abstract.
     */
    internal class ClosestPoints extends PairKernel
    {
        /** From b to a where the motion starts, in the kernel's axes: between points that the subclass chooses. */
        public var fromX:Number;

        /** @copy #fromX */
        public var fromY:Number;

        /** @copy #fromX */
        public var fromZ:Number;

        /** The motion of a, in the same axes. */
        public var motionX:Number;

        /** @copy #motionX */
        public var motionY:Number;

        /** @copy #motionX */
        public var motionZ:Number;

        /** From b's closest point to a's, in the same axes. */
        public var gapX:Number;

        /** @copy #gapX */
        public var gapY:Number;

        /** @copy #gapX */
        public var gapZ:Number;

        /** Where on a capsule's axis a's closest point is, from 0 at its start to 1. */
        public var share:Number = 0;

        /** How close the cores are when the structures touch. */
        public var radii:Number;

        /** The time of the motion at which closest points are found: of the Numbers that are passed to <code>find()</code> V8 would make objects. */
        protected var moment:Number = 0;

        /** How large the structures are together: what the rounding of the gap is relative to. */
        protected var size:Number = 0;

        /** For subclasses only. */
        public function ClosestPoints()
        {
        }

        /** Prepares two structures: computes what does not depend on the time. */
        protected function relate(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            throw new IllegalOperationError("abstract");
        }

        /** Finds the closest points at the moment. */
        protected function find():void
        {
            throw new IllegalOperationError("abstract");
        }

        /** Finds the size. */
        protected function measure():void
        {
            throw new IllegalOperationError("abstract");
        }

        /** Writes the contact of structures whose cores overlap: there is no direction from one to the other. */
        protected function findOverlap(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError("abstract");
        }

        /** Turns the gap from the kernel's axes into those of the structures' space. */
        protected function turnGap(b:BoundingStructure):void
        {
        }

        /**
         * Newton's method on the distance of the cores, which is a convex function of time: from the left it does not step over the first
         * zero. It takes 80 steps at most: the product of the gap and its slope shrinks to a quarter in each, and both are numbers with
         * 53 bits.
         *
         * @inheritDoc
         */
        override public function findTime(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            relate(a, b, motion);
            motion.findRounding();
            var reach:Number = radii * Tolerances.TOUCHING + motion.rounding;
            reach *= reach;
            var time:Number = 0;
            for (var step:int = 0; step < 80; step++)
            {
                moment = time;
                find();
                var x:Number = gapX;
                var y:Number = gapY;
                var z:Number = gapZ;
                var squared:Number = x * x + y * y + z * z;
                var isTouching:Boolean = squared <= reach;
                if (isTouching)
                {
                    // what touches at time 0 does so at time 0, and cores that touch have no direction from one to the other
                    var rounding:Number = Math.sqrt(reach) - radii;
                    if (time == 0 || squared <= radii * radii || squared <= rounding * rounding)
                    {
                        break;
                    }
                }
                var next:Number = RelativeMotion.NEVER;
                var closing:Number = -(x * motionX + y * motionY + z * motionZ);
                if (closing > 0)
                {
                    // when the plane between the closest points, moved along, has no gap left
                    var distance:Number = Math.sqrt(squared);
                    next = time + (distance - radii) * distance / closing;
                }
                if (isTouching)
                {
                    // the rest is rounding, but for one more step, which rounding may have spared
                    time = next <= 1 ? next : time;
                    break;
                }
                if (!(next > time))
                {
                    break;
                }
                time = next;
                if (next > 1)
                {
                    time = RelativeMotion.NEVER;
                    break;
                }
            }
            motion.time = time;
        }

        /**
         * That of a capsule; the kernels of spheres have their own, which is quicker.
         *
         * @inheritDoc
         */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            relate(a, b, displacement);
            moment = 0;
            find();
            measure();
            var squared:Number = gapX * gapX + gapY * gapY + gapZ * gapZ;
            // long enough to have a direction, in spite of rounding
            var least:Number = Tolerances.DIRECTION * size;
            if (squared > least * least)
            {
                turnGap(b);
                out.setNormal(gapX, gapY, gapZ);
                out.normalise();
                out.depth = radii - Math.sqrt(squared);
                placeContact(a, displacement, out);
            }
            else
            {
                findOverlap(a, b, displacement, out);
            }
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPair):void
        {
            relate(a, b, RelativeMotion.NONE);
            moment = 0;
            find();
            turnGap(b);
            if (a.kind == BoundingStructure.SPHERE)
            {
                var sphere:Sphere = a as Sphere;
                out.aX = sphere.center.x;
                out.aY = sphere.center.y;
                out.aZ = sphere.center.z;
                out.radiusA = sphere.radius;
            }
            else
            {
                var capsule:Capsule = a as Capsule;
                var start:Vector3D = capsule.start;
                var end:Vector3D = capsule.end;
                out.aX = start.x + share * (end.x - start.x);
                out.aY = start.y + share * (end.y - start.y);
                out.aZ = start.z + share * (end.z - start.z);
                out.radiusA = capsule.radius;
            }
            out.gapX = gapX;
            out.gapY = gapY;
            out.gapZ = gapZ;
            out.radiusB = b.kind == BoundingStructure.BOX ? 0 : AxialStructure(b).radius;
            out.separate();
        }

        /** Places a capsule's contact of which normal and depth are known: from a's closest point, back along the normal. */
        protected final function placeContact(a:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
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
            out.radius = capsule.radius;
            out.place();
        }
    }
}
