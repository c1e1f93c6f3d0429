package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.broadphase.Points;
    import starlogo.convex.ContactPoint;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;

    use namespace engine;

    /**
     * A shape at a place in the world: what tests take. Each row of a table has a body. A question makes bodies: of an agent as it is now, of a
     * structure (StructureBody), or of another body at another place.
     *
     * <p>The body owns its extents. Only the table of a row moves the row's body, and copies these extents into its columns, for the bins.</p>
     *
     * @private
     */
    public final class Body
    {
        // The middle and half of the lengths of extents, within one call.
        private static var sExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /** The shape; null while the agent's model is loading. */
        public var shape:ModelShape = null;

        /** The shape's place, rotation and size in the world. */
        public var placement:Placement = new Placement();

        /**
         * Says which of two bodies comes first (ListedAgents.orderKeyOf); 0 without an agent. No test reads that of the ground or the edges.
         */
        public var orderKey:int = 0;

        /** The agent's own limit for the levels of its tree, or 0. */
        public var depthLimit:int = 0;

        /** Half of the length of the extents along x. */
        public var halfX:Number = 0;
        public var halfY:Number = 0;
        public var halfZ:Number = 0;

        /** Half of the largest and of the smallest extent. Fields, because V8 makes objects of the Numbers of getters that it does not inline. */
        public var maxHalf:Number = 0;
        public var minHalf:Number = 0;

        /** The way from the place to the middle of the extents. */
        public var offsetX:Number = 0;
        public var offsetY:Number = 0;
        public var offsetZ:Number = 0;

        // The structure where it was last put into the world.
        private var _placed:BoundingStructure = null;

        // Whether that is the body's place.
        private var _isPlaced:Boolean = false;

        // By the kind of structure: what _placed was before, for later use.
        private var _spares:Vector.<BoundingStructure> = null;

        /** Becomes the body of an agent as it is now, except for the order key. While the model is loading, the shape is null, and only the place counts. */
        public function setToAgent(agent:Agent, shape:ModelShape):void
        {
            placement.x = agent.placement.x;
            placement.y = agent.placement.y;
            placement.z = agent.placement.z;
            if (shape == null)
            {
                this.shape = null;
                return;
            }
            var size:Number = agent.placement.size;
            if (agent.isEnvironment)
            {
                // the structures of the ground and of the edges are not scaled
                size = 1;
            }
            depthLimit = agent.depthLimit;
            if (shape.ignoresRotation && shape === this.shape && size == placement.size)
            {
                // another turn changes nothing
                _isPlaced = false;
                return;
            }
            this.shape = shape;
            placement.copyRotation(shape.ignoresRotation ? Placement.IDENTITY : agent.freshPlacement());
            placement.size = size;
            findExtents();
        }

        /** Becomes the same as another body. While the other's model is loading, the shape is null, and only the place counts. */
        public function copyFrom(other:Body):void
        {
            shape = other.shape;
            orderKey = other.orderKey;
            depthLimit = other.depthLimit;
            placement.copyFrom(other.placement);
            offsetX = other.offsetX;
            offsetY = other.offsetY;
            offsetZ = other.offsetZ;
            halfX = other.halfX;
            halfY = other.halfY;
            halfZ = other.halfZ;
            maxHalf = other.maxHalf;
            minHalf = other.minHalf;
            _isPlaced = false;
        }

        /**
         * Makes the body smaller about the middle of its extents.
         *
         * @param fraction the part of the size that is taken off, from 0 to 1
         */
        public function shrink(fraction:Number):void
        {
            var factor:Number = 1 - fraction;
            placement.x += fraction * offsetX;
            placement.y += fraction * offsetY;
            placement.z += fraction * offsetZ;
            placement.size *= factor;
            offsetX *= factor;
            offsetY *= factor;
            offsetZ *= factor;
            halfX *= factor;
            halfY *= factor;
            halfZ *= factor;
            maxHalf *= factor;
            minHalf *= factor;
            _isPlaced = false;
        }

        /** Turns the body of an agent as if the agent's heading were greater by some degrees. */
        public function turn(agent:Agent, degrees:Number):void
        {
            if (!shape.ignoresRotation)
            {
                placement.setRotation(agent.heading + degrees, agent.pitch, agent.roll);
                findExtents();
            }
        }

        /** Takes the extents of the shape's tree, whose boxes a pose may have moved. */
        public function followPose():void
        {
            if (shape.tree != null)
            {
                shape.followPose();
                findExtents();
            }
        }

        /** Moves the body to the place of a row. */
        public function moveToRow(row:int, places:Points):void
        {
            var at:Placement = placement;
            if (places.x[row] != at.x || places.y[row] != at.y || places.z[row] != at.z)
            {
                at.x = places.x[row];
                at.y = places.y[row];
                at.z = places.z[row];
                _isPlaced = false;
            }
        }

        /** Moves the body to a place. */
        public function moveTo(place:Vector3D):void
        {
            if (place.x != placement.x || place.y != placement.y || place.z != placement.z)
            {
                placement.x = place.x;
                placement.y = place.y;
                placement.z = place.z;
                _isPlaced = false;
            }
        }

        /** The shape's kind. */
        public function get kind():int
        {
            return shape.kind;
        }

        /** Whether it is the body of the ground or of the edges of the world. */
        public function get isEnvironment():Boolean
        {
            return kind >= ModelShape.GROUND;
        }

        /** The middle of the extents. */
        public function get middleX():Number
        {
            return placement.x + offsetX;
        }

        /** @copy #middleX */
        public function get middleY():Number
        {
            return placement.y + offsetY;
        }

        /** @copy #middleX */
        public function get middleZ():Number
        {
            return placement.z + offsetZ;
        }

        /** The body's part of the gap across which shapes touch, because their places are rounded. */
        public function get margin():Number
        {
            return Touching.marginOfPlace(placement.x, placement.y, placement.z);
        }

        /** The structure in the world, widened by the margin. It is put there only when a test needs it. */
        public function worldStructure():BoundingStructure
        {
            if (!_isPlaced)
            {
                // not margin, because V8 makes an object for the Number of a getter
                var widening:Number = Touching.marginOfPlace(placement.x, placement.y, placement.z);
                if (kind == BoundingStructure.SPHERE)
                {
                    // the test of two spheres has no tolerance of its own, so the sphere is widened by it. Tests of a sphere and another structure
                    // have one
                    widening += (Tolerances.TOUCHING - 1) * halfX;
                }
                putIntoWorld(shape.structure, placement).widen(widening);
                _isPlaced = true;
            }
            return _placed;
        }

        /** The radius of a circle around the middle that encloses the extents, or the sphere, as seen from above. */
        engine function get radiusXY():Number
        {
            if (kind == BoundingStructure.SPHERE)
            {
                return halfX;
            }
            return Math.sqrt(halfX * halfX + halfY * halfY);
        }

        /** How far the middle of the extents is from the place. */
        public function get distanceFromPlace():Number
        {
            return Math.sqrt(offsetX * offsetX + offsetY * offsetY + offsetZ * offsetZ);
        }

        /** Half of the length of the extents along the normal of a contact. */
        public function halfAlong(contact:ContactPoint):Number
        {
            return halfX * Math.abs(contact.normalX) + halfY * Math.abs(contact.normalY) + halfZ * Math.abs(contact.normalZ);
        }

        /**
         * Whether tests take another body first. They have an order so that rounding errors are the same however the bodies come: a tree before a
         * structure, then by the agents' order keys, and the ground and the edges of the world last.
         */
        public function comesAfter(other:Body):Boolean
        {
            if (isEnvironment || other.isEnvironment)
            {
                return isEnvironment && !other.isEnvironment;
            }
            var isTree:Boolean = kind == ModelShape.TREE;
            if (isTree != (other.kind == ModelShape.TREE))
            {
                return !isTree;
            }
            return orderKey > other.orderKey;
        }

        /** Takes a shape, and half of the lengths of its extents, which come after their middle. The rest stays. */
        internal function takeShape(shape:ModelShape, extents:Vector.<Number>):void
        {
            this.shape = shape;
            takeHalves(extents);
            _isPlaced = false;
        }

        // Finds the extents of the shape, turned and scaled as the placement says.
        private function findExtents():void
        {
            shape.structure.findPlacedBox(placement, sExtents);
            offsetX = sExtents[0];
            offsetY = sExtents[1];
            offsetZ = sExtents[2];
            takeHalves(sExtents);
            _isPlaced = false;
        }

        private function takeHalves(extents:Vector.<Number>):void
        {
            halfX = extents[3];
            halfY = extents[4];
            halfZ = extents[5];
            var most:Number = halfX > halfY ? halfX : halfY;
            var least:Number = halfX < halfY ? halfX : halfY;
            maxHalf = Math.max(most, halfZ);
            minHalf = Math.min(least, halfZ);
        }

        // Puts a structure into the world, in an object of its kind: _placed.
        private function putIntoWorld(structure:BoundingStructure, at:Placement):BoundingStructure
        {
            var next:int = structure.kind;
            if (_placed != null && _placed.kind != next)
            {
                _spares ||= new Vector.<BoundingStructure>(BoundingStructure.KIND_COUNT, true);
                _spares[_placed.kind] = _placed;
                _placed = _spares[next];
            }
            _placed = structure.place(at, _placed);
            return _placed;
        }
    }
}
