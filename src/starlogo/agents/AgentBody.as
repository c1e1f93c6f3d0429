package starlogo.agents
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * An agent's place, turn and size in the world. Every Agent is one.
     *
     * <p>The world is right-handed with z up. Lengths are in patches, angles in degrees. To place an agent, its model is scaled by
     * <code>size</code>, then turned about the world's axes: by <code>roll</code> about x, <code>pitch</code> about y and
     * <code>heading</code> about z. Then it is moved to (x, y, z). All this is relative to the model's origin, which is its centre in x and
     * y and its lowest point in z (thesis §2.2, §3.5).</p>
     *
     * <p>If you set a trait to a value that is not allowed, it throws a RangeError that names the agent. The trait then keeps its old
     * value.</p>
     */
    public class AgentBody
    {
        private static var sTurned:Placement = new Placement();
        private static var sAngles:Vector3D = new Vector3D();
        private static var sMatrix:Vector.<Number> = new Matrix3D().rawData;

        /**
         * @private The agent's place in the world. Its rotation may be stale: see <code>worldPlacement</code>. Its
         * <code>extentsRevision</code> counts all changes that affect the extents: of the turn, the size, the shape and the way the agent
         * collides.
         */
        engine var placement:Placement = new Placement();

        /** @private Counts changes of the agent's place, turn and size. */
        engine var revision:int = 0;

        /** @private The revision that the last jump made. The agent has no motion up to this revision. */
        engine var jumpRevision:int = -1;

        private var _heading:Number = 0;
        private var _pitch:Number = 0;
        private var _roll:Number = 0;
        private var _rotationIsStale:Boolean = false;
        private var _isTurnedByQuaternion:Boolean = false;
        private var _anglesAreStale:Boolean = false;

        /** Only Agent calls it. Creates a body at the origin, upright, of size 1. */
        public function AgentBody()
        {
        }

        /** The text by which errors name the agent. */
        public function toString():String
        {
            return "a new agent";
        }

        /** The position of the model's origin along the world's x axis, from -Agent.LARGEST_COORDINATE to Agent.LARGEST_COORDINATE. */
        public function get x():Number
        {
            return placement.x;
        }

        public function set x(value:Number):void
        {
            moveTo(value, placement.y, placement.z);
        }

        /** The position of the model's origin along the world's y axis, from -Agent.LARGEST_COORDINATE to Agent.LARGEST_COORDINATE. */
        public function get y():Number
        {
            return placement.y;
        }

        public function set y(value:Number):void
        {
            moveTo(placement.x, value, placement.z);
        }

        /**
         * The height of the model's origin over the ground, from -Agent.LARGEST_COORDINATE to Agent.LARGEST_COORDINATE. For an upright
         * agent, the origin is its lowest point.
         */
        public function get z():Number
        {
            return placement.z;
        }

        public function set z(value:Number):void
        {
            moveTo(placement.x, placement.y, value);
        }

        /** The turn about the z axis in degrees, counter-clockwise seen from above. Any finite number. */
        public function get heading():Number
        {
            findAngles();
            return _heading;
        }

        public function set heading(value:Number):void
        {
            findAngles();
            turnTo(value, _pitch, _roll);
        }

        /** The turn about the world's y axis in degrees, before the heading. Any finite number. */
        public function get pitch():Number
        {
            findAngles();
            return _pitch;
        }

        public function set pitch(value:Number):void
        {
            findAngles();
            turnTo(_heading, value, _roll);
        }

        /** The turn about the world's x axis in degrees, before the pitch. Any finite number. */
        public function get roll():Number
        {
            findAngles();
            return _roll;
        }

        public function set roll(value:Number):void
        {
            findAngles();
            turnTo(_heading, _pitch, value);
        }

        /** The uniform scale of the model, from Agent.SMALLEST_SIZE to Agent.LARGEST_SIZE. With 1 the agent is one patch wide. */
        public function get size():Number
        {
            return placement.size;
        }

        public function set size(value:Number):void
        {
            if (!(value >= Agent.SMALLEST_SIZE && value <= Agent.LARGEST_SIZE))
            {
                var range:String = value > 0 && value < Infinity ? "between " + Agent.SMALLEST_SIZE + " and " + Agent.LARGEST_SIZE : "a positive, finite number";
                throw new RangeError(this + ": size must be " + range + ", not " + value);
            }
            if (value != placement.size)
            {
                placement.size = value;
                extentsChanged();
            }
        }

        /**
         * Moves the agent to a place without a motion. A sweeping agent meets nothing on the way.
         *
         * @param x as in moveTo
         * @param y as in moveTo
         * @param z as in moveTo
         * @throws RangeError as in moveTo
         */
        public function jumpTo(x:Number, y:Number, z:Number):void
        {
            var before:int = revision;
            moveTo(x, y, z);
            // a jump counts even if the place is the same
            revision = before + 1;
            jumpRevision = revision;
        }

        /**
         * Moves the agent to a place. One call replaces setting x, y and z. If it is there already, nothing changes.
         *
         * @param x patches, from -Agent.LARGEST_COORDINATE to Agent.LARGEST_COORDINATE
         * @param y as x
         * @param z as x
         * @throws RangeError if one is not finite, or beyond Agent.LARGEST_COORDINATE; the agent then stays where it was
         */
        public function moveTo(x:Number, y:Number, z:Number):void
        {
            // LARGEST_COORDINATE squared; the comparison is false for NaN too
            if (!(x * x + y * y + z * z <= 1e18))
            {
                requireCoordinate("x", x);
                requireCoordinate("y", y);
                requireCoordinate("z", z);
            }
            var at:Placement = placement;
            if (x == at.x && y == at.y && z == at.z)
            {
                return;
            }
            at.x = x;
            at.y = y;
            at.z = z;
            revision++;
        }

        /**
         * A new matrix that transforms the model's space to the world. Use <code>getMatrix()</code> to write into an existing matrix
         * instead.
         */
        public function get transform():Matrix3D
        {
            return getMatrix();
        }

        /**
         * Turns the agent by a quaternion. It loses nothing when heading and roll turn about the same axis. Afterwards heading, pitch and
         * roll are angles that give the same rotation, with the pitch between -90 and 90. If you then set one of them, the three angles
         * make the rotation again.
         *
         * @param x of the quaternion x i + y j + z k + w; it may have any length but 0
         * @param y of the same quaternion
         * @param z of the same quaternion
         * @param w of the same quaternion
         * @throws RangeError if one is not finite, or all are 0; the agent is then unchanged
         */
        public function setQuaternion(x:Number, y:Number, z:Number, w:Number):void
        {
            requireFinite("a quaternion's x", x);
            requireFinite("a quaternion's y", y);
            requireFinite("a quaternion's z", z);
            requireFinite("a quaternion's w", w);
            var largest:Number = Math.max(Math.max(Math.abs(x), Math.abs(y)), Math.max(Math.abs(z), Math.abs(w)));
            if (largest == 0)
            {
                throw new RangeError(this + ": a quaternion must not be 0");
            }
            turnBy(x / largest, y / largest, z / largest, w / largest);
        }

        /**
         * The unit quaternion of the agent's rotation. Its w is not negative.
         *
         * @param out takes x, y, z, w; created if null
         * @return out
         */
        public function getQuaternion(out:Vector.<Number> = null):Vector.<Number>
        {
            out ||= new Vector.<Number>(4);
            worldPlacement().readQuaternion(out);
            return out;
        }

        /**
         * Moves, turns and scales the agent by a matrix. <code>transform</code> returns such a matrix. Flash Player stores a Matrix3D in
         * single precision, which rounds each number by up to 1e-7 of its size. The methods setQuaternion and moveTo and the property size keep
         * full precision.
         *
         * @param matrix from the model's space to the world; it may rotate, scale evenly and translate
         * @throws ArgumentError if it is null, or mirrors, shears, or scales unevenly
         * @throws RangeError if an agent can't have the place or the size. After either error the agent is unchanged
         */
        public function setMatrix(matrix:Matrix3D):void
        {
            if (matrix == null)
            {
                throw new ArgumentError(this + ": matrix must not be null");
            }
            var data:Vector.<Number> = matrix.rawData;
            var found:Placement = new Placement();
            if (!found.setMatrix(data))
            {
                throw new ArgumentError(this + ": matrix must turn, move and evenly scale, and nothing else: " + data);
            }
            requireCoordinate("x", found.x);
            requireCoordinate("y", found.y);
            requireCoordinate("z", found.z);
            size = found.size;
            moveTo(found.x, found.y, found.z);
            var turn:Vector.<Number> = new Vector.<Number>(4, true);
            found.readQuaternion(turn);
            turnBy(turn[0], turn[1], turn[2], turn[3]);
        }

        /**
         * The transform from the model's space to the world.
         *
         * @param out takes it; created if null
         * @return out
         */
        public function getMatrix(out:Matrix3D = null):Matrix3D
        {
            out ||= new Matrix3D();
            worldPlacement().writeMatrix(sMatrix);
            out.copyRawDataFrom(sMatrix);
            return out;
        }

        /** @private The agent's place in the world. Its rotation is up to date. */
        engine function worldPlacement():Placement
        {
            if (_rotationIsStale)
            {
                placement.setRotation(_heading, _pitch, _roll);
                _rotationIsStale = false;
            }
            return placement;
        }

        private function turnTo(heading:Number, pitch:Number, roll:Number):void
        {
            if (!isFinite(heading + pitch + roll))
            {
                requireFinite("heading", heading);
                requireFinite("pitch", pitch);
                requireFinite("roll", roll);
            }
            if (heading == _heading && pitch == _pitch && roll == _roll && !_isTurnedByQuaternion)
            {
                return;
            }
            _isTurnedByQuaternion = false;
            _heading = heading;
            _pitch = pitch;
            _roll = roll;
            _rotationIsStale = true;
            extentsChanged();
        }

        // Turns the agent by a quaternion of any length except 0.
        private function turnBy(x:Number, y:Number, z:Number, w:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z + w * w);
            sTurned.setQuaternion(x / length, y / length, z / length, w / length);
            if (!worldPlacement().hasRotationOf(sTurned))
            {
                placement.copyRotation(sTurned);
                _isTurnedByQuaternion = true;
                _anglesAreStale = true;
                extentsChanged();
            }
        }

        // It takes three arctangents, and most games that turn by quaternions never read the angles. So they are computed only when needed.
        private function findAngles():void
        {
            if (_anglesAreStale)
            {
                placement.readAngles(sAngles);
                _heading = sAngles.z;
                _pitch = sAngles.y;
                _roll = sAngles.x;
                _anglesAreStale = false;
            }
        }

        /** @private Call it after a change of anything but the place. */
        internal function extentsChanged():void
        {
            placement.extentsRevision++;
            revision++;
        }

        private function requireCoordinate(trait:String, value:Number):void
        {
            requireFinite(trait, value);
            if (!(value <= Agent.LARGEST_COORDINATE && value >= -Agent.LARGEST_COORDINATE))
            {
                throw new RangeError(this + ": " + trait + " must be between " + -Agent.LARGEST_COORDINATE + " and " + Agent.LARGEST_COORDINATE + ", not " + value);
            }
        }

        private function requireFinite(trait:String, value:Number):void
        {
            if (!isFinite(value))
            {
                throw new RangeError(this + ": " + trait + " must be a finite number, not " + value);
            }
        }
    }
}
