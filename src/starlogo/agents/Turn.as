package starlogo.agents
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * How an agent is turned: by three angles, by a quaternion, or by angles and then by a quaternion of the same rotation. It has these numbers as
     * the game has given them, and computes the rotation of the agent's placement from them. Angles of a quaternion, and the rotation of angles, are
     * computed only when they are needed.
     *
     * @private
     */
    public final class Turn
    {
        // What has turned the agent. The numbers stand in snapshots.
        private static const BY_ANGLES:int = 0;
        private static const BY_QUATERNION:int = 1;
        private static const BY_BOTH:int = 2;

        // What has to be computed when it is needed: nothing, the rotation from the angles, or the angles from the rotation.
        private static const NOTHING:int = 0;
        private static const ROTATION:int = 1;
        private static const ANGLES:int = 2;

        // How far a quaternion's length may be from 1 if its numbers are kept as they are.
        private static const NEARLY_UNIT:Number = 1e-6;

        private static var sTurned:Placement = new Placement();
        private static var sAngles:Vector3D = new Vector3D();

        /** The turn about the z axis, in degrees. This and the other angles are right after <code>updateAngles()</code>. */
        public var heading:Number = 0;

        /** The turn about the y axis, before the heading. */
        public var pitch:Number = 0;

        /** The turn about the x axis, before the pitch. */
        public var roll:Number = 0;

        private var _placement:Placement;
        private var _turnedBy:int = BY_ANGLES;

        // The numbers of the last quaternion. Null before the first one.
        private var _quaternion:Vector.<Number> = null;

        private var _stale:int = NOTHING;

        /** @param placement gets the rotation: the agent's place in the world */
        public function Turn(placement:Placement)
        {
            _placement = placement;
        }

        /** Turns by finite angles. Returns whether they are others. */
        public function setAngles(heading:Number, pitch:Number, roll:Number):Boolean
        {
            if (heading == this.heading && pitch == this.pitch && roll == this.roll && _turnedBy != BY_QUATERNION)
            {
                return false;
            }
            // -0 becomes 0, as in a place
            this.heading = heading + 0;
            this.pitch = pitch + 0;
            this.roll = roll + 0;
            _turnedBy = BY_ANGLES;
            _stale = ROTATION;
            return true;
        }

        /** Turns by a quaternion, which is finite and not 0. Returns whether it is another rotation. */
        public function setQuaternion(x:Number, y:Number, z:Number, w:Number):Boolean
        {
            var largest:Number = Math.max(Math.max(Math.abs(x), Math.abs(y)), Math.max(Math.abs(z), Math.abs(w)));
            var overX:Number = x / largest;
            var overY:Number = y / largest;
            var overZ:Number = z / largest;
            var overW:Number = w / largest;
            var length:Number = Math.sqrt(overX * overX + overY * overY + overZ * overZ + overW * overW);
            if (!(Math.abs(largest * length - 1) <= NEARLY_UNIT))
            {
                return setQuaternion(overX / length, overY / length, overZ / length, overW / length);
            }
            updateRotation();
            sTurned.setQuaternion(overX / length, overY / length, overZ / length, overW / length);
            var isOther:Boolean = !_placement.hasRotationOf(sTurned);
            if (isOther)
            {
                _placement.copyRotation(sTurned);
                _turnedBy = BY_QUATERNION;
                _stale = ANGLES;
            }
            else if (_turnedBy == BY_ANGLES)
            {
                _turnedBy = BY_BOTH;
            }
            _quaternion ||= new Vector.<Number>(4, true);
            _quaternion[0] = x;
            _quaternion[1] = y;
            _quaternion[2] = z;
            _quaternion[3] = w;
            return isOther;
        }

        /** Writes the quaternion as it was given, or if there is none, the one of the angles: x, y, z, w. */
        public function readQuaternion(out:Vector.<Number>):void
        {
            if (_turnedBy == BY_ANGLES)
            {
                updateRotation();
                _placement.readQuaternion(out);
                return;
            }
            for (var i:int = 0; i < 4; i++)
            {
                out[i] = _quaternion[i];
            }
        }

        /** Makes the rotation of the placement right. */
        public function updateRotation():void
        {
            if (_stale == ROTATION)
            {
                _placement.setRotation(heading, pitch, roll);
                _stale = NOTHING;
            }
        }

        /**
         * Makes the angles right, and returns this turn. It takes three arctangents, and most games that turn by quaternions never read the angles.
         */
        public function updateAngles():Turn
        {
            if (_stale == ANGLES)
            {
                _placement.readAngles(sAngles);
                heading = sAngles.z;
                pitch = sAngles.y;
                roll = sAngles.x;
                _stale = NOTHING;
            }
            return this;
        }

        /** Writes what has turned the agent, and by how much. */
        public function write(bytes:ByteArray):void
        {
            bytes.writeByte(_turnedBy);
            if (_turnedBy != BY_QUATERNION)
            {
                bytes.writeDouble(heading);
                bytes.writeDouble(pitch);
                bytes.writeDouble(roll);
            }
            if (_turnedBy != BY_ANGLES)
            {
                for (var i:int = 0; i < 4; i++)
                {
                    bytes.writeDouble(_quaternion[i]);
                }
            }
        }

        /**
         * Turns an agent as another one was when <code>write()</code> wrote it, to the last bit.
         *
         * @param agent has this turn. It checks the numbers, and counts the changes
         * @throws RangeError if the bytes are no turn
         */
        public function read(bytes:ByteArray, agent:Agent):void
        {
            var by:int = bytes.readUnsignedByte();
            if (by > BY_BOTH)
            {
                throw new RangeError(agent + ": there is no turn of kind " + by);
            }
            if (by != BY_QUATERNION)
            {
                agent.turnTo(bytes.readDouble(), bytes.readDouble(), bytes.readDouble());
                // the angles may have been these, and a quaternion of the same rotation
                _turnedBy = BY_ANGLES;
            }
            if (by != BY_ANGLES)
            {
                agent.turnBy(bytes.readDouble(), bytes.readDouble(), bytes.readDouble(), bytes.readDouble());
            }
            if (by == BY_QUATERNION && _turnedBy != BY_QUATERNION)
            {
                // the angles happen to make the same rotation
                _turnedBy = BY_QUATERNION;
                _stale = ANGLES;
            }
        }
    }
}
