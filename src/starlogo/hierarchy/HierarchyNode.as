package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.engine;

    use namespace engine;

    /**
     * A node of a model's hierarchy: a box around a part of the model, and two child nodes that divide this part between them (thesis §4.3).
     *
     * <p>A part consists of whole triangles, or of vertices if the model has no triangles. A node's box encloses its children's boxes. All
     * coordinates are in the model's space.</p>
     *
     * <p>The engine's tree goes on below the leaves that clients see, down to a few triangles, for exact tests. These nodes are made when they
     * are first visited. No visit with a depth limit reaches them.</p>
     */
    public final class HierarchyNode
    {
        /**
         * @private The largest depth limit. A visit with it ends at the thesis's leaves. A visit with int.MAX_VALUE has no limit and goes
         *     on below them.
         */
        engine static const LARGEST_DEPTH:int = int.MAX_VALUE - 1;

        /** @private The child on the low side of the split, or null. Below the thesis's leaves, null until <code>goesBelow()</code>. */
        engine var low:HierarchyNode = null;

        /** @private The child on the high side of the split, or null, as the other child. */
        engine var high:HierarchyNode = null;

        /** The children's boxes in the hierarchy's packed tree. Null if that is not prepared, or if the node has no children in it. */
        internal var pair:BoxPair = null;

        /** @private The hierarchy to which the node belongs. */
        engine var hierarchy:Hierarchy;

        /** @private The number of levels down to this one. The root has 1. The node of a StructureLeaf has 0. */
        engine var level:int = 0;

        /**
         * @private The largest depth limit for which a visit does not go below this node: the node's level; LARGEST_DEPTH for a leaf of the
         *     thesis; int.MAX_VALUE without children.
         */
        engine var stopDepth:int = int.MAX_VALUE;

        /** @private The index of the node's first item in the hierarchy's order. */
        engine var first:int;

        /** @private The index after the node's last item in the hierarchy's order. */
        engine var end:int;

        /** @private The x of the axis-aligned box's middle. */
        engine var x:Number;

        /** @private The y of the middle. */
        engine var y:Number;

        /** @private The z of the middle. */
        engine var z:Number;

        /** @private Half of the box's extent along x. */
        engine var halfX:Number;

        /** @private Half of the extent along y. */
        engine var halfY:Number;

        /** @private Half of the extent along z. */
        engine var halfZ:Number;

        /** @private The radius of the sphere around the box. */
        engine var radius:Number;

        /** @private The radius of the largest sphere inside of the box, about its middle. */
        engine var innerRadius:Number;

        /** @private The axis along which the node is split: 0, 1 or 2. */
        engine var splitAxis:int = 0;

        // Null until bounds is read.
        private var _bounds:Box = null;

        private var _vertexCount:int = 0;

        /** Not for clients: the HierarchiesLibrary makes the nodes. */
        public function HierarchyNode()
        {
        }

        /** The child on the low side of the split, or null. */
        public function get left():HierarchyNode
        {
            return isLeaf ? null : low;
        }

        /** The child on the high side of the split, or null. */
        public function get right():HierarchyNode
        {
            return isLeaf ? null : high;
        }

        /** Whether the node has no children that clients see. */
        public function get isLeaf():Boolean
        {
            return stopDepth >= LARGEST_DEPTH;
        }

        /**
         * The number of vertices under the node. If the model has triangles, these are the vertices of the node's triangles, each counted
         * once. Then the counts of two children add up to more than their parent's if they share vertices.
         */
        public function get vertexCount():int
        {
            if (_vertexCount == 0)
            {
                _vertexCount = hierarchy.countVertices(first, end);
            }
            return _vertexCount;
        }

        /**
         * The axis-aligned box around the node's part. It is slightly larger than the part (Tolerances.SURFACES and NESTING). The object
         * belongs to the node, so clone it before changing it.
         */
        public function get bounds():BoundingStructure
        {
            _bounds ||= new Box(new Vector3D(x, y, z), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, halfX, halfY, halfZ);
            return _bounds;
        }

        /** The number of triangles under the node; 0 if only vertices are known. */
        public function get triangleCount():int
        {
            return hierarchy.hasTriangles ? end - first : 0;
        }

        /**
         * The indices of the triangles under the node, in ascending order. The model's first triangle is 0.
         *
         * @param out overwritten; created if null
         * @return out
         */
        public function triangleIndices(out:Vector.<int> = null):Vector.<int>
        {
            return writeItems(hierarchy.hasTriangles, out);
        }

        /**
         * The indices of the vertices under the node, in ascending order, if only vertices are known. The model's first vertex is 0. Empty
         * if the model has triangles, because these name their vertices.
         *
         * @param out overwritten; created if null
         * @return out
         */
        public function vertexIndices(out:Vector.<int> = null):Vector.<int>
        {
            return writeItems(!hierarchy.hasTriangles, out);
        }

        /** @private Whether a visit goes below this node. Makes the children if they are below the thesis's leaves and not made yet. */
        engine function goesBelow(depth:int):Boolean
        {
            if (stopDepth < depth && low == null)
            {
                hierarchy.tree.makeChildren(this);
            }
            return stopDepth < depth;
        }

        /** @private Forgets the children below the thesis's leaves if they can be made again. */
        engine function forgetChildren():void
        {
            if (isLeaf && pair != null)
            {
                low = high = null;
            }
        }

        /** @private Sets the half-extents of the box, and the two radii. */
        engine function setHalfExtents(halfX:Number, halfY:Number, halfZ:Number):void
        {
            this.halfX = halfX;
            this.halfY = halfY;
            this.halfZ = halfZ;
            radius = Math.sqrt(halfX * halfX + halfY * halfY + halfZ * halfZ);
            innerRadius = halfX < halfY ? halfX : halfY;
            innerRadius = halfZ < innerRadius ? halfZ : innerRadius;
        }

        /**
         * @private Gives the node two children. It must not have any yet.
         *
         * @param axis the axis along which it is split
         * @param low the child on the low side
         * @param high the child on the high side
         * @param stopDepth the largest depth limit at which a visit ends at the node
         */
        engine function divide(axis:int, low:HierarchyNode, high:HierarchyNode, stopDepth:int):void
        {
            this.stopDepth = stopDepth;
            splitAxis = axis;
            this.low = low;
            this.high = high;
        }

        /** @private Sets an axis-aligned box to the node's box, and returns it. */
        engine function writeBox(box:Box):Box
        {
            var center:Vector3D = box.center;
            center.x = x;
            center.y = y;
            center.z = z;
            box.halfX = halfX;
            box.halfY = halfY;
            box.halfZ = halfZ;
            return box;
        }

        /** The axis along which the box is longest: 0, 1 or 2. */
        internal function longestAxis():int
        {
            if (halfX >= halfY && halfX >= halfZ)
            {
                return 0;
            }
            return halfY >= halfZ ? 1 : 2;
        }

        private function writeItems(areAsked:Boolean, out:Vector.<int>):Vector.<int>
        {
            out ||= new Vector.<int>();
            out.length = 0;
            for (var i:int = first; areAsked && i < end; i++)
            {
                out.push(hierarchy.order[i]);
            }
            out.sort(Array.NUMERIC);
            return out;
        }
    }
}
