package starlogo.bounding
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.engine;
    import starlogo.geometry.compareVectors;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * A box of any orientation: all points whose distance from <code>center</code> along each of three axes is at most that axis's
     * half-extent (thesis §3.3). Half-extents of 0 make it a rectangle, a segment or a point.
     *
     * <p>The axes are perpendicular unit vectors, of either handedness. The tests rely on this, so code that changes an axis must keep it
     * true.</p>
     */
    public final class Box extends BoundingStructure
    {
        // How far the lengths and the dot products of the axes may be off from 1 and 0. Axes that are as precise as this are copied to the last bit.
        private static const AXES_ROUNDING:Number = 1e-15;

        private static var sHalves:Vector3D = new Vector3D();

        /** The middle. */
        public var center:Vector3D;

        /** The box's own x axis, a unit vector. */
        public var axisX:Vector3D;

        /** The box's own y axis, a unit vector. */
        public var axisY:Vector3D;

        /** The box's own z axis, a unit vector. */
        public var axisZ:Vector3D;

        /** Half of the box's size along axisX, in patches, not negative. */
        public var halfX:Number;

        /** Half of the box's size along axisY, in patches, not negative. */
        public var halfY:Number;

        /** Half of the box's size along axisZ, in patches, not negative. */
        public var halfZ:Number;

        /**
         * Creates a box from its middle, its axes and its half-extents.
         *
         * @param center copied
         * @param axisX copied, as are the other axes. The axes may be as imprecise as the columns of a single-precision matrix
         *     (Tolerances.ORTHONORMALITY). The copies are perpendicular unit vectors in double precision
         * @param axisY perpendicular to axisX
         * @param axisZ perpendicular to both; either handedness is allowed
         * @param halfX half-extent along axisX in patches; 0 is allowed
         * @param halfY half-extent along axisY in patches
         * @param halfZ half-extent along axisZ in patches
         * @throws ArgumentError if a vector is null, or if the axes are not perpendicular unit vectors
         * @throws RangeError if a half-extent is negative, or if a number is not finite or beyond the limits of structures
         */
        public function Box(center:Vector3D, axisX:Vector3D, axisY:Vector3D, axisZ:Vector3D,
                halfX:Number, halfY:Number, halfZ:Number)
        {
            super(OTHER);
            kind = BOX;
            checkVector(axisX, "a box's axisX");
            checkVector(axisY, "a box's axisY");
            checkVector(axisZ, "a box's axisZ");
            var rotation:Placement = new Placement();
            rotation.setRows(new <Number>[axisX.x, axisY.x, axisZ.x, axisX.y, axisY.y, axisZ.y, axisX.z, axisY.z, axisZ.z], 0);
            if (!rotation.isOrthonormal)
            {
                var axes:String = [axisX, axisY, axisZ].join(", ");
                throw new ArgumentError("a box's axes must be unit vectors at right angles: " + axes);
            }
            this.halfX = checkLength(halfX, "a box's halfX");
            this.halfY = checkLength(halfY, "a box's halfY");
            this.halfZ = checkLength(halfZ, "a box's halfZ");
            this.center = checkVector(center, "the centre of a box").clone();
            checkSize(Math.max(Math.max(halfX, halfY), halfZ), "a box");
            this.axisX = axisX.clone();
            this.axisY = axisY.clone();
            this.axisZ = axisZ.clone();
            straighten();
        }

        /** @inheritDoc */
        override public function toString():String
        {
            return "a Box of half-extents (" + halfX + ", " + halfY + ", " + halfZ + ") at " + center;
        }

        /** @inheritDoc */
        override public function get volume():Number
        {
            return 8 * halfX * halfY * halfZ;
        }

        /** @inheritDoc */
        override public function rotate(rotation:Matrix3D):BoundingStructure
        {
            super.rotate(rotation);
            straighten();
            return this;
        }

        /** @inheritDoc */
        override public function contains(point:Vector3D):Boolean
        {
            var x:Number = point.x - center.x;
            var y:Number = point.y - center.y;
            var z:Number = point.z - center.z;
            var largest:Number = halfX > halfY ? halfX : halfY;
            var tolerance:Number = slack(largest > halfZ ? largest : halfZ, center);
            return isWithin(axisX, x, y, z, halfX + tolerance) && isWithin(axisY, x, y, z, halfY + tolerance)
                && isWithin(axisZ, x, y, z, halfZ + tolerance);
        }

        /** @inheritDoc */
        override public function clone():BoundingStructure
        {
            return new Box(center, axisX, axisY, axisZ, halfX, halfY, halfZ);
        }

        /** @inheritDoc */
        override public function place(placement:Placement, out:BoundingStructure = null):BoundingStructure
        {
            var placed:Box = out as Box || newFor(out) as Box;
            var size:Number = placement.size;
            placed.halfX = halfX * size;
            placed.halfY = halfY * size;
            placed.halfZ = halfZ * size;
            placement.place(center, placed.center);
            placement.rotate(axisX, placed.axisX);
            placement.rotate(axisY, placed.axisY);
            placement.rotate(axisZ, placed.axisZ);
            return placed;
        }

        /**
         * @inheritDoc
         *
         * @private
         */
        override engine function widen(by:Number):void
        {
            halfX += by;
            halfY += by;
            halfZ += by;
        }

        /** @private */
        override engine function widenForSurfaces():void
        {
            // The tolerance depends on the model's radius about the middle of its extents. That radius is at most the square root of 3 times
            // the radius of a sphere around the model.
            widen(2 * Tolerances.SURFACES * (halfX + halfY + halfZ));
        }

        /** @private */
        override engine function findPlacedBox(placement:Placement, out:Vector.<Number>):void
        {
            var m:Placement = placement;
            var size:Number = m.size;
            var x:Number = center.x * size;
            var y:Number = center.y * size;
            var z:Number = center.z * size;
            out[0] = m.r00 * x + m.r01 * y + m.r02 * z;
            out[1] = m.r10 * x + m.r11 * y + m.r12 * z;
            out[2] = m.r20 * x + m.r21 * y + m.r22 * z;
            var scaledHalfX:Number = halfX * size;
            var scaledHalfY:Number = halfY * size;
            var scaledHalfZ:Number = halfZ * size;
            var margin:Number = Tolerances.ROUNDING * (Math.abs(x) + Math.abs(y) + Math.abs(z) + scaledHalfX + scaledHalfY + scaledHalfZ);
            // a row of the rotation times each axis: how far the halves reach along x, y and z
            out[3] = scaledHalfX * Math.abs(m.r00 * axisX.x + m.r01 * axisX.y + m.r02 * axisX.z)
                + scaledHalfY * Math.abs(m.r00 * axisY.x + m.r01 * axisY.y + m.r02 * axisY.z)
                + scaledHalfZ * Math.abs(m.r00 * axisZ.x + m.r01 * axisZ.y + m.r02 * axisZ.z) + margin;
            out[4] = scaledHalfX * Math.abs(m.r10 * axisX.x + m.r11 * axisX.y + m.r12 * axisX.z)
                + scaledHalfY * Math.abs(m.r10 * axisY.x + m.r11 * axisY.y + m.r12 * axisY.z)
                + scaledHalfZ * Math.abs(m.r10 * axisZ.x + m.r11 * axisZ.y + m.r12 * axisZ.z) + margin;
            out[5] = scaledHalfX * Math.abs(m.r20 * axisX.x + m.r21 * axisX.y + m.r22 * axisX.z)
                + scaledHalfY * Math.abs(m.r20 * axisY.x + m.r21 * axisY.y + m.r22 * axisY.z)
                + scaledHalfZ * Math.abs(m.r20 * axisZ.x + m.r21 * axisZ.y + m.r22 * axisZ.z) + margin;
        }

        /** @private */
        override engine function setShape(out:ConvexShape):void
        {
            // V8 would make objects for Numbers that are passed
            sHalves.x = halfX;
            sHalves.y = halfY;
            sHalves.z = halfZ;
            out.setBox(center, axisX, axisY, axisZ, sHalves);
        }

        /** @private */
        override engine function isAfter(other:BoundingStructure):Boolean
        {
            var box:Box = other as Box;
            var order:int = compareVectors(center, box.center) || compareVectors(axisX, box.axisX) || compareVectors(axisY, box.axisY);
            return order > 0 || order == 0 && (halfX > box.halfX
                    || halfX == box.halfX && (halfY > box.halfY || halfY == box.halfY && halfZ > box.halfZ));
        }

        /** @private */
        override engine function toNumbers():Vector.<Number>
        {
            return new <Number>[center.x, center.y, center.z, axisX.x, axisX.y, axisX.z, axisY.x, axisY.y, axisY.z, axisZ.x, axisZ.y, axisZ.z,
                    halfX, halfY, halfZ];
        }

        /** @private */
        override engine function setFromNumbers(numbers:Vector.<Number>):void
        {
            center.setTo(numbers[0], numbers[1], numbers[2]);
            axisX.setTo(numbers[3], numbers[4], numbers[5]);
            axisY.setTo(numbers[6], numbers[7], numbers[8]);
            axisZ.setTo(numbers[9], numbers[10], numbers[11]);
            halfX = numbers[12];
            halfY = numbers[13];
            halfZ = numbers[14];
        }

        private static function isWithin(axis:Vector3D, x:Number, y:Number, z:Number, half:Number):Boolean
        {
            var along:Number = axis.x * x + axis.y * y + axis.z * z;
            return along <= half && along >= -half;
        }

        // The axes are nearly perpendicular unit vectors. This makes them so up to rounding (Gram and Schmidt).
        private function straighten():void
        {
            normalise(axisX);
            removeComponent(axisY, axisX);
            normalise(axisY);
            removeComponent(axisZ, axisX);
            removeComponent(axisZ, axisY);
            normalise(axisZ);
        }

        private static function removeComponent(vector:Vector3D, along:Vector3D):void
        {
            var amount:Number = vector.dotProduct(along);
            amount = Math.abs(amount) > AXES_ROUNDING ? amount : 0;
            vector.x -= amount * along.x;
            vector.y -= amount * along.y;
            vector.z -= amount * along.z;
        }

        private static function normalise(vector:Vector3D):void
        {
            var length:Number = vector.length;
            length = Math.abs(length - 1) > AXES_ROUNDING ? length : 1;
            vector.x /= length;
            vector.y /= length;
            vector.z /= length;
        }
    }
}
