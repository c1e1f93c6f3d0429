package starlogo.bounding
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * A box of any orientation: the points that are, along each of three axes, no farther from <code>center</code> than
     * that axis's half-extent (thesis §3.3). Half-extents of 0 make it a rectangle, a segment or a point.
     *
     * <p>The axes are unit vectors at right angles, of either handedness. The tests rely on it: code that changes an axis directly has to keep it
     * so.</p>
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
         * A box by its middle, its axes and its half-extents.
         *
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
                var axes:String = [axisX, axisY, axisZ].join(", ");
                throw new ArgumentError("a box's axes must be unit vectors at right angles: " + axes);
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
                placed = newFor(out) as Box;
            }
            var size:Number = placement.size;
            placed.halfX = halfX * size;
            placed.halfY = halfY * size;
            placed.halfZ = halfZ * size;
            var r00:Number = placement.r00;
            var r01:Number = placement.r01;
            var r02:Number = placement.r02;
            var r10:Number = placement.r10;
            var r11:Number = placement.r11;
            var r12:Number = placement.r12;
            var r20:Number = placement.r20;
            var r21:Number = placement.r21;
            var r22:Number = placement.r22;
            var x:Number = center.x * size;
            var y:Number = center.y * size;
            var z:Number = center.z * size;
            var vector:Vector3D = placed.center;
            vector.x = r00 * x + r01 * y + r02 * z + placement.x;
            vector.y = r10 * x + r11 * y + r12 * z + placement.y;
            vector.z = r20 * x + r21 * y + r22 * z + placement.z;
            x = axisX.x;
            y = axisX.y;
            z = axisX.z;
            vector = placed.axisX;
            vector.x = r00 * x + r01 * y + r02 * z;
            vector.y = r10 * x + r11 * y + r12 * z;
            vector.z = r20 * x + r21 * y + r22 * z;
            x = axisY.x;
            y = axisY.y;
            z = axisY.z;
            vector = placed.axisY;
            vector.x = r00 * x + r01 * y + r02 * z;
            vector.y = r10 * x + r11 * y + r12 * z;
            vector.z = r20 * x + r21 * y + r22 * z;
            x = axisZ.x;
            y = axisZ.y;
            z = axisZ.z;
            vector = placed.axisZ;
            vector.x = r00 * x + r01 * y + r02 * z;
            vector.y = r10 * x + r11 * y + r12 * z;
            vector.z = r20 * x + r21 * y + r22 * z;
            return placed;
        }

        /** @inheritDoc */
        override public function extentsInto(out:Vector.<Number>, offset:int = 0):void
        {
            var margin:Number = rounding(halfX + halfY + halfZ, center);
            writeExtentOf(center.x, axisX.x, axisY.x, axisZ.x, margin, out, offset);
            writeExtentOf(center.y, axisX.y, axisY.y, axisZ.y, margin, out, offset + 2);
            writeExtentOf(center.z, axisX.z, axisY.z, axisZ.z, margin, out, offset + 4);
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
        override engine function turnedExtentsInto(placement:Placement, out:Vector.<Number>):void
        {
            var size:Number = placement.size;
            var r00:Number = placement.r00;
            var r01:Number = placement.r01;
            var r02:Number = placement.r02;
            var r10:Number = placement.r10;
            var r11:Number = placement.r11;
            var r12:Number = placement.r12;
            var r20:Number = placement.r20;
            var r21:Number = placement.r21;
            var r22:Number = placement.r22;
            var x:Number = center.x * size;
            var y:Number = center.y * size;
            var z:Number = center.z * size;
            out[0] = r00 * x + r01 * y + r02 * z;
            out[1] = r10 * x + r11 * y + r12 * z;
            out[2] = r20 * x + r21 * y + r22 * z;
            x = x < 0 ? -x : x;
            y = y < 0 ? -y : y;
            z = z < 0 ? -z : z;
            var half:Number = halfX * size;
            var margin:Number = x + y + z + half;

            // axis by axis, how far the box reaches along x, y and z
            var vector:Vector3D = axisX;
            x = vector.x;
            y = vector.y;
            z = vector.z;
            var along:Number = half * (r00 * x + r01 * y + r02 * z);
            var reachX:Number = along < 0 ? -along : along;
            along = half * (r10 * x + r11 * y + r12 * z);
            var reachY:Number = along < 0 ? -along : along;
            along = half * (r20 * x + r21 * y + r22 * z);
            var reachZ:Number = along < 0 ? -along : along;
            half = halfY * size;
            margin += half;
            vector = axisY;
            x = vector.x;
            y = vector.y;
            z = vector.z;
            along = half * (r00 * x + r01 * y + r02 * z);
            along = along < 0 ? -along : along;
            reachX += along;
            along = half * (r10 * x + r11 * y + r12 * z);
            along = along < 0 ? -along : along;
            reachY += along;
            along = half * (r20 * x + r21 * y + r22 * z);
            along = along < 0 ? -along : along;
            reachZ += along;
            half = halfZ * size;
            margin += half;
            vector = axisZ;
            x = vector.x;
            y = vector.y;
            z = vector.z;
            along = half * (r00 * x + r01 * y + r02 * z);
            along = along < 0 ? -along : along;
            reachX += along;
            along = half * (r10 * x + r11 * y + r12 * z);
            along = along < 0 ? -along : along;
            reachY += along;
            along = half * (r20 * x + r21 * y + r22 * z);
            along = along < 0 ? -along : along;
            reachZ += along;
            margin *= Tolerances.ROUNDING;
            out[3] = reachX + margin;
            out[4] = reachY + margin;
            out[5] = reachZ + margin;
        }

        // Along an axis of the space, in which the box's own axes have these components.
        private function writeExtentOf(middle:Number, alongX:Number, alongY:Number, alongZ:Number, margin:Number, out:Vector.<Number>,
                offset:int):void
        {
            var reach:Number = margin + halfX * Math.abs(alongX) + halfY * Math.abs(alongY) + halfZ * Math.abs(alongZ);
            writeExtent(middle, middle, reach, out, offset);
        }

        private static function isWithin(axis:Vector3D, x:Number, y:Number, z:Number, half:Number):Boolean
        {
            var along:Number = axis.x * x + axis.y * y + axis.z * z;
            return along <= half && along >= -half;
        }

        // Makes the axes, which are almost so, unit vectors at right angles (Gram and Schmidt).
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
            var amount:Number = vector.x * along.x + vector.y * along.y + vector.z * along.z;
            vector.x -= amount * along.x;
            vector.y -= amount * along.y;
            vector.z -= amount * along.z;
        }

        private static function normalise(vector:Vector3D):void
        {
            var length:Number = Math.sqrt(vector.x * vector.x + vector.y * vector.y + vector.z * vector.z);
            vector.x /= length;
            vector.y /= length;
            vector.z /= length;
        }
    }
}
