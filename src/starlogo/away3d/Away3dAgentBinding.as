package starlogo.away3d
{
    import away3d.core.base.Object3D;
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.data.areSameNumbers;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.isInWorld;

    use namespace engine;

    /**
     * Keeps an agent and its Away3D object in the same place: position, all three turns and size. So the player sees what collides.
     *
     * <p>The object's parent must be the land: y up, one unit per patch. If the object is the source of an Away3dModel or contains it, pass
     * that model. It gives the object's origin and width. Without a model, the object must be normalised: one unit wide, with its lowest
     * point at its origin. The object may have a pivot point.</p>
     *
     * <p>Call <code>updateObject()</code> each frame if the agent leads, or <code>updateAgent()</code> if the object leads. Both compare
     * the two sides, because Away3D does not send an event for every change. They do nothing if nothing has changed, and they allocate
     * nothing.</p>
     *
     * <p>Away3D's DAEParser sets matrices, and the first change of position, rotation or scale overwrites them. So bind a new ObjectContainer3D
     * that contains the loaded object.</p>
     */
    public final class Away3dAgentBinding
    {
        private static var sRotation:SwappedRotation = new SwappedRotation();
        private static var sComponents:Vector.<Number> = new Vector.<Number>(12, true);

        private var _agent:Agent;
        private var _object:Object3D;

        // The model's origin in the object's own space, in Away3D's axes, and the model's width there.
        private var _origin:Vector3D = new Vector3D();
        private var _width:Number = 1;

        // The state of both sides at the last update: the agent's revision, and the components of the object's transform.
        private var _revision:int = -1;
        private var _components:Vector.<Number> = new Vector.<Number>(12, true);

        /**
         * Creates a binding. It changes neither side.
         *
         * @param agent the agent
         * @param object its object, for example a Mesh or a container
         * @param model the agent's model, if the object is its source or has the same geometry; null if the object is drawn normalised
         * @throws ArgumentError if the agent or the object is null
         */
        public function Away3dAgentBinding(agent:Agent, object:Object3D, model:Away3dModel = null)
        {
            requireGiven("agent", agent);
            requireGiven("object", object);
            _agent = agent;
            _object = object;
            if (model != null)
            {
                _origin = model.origin;
                _width = model.width;
            }
        }

        /** The agent. */
        public function get agent():Agent
        {
            return _agent;
        }

        /** The agent's object. */
        public function get object():Object3D
        {
            return _object;
        }

        /** Gives the object the agent's place, size and turns. */
        public function updateObject():void
        {
            if (isUnchanged())
            {
                return;
            }
            var drawn:Object3D = _object;
            var scale:Number = _agent.size / _width;
            var pivot:Vector3D = drawn.pivotPoint;
            var rotation:SwappedRotation = sRotation;
            var angles:Vector3D = rotation.setAngles(_agent.heading, _agent.pitch, _agent.roll);
            // unlike moveTo, rotateTo always causes the matrix to be computed again
            if (differ(angles.x, drawn.rotationX) || differ(angles.y, drawn.rotationY) || differ(angles.z, drawn.rotationZ))
            {
                drawn.rotateTo(angles.x, angles.y, angles.z);
            }
            drawn.scaleX = drawn.scaleY = drawn.scaleZ = scale;
            // y and z are swapped, because it turns in the agent's space
            var offset:Vector3D = rotation.rotate(scale * _origin.x - pivot.x, scale * _origin.z - pivot.z, scale * _origin.y - pivot.y);
            drawn.moveTo(_agent.x - pivot.x - offset.x, _agent.z - pivot.y - offset.z, _agent.y - pivot.z - offset.y);
            remember();
        }

        /**
         * Gives the agent the object's place, size and turns.
         *
         * @throws ArgumentError if the object's scale is mirrored, not uniform, zero or not finite, or another of its numbers is not finite; the
         * agent is then unchanged
         * @throws RangeError if the agent can't have that size or place; the agent is then unchanged
         */
        public function updateAgent():void
        {
            if (isUnchanged())
            {
                return;
            }
            var drawn:Object3D = _object;
            var pivot:Vector3D = drawn.pivotPoint;
            var scale:Number = drawn.scaleX;
            checkScale();
            var rotation:SwappedRotation = sRotation;
            var angles:Vector3D = rotation.setAngles(drawn.rotationZ, drawn.rotationY, drawn.rotationX);
            var offset:Vector3D = rotation.rotate(scale * _origin.x - pivot.x, scale * _origin.y - pivot.y, scale * _origin.z - pivot.z);
            var x:Number = drawn.x + pivot.x + offset.x;
            var y:Number = drawn.z + pivot.z + offset.z;
            var z:Number = drawn.y + pivot.y + offset.y;
            checkPlace(x, y, z, angles.x + angles.y + angles.z, scale * _width);
            if (x != _agent.x || y != _agent.y || z != _agent.z)
            {
                _agent.moveTo(x, y, z);
            }
            _agent.heading = angles.z;
            _agent.pitch = angles.y;
            _agent.roll = angles.x;
            _agent.size = scale * _width;
            remember();
        }

        private function isUnchanged():Boolean
        {
            if (_agent.revision != _revision)
            {
                return false;
            }
            readComponents(sComponents);
            return areSameNumbers(sComponents, _components);
        }

        private function remember():void
        {
            _revision = _agent.revision;
            readComponents(_components);
        }

        private function readComponents(components:Vector.<Number>):void
        {
            var drawn:Object3D = _object;
            var pivot:Vector3D = drawn.pivotPoint;
            components[0] = drawn.x;
            components[1] = drawn.y;
            components[2] = drawn.z;
            components[3] = drawn.rotationX;
            components[4] = drawn.rotationY;
            components[5] = drawn.rotationZ;
            components[6] = drawn.scaleX;
            components[7] = drawn.scaleY;
            components[8] = drawn.scaleZ;
            components[9] = pivot.x;
            components[10] = pivot.y;
            components[11] = pivot.z;
        }

        // The object stores radians, so an angle comes back rounded.
        private static function differ(angle:Number, rotation:Number):Boolean
        {
            return !(Math.abs(angle - rotation) <= Tolerances.ROUNDING * Math.abs(angle));
        }

        private function checkScale():void
        {
            var x:Number = _object.scaleX;
            var y:Number = _object.scaleY;
            var z:Number = _object.scaleZ;
            var most:Number = x * Tolerances.SINGLE_PRECISION;
            // the comparisons are false for NaN too
            if (!(x > 0 && x < Infinity && Math.abs(y - x) <= most && Math.abs(z - x) <= most))
            {
                throw new ArgumentError(_agent + " can't take the scale of its object: it must be positive, finite and the same in x, y and z, not "
                        + x + ", " + y + ", " + z);
            }
        }

        private function checkPlace(x:Number, y:Number, z:Number, turns:Number, size:Number):void
        {
            if (!isFinite(x) || !isFinite(y) || !isFinite(z) || !isFinite(turns))
            {
                throw new ArgumentError(_agent + " can't take the place of its object: position, rotation and pivot point must be finite numbers, not ("
                        + _object.x + ", " + _object.y + ", " + _object.z + "), (" + _object.rotationX + ", " + _object.rotationY + ", "
                        + _object.rotationZ + ") and " + _object.pivotPoint);
            }
            if (!Agent.isSize(size) || !isInWorld(x, y, z))
            {
                throw new RangeError(_agent + " can't be of size " + size + " at (" + x + ", " + y + ", " + z + "), as its object demands: see Agent's limits");
            }
        }
    }
}
