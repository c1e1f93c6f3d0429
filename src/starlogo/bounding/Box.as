package starlogo.bounding
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import starlogo.geometry.Placement;

    /**
     * A box of any orientation: the points that are, along each of three axes, no farther from <code>center</code> than
     * that axis's half-extent (thesis §3.3). Half-extents of 0 make it a rectangle, a segment or a point.
     *
     * <p>The axes are unit vectors at right angles, of either handedness. The tests rely on it: whoever changes an
     * axis directly has to keep it so.</p>
     */
    public final class Box extends BoundingStructure
    {
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
         * @param center copied
         * @param axisX copied, and so are the others; they may be as imprecise as those of a single-precision matrix
         *     (Tolerances.ORTHONORMALITY), and their copies are then unit vectors at right angles in double precision
         * @param axisY at right angles to axisX
         * @param axisZ at right angles to both; either handedness is allowed
         * @param halfX half-extent along axisX in patches; 0 is allowed
         * @param halfY half-extent along axisY
         * @param halfZ half-extent along axisZ
         * @throws ArgumentError when a vector is null, or the axes are no unit vectors at right angles
         * @throws RangeError when a number is not finite, or a half-extent negative
         */
        public function Box(center:Vector3D, axisX:Vector3D, axisY:Vector3D, axisZ:Vector3D,
                halfX:Number, halfY:Number, halfZ:Number)
        {
            super(BOX);
            checkVector(axisX, "a box's axisX");
            checkVector(axisY, "a box's axisY");
            checkVector(axisZ, "a box's axisZ");
            if (!isOrthonormal(axisX.x, axisX.y, axisX.z, axisY.x, axisY.y, axisY.z, axisZ.x, axisZ.y, axisZ.z))
            {
                throw new ArgumentError("a box's axes must be unit vectors at right angles: " + [axisX, axisY, axisZ].join(", "));
            }
            this.halfX = checkLength(halfX, "a box's halfX");
            this.halfY = checkLength(halfY, "a box's halfY");
            this.halfZ = checkLength(halfZ, "a box's halfZ");
            this.center = checkVector(center, "the centre of a box").clone();
            this.axisX = axisX.clone();
            this.axisY = axisY.clone();
            this.axisZ = axisZ.clone();
            straighten();
        }

        /** @inheritDoc */
        override public function get volume():Number
        {
            return 8 * halfX * halfY * halfZ;
        }

        /** @inheritDoc */
        override public function scale(factor:Number):BoundingStructure
        {
            checkFactor(factor);
            center.scaleBy(factor);
            halfX *= factor;
            halfY *= factor;
            halfZ *= factor;
            return this;
        }

        /** @inheritDoc */
        override public function rotate(rotation:Matrix3D):BoundingStructure
        {
            var m:Vector.<Number> = readRotation(rotation);
            turn(center, m);
            turn(axisX, m);
            turn(axisY, m);
            turn(axisZ, m);
            straighten();
            return this;
        }

        /** @inheritDoc */
        override public function translate(offset:Vector3D):BoundingStructure
        {
            center.incrementBy(checkVector(offset, "an offset"));
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
            var placed:Box = out as Box;
            if (placed == null)
            {
                if (out != null)
                {
                    throw wrongKind(out, "Box");
                }
                placed = new Box(center, axisX, axisY, axisZ, halfX, halfY, halfZ);
            }
            var size:Number = placement.size;
            placed.halfX = halfX * size;
            placed.halfY = halfY * size;
            placed.halfZ = halfZ * size;
            placePoint(center, placement, placed.center);
            if (placement.isUpright)
            {
                copyVector(axisX, placed.axisX);
                copyVector(axisY, placed.axisY);
                copyVector(axisZ, placed.axisZ);
                return placed;
            }
            turnTo(axisX, placement, placed.axisX);
            turnTo(axisY, placement, placed.axisY);
            turnTo(axisZ, placement, placed.axisZ);
            return placed;
        }

        /** @inheritDoc */
        override public function extentsInto(out:Vector.<Number>, offset:int = 0):void
        {
            var margin:Number = rounding(halfX + halfY + halfZ, center);
            writeExtent(center.x, halfX * axisX.x, halfY * axisY.x, halfZ * axisZ.x, margin, out, offset);
            writeExtent(center.y, halfX * axisX.y, halfY * axisY.y, halfZ * axisZ.y, margin, out, offset + 2);
            writeExtent(center.z, halfX * axisX.z, halfY * axisY.z, halfZ * axisZ.z, margin, out, offset + 4);
        }

        private static function isWithin(axis:Vector3D, x:Number, y:Number, z:Number, half:Number):Boolean
        {
            var along:Number = axis.x * x + axis.y * y + axis.z * z;
            return along <= half && along >= -half;
        }

        private static function copyVector(vector:Vector3D, out:Vector3D):void
        {
            out.x = vector.x;
            out.y = vector.y;
            out.z = vector.z;
        }

        private static function turnTo(vector:Vector3D, placement:Placement, out:Vector3D):void
        {
            var x:Number = vector.x;
            var y:Number = vector.y;
            var z:Number = vector.z;
            out.x = placement.r00 * x + placement.r01 * y + placement.r02 * z;
            out.y = placement.r10 * x + placement.r11 * y + placement.r12 * z;
            out.z = placement.r20 * x + placement.r21 * y + placement.r22 * z;
        }

        private static function writeExtent(middle:Number, a:Number, b:Number, c:Number, margin:Number,
                out:Vector.<Number>, offset:int):void
        {
            var reach:Number = (a < 0 ? -a : a) + (b < 0 ? -b : b) + (c < 0 ? -c : c) + margin;
            out[offset] = middle - reach;
            out[offset + 1] = middle + reach;
        }

        /** Makes the axes, which are almost so, unit vectors at right angles (Gram and Schmidt). */
        private function straighten():void
        {
            normalize(axisX);
            removeComponent(axisY, axisX);
            normalize(axisY);
            removeComponent(axisZ, axisX);
            removeComponent(axisZ, axisY);
            normalize(axisZ);
        }

        private static function removeComponent(vector:Vector3D, along:Vector3D):void
        {
            var amount:Number = vector.x * along.x + vector.y * along.y + vector.z * along.z;
            vector.x -= amount * along.x;
            vector.y -= amount * along.y;
            vector.z -= amount * along.z;
        }

        private static function normalize(vector:Vector3D):void
        {
            var length:Number = Math.sqrt(vector.x * vector.x + vector.y * vector.y + vector.z * vector.z);
            vector.x /= length;
            vector.y /= length;
            vector.z /= length;
        }
    }
}
