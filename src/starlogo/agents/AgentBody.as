package starlogo.agents
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * Where an agent is in the world, how it is turned, and how large it is. Every Agent is one.
     *
     * <p>The world is right-handed with z up; lengths are in patches, angles in degrees. The agent's model is scaled by
     * <code>size</code>, turned by <code>roll</code> about x, <code>pitch</code> about y and <code>heading</code> about z
     * (the world's axes), and moved to (x, y, z), all about the model's origin: its centre in x and y and its lowest
     * point in z (thesis §2.2, §3.5).</p>
     *
     * <p>A trait that gets a value that it can't have throws a RangeError that names the agent, and keeps its value.</p>
     */
    public class AgentBody
    {
        private static var sTurned:Placement = new Placement();
        private static var sAngles:Vector3D = new Vector3D();
        private static var sMatrix:Vector.<Number> = new Matrix3D().rawData;

        /**
         * @private The agent's place in the world; its rotation may be stale, see <code>worldPlacement</code>. Its
         * <code>extentsRevision</code> counts every change of its turn, its size, its shape and how it collides: all that
         * changes its extents.
         */
        engine var placement:Placement = new Placement();

        /** @private Counts the changes of where and how the agent is in the world. */
        engine var revision:int = 0;

        /** @private The revision that the last jump made: there is no motion to it. */
        engine var jumpRevision:int = -1;

        private var _heading:Number = 0;
        private var _pitch:Number = 0;
        private var _roll:Number = 0;
        private var _rotationIsStale:Boolean = false;
        private var _isTurnedByQuaternion:Boolean = false;
        private var _anglesAreStale:Boolean = false;

        /** For Agent only. At the origin, upright, of size 1. */
        public function AgentBody()
        {
        }

        /** How errors name the agent. */
        public function toString():String
        {
            return "a new agent";
        }

        /** The position of the model's origin along the world's x axis, at most Agent.LARGEST_COORDINATE either way. */
        public function get x():Number
        {
            return placement.x;
        }

        public function set x(value:Number):void
        {
            moveTo(value, placement.y, placement.z);
        }

        /** The position of the model's origin along the world's y axis, at most Agent.LARGEST_COORDINATE either way. */
        public function get y():Number
        {
            return placement.y;
        }

        public function set y(value:Number):void
        {
            moveTo(placement.x, value, placement.z);
        }

        /**
         * The height of the model's lowest point over the ground when the agent stands upright, at most Agent.LARGEST_COORDINATE
         * either way.
         */
        public function get z():Number
        {
            return placement.z;
        }

        public function set z(value:Number):void
        {
            moveTo(placement.x, placement.y, value);
        }

        /** The turn about the z axis, counter-clockwise seen from above, in degrees, finite. */
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

        /** The turn about the world's y axis, before the heading, in degrees, finite. */
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

        /** The turn about the world's x axis, before the pitch, in degrees, finite. */
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

        /** The uniform scale of the model, from Agent.SMALLEST_SIZE to Agent.LARGEST_SIZE; 1 leaves it a unit wide. */
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
         * Moves the agent to a place without a motion: one that sweeps meets nothing in between.
         *
         * @param x as in moveTo
         * @param y as in moveTo
         * @param z as in moveTo
         * @throws RangeError as moveTo does
         */
        public function jumpTo(x:Number, y:Number, z:Number):void
        {
            var before:int = revision;
            moveTo(x, y, z);
            // a jump counts even to where it is
            revision = before + 1;
            jumpRevision = revision;
        }

        /**
         * Moves the agent, in one call instead of three. Nothing changes if it is there already.
         *
         * @param x patches, at most Agent.LARGEST_COORDINATE either way
         * @param y as x
         * @param z as x
         * @throws RangeError if one is not finite, or beyond Agent.LARGEST_COORDINATE; the agent then stays where it was
         */
        public function moveTo(x:Number, y:Number, z:Number):void
        {
            // LARGEST_COORDINATE squared; false for NaN too
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
         * The transform from the model's space to the world: a new matrix, which is the caller's. <code>getMatrix()</code> writes into a matrix
         * that is there already.
         */
        public function get transform():Matrix3D
        {
            return getMatrix();
        }

        /**
         * Turns the agent as a quaternion says, which loses nothing where heading and roll turn about the same axis. Afterwards heading, pitch and
         * roll are angles that give the same rotation, the pitch between -90 and 90; setting one of them makes the rotation of the
         * three again.
         *
         * @param x of the quaternion x i + y j + z k + w, of any length but 0
         * @param y of the same
         * @param z of the same
         * @param w of the same
         * @throws RangeError if one is not finite, or all are 0; the agent then stays as it was
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
         * The quaternion of the agent's rotation, of length 1, its w not negative.
         *
         * @param out takes it; made if null
         * @return out: x, y, z, w
         */
        public function getQuaternion(out:Vector.<Number> = null):Vector.<Number>
        {
            out ||= new Vector.<Number>(4);
            worldPlacement().readQuaternion(out);
            return out;
        }

        /**
         * Moves, turns and scales the agent as a matrix says: the counterpart of <code>transform</code>. Flash Player keeps a Matrix3D in
         * single precision, which loses 1e-7 of each; setQuaternion, moveTo and size lose nothing.
         *
         * @param matrix from the model's space to the world: turned, evenly scaled, moved
         * @throws ArgumentError if it is null, or mirrors, shears, or scales unevenly
         * @throws RangeError if the place or the size cannot be an agent's; in either case the agent stays as it was
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
         * @param out takes it; made if null
         * @return out
         */
        public function getMatrix(out:Matrix3D = null):Matrix3D
        {
            out ||= new Matrix3D();
            worldPlacement().writeMatrix(sMatrix);
            out.copyRawDataFrom(sMatrix);
            return out;
        }

        /** @private The agent's place in the world with its rotation up to date. */
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

        // By a quaternion of any length.
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

        // Three arctangents, which most games that turn by quaternions never need.
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

        /** @private Notes a change of more than the place. */
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
