package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.engine;

    use namespace engine;

    /**
     * A node of a model's hierarchy: a structure around a part of the model, and the two nodes that share that part
     * between them (thesis §4.3).
     *
     * <p>A part is made of whole triangles where the model has them, otherwise of vertices. The structure of a node
     * encloses the node's own part, not those of its children: a child's sphere or capsule may reach out of its
     * parent's. All is in the model's space.</p>
     *
     * <p>For exact tests the tree goes on below the thesis's leaves, down to a few triangles. For a client it ends with those leaves,
     * and so does a visit with any depth limit.</p>
     */
    public final class HierarchyNode
    {
        /** @private The largest depth limit: a visit with it ends at the thesis's leaves, and one without a limit, int.MAX_VALUE, goes on below. */
        engine static const LARGEST_DEPTH:int = int.MAX_VALUE - 1;

        /** @private The child on the low side of the split, or null: below the thesis's leaves too. */
        engine var low:HierarchyNode;

        /** @private The child on the high side of the split, or null: as low. */
        engine var high:HierarchyNode;

        /** @private The hierarchy that the node is of. */
        engine var hierarchy:Hierarchy;

        /** @private The number of levels down to this one, the root's being 1; 0 for a node that represents a single structure. */
        engine var level:int = 0;

        /** @private The largest depth limit at which a visit ends here: its level, or for a leaf of the thesis's LARGEST_DEPTH, or for one without children any. */
        engine var cutoffLevel:int = int.MAX_VALUE;

        /** @private The node's items are those from first up to, and not including, end in the hierarchy's order. */
        engine var first:int;

        /** @private As first. */
        engine var end:int;

        /** @private The middle of the axis-aligned box. */
        engine var x:Number;

        /** @private As x. */
        engine var y:Number;

        /** @private As x. */
        engine var z:Number;

        /** @private Half the extents of the box. */
        engine var halfX:Number;

        /** @private As halfX. */
        engine var halfY:Number;

        /** @private As halfX. */
        engine var halfZ:Number;

        /** @private The radius of the sphere around the box. */
        engine var radius:Number;

        /** @private The radius of the largest sphere inside of the box, about its middle. */
        engine var innerRadius:Number;

        /** @private The axis that the node is split along: 0, 1 or 2. */
        engine var splitAxis:int = 0;

        /** @private The sphere or capsule; null where the box is the node's structure, until it is asked for. */
        engine var structure:BoundingStructure;

        /** @private The structure made thick enough for those of all the node's descendants; null where its own is: for a box and a leaf. */
        engine var cover:BoundingStructure = null;

        private var _vertexCount:int = 0;

        /** Made by the HierarchiesLibrary. */
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

        /** Whether the node has no children. */
        public function get isLeaf():Boolean
        {
            return cutoffLevel >= LARGEST_DEPTH;
        }

        /**
         * How many vertices are under the node: those of its triangles, each once, where the model has triangles. The
         * counts of two children then add up to more than their parent's where they share vertices.
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
         * The structure around the node's part: an axis-aligned box, or what the library's boundsKind was when the model
         * was added. It is a little wider than the part (Tolerances.SURFACES and NESTING). The node's own: clone it before
         * changing it.
         */
        public function get bounds():BoundingStructure
        {
            if (structure == null)
            {
                structure = new Box(new Vector3D(x, y, z), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS,
                        halfX, halfY, halfZ);
            }
            return structure;
        }

        /** How many triangles are under the node; 0 where only vertices are known. */
        public function get triangleCount():int
        {
            return hierarchy.hasTriangles ? end - first : 0;
        }

        /**
         * The numbers of the triangles under the node, the smallest first; the model's first triangle is 0.
         *
         * @param out overwritten; made if null
         * @return out
         */
        public function triangleIndices(out:Vector.<int> = null):Vector.<int>
        {
            return writeItems(hierarchy.hasTriangles, out);
        }

        /**
         * The numbers of the vertices under the node, the smallest first, where only vertices are known; the model's first vertex is 0.
         * With triangles, none: the triangles name the vertices.
         *
         * @param out overwritten; made if null
         * @return out
         */
        public function vertexIndices(out:Vector.<int> = null):Vector.<int>
        {
            return writeItems(!hierarchy.hasTriangles, out);
        }

        /** @private Sets the box's size, and the radii that follow from it. */
        engine function setHalfExtents(halfX:Number, halfY:Number, halfZ:Number):void
        {
            this.halfX = halfX;
            this.halfY = halfY;
            this.halfZ = halfZ;
            radius = Math.sqrt(halfX * halfX + halfY * halfY + halfZ * halfZ);
            innerRadius = halfX < halfY ? halfX : halfY;
            innerRadius = halfZ < innerRadius ? halfZ : innerRadius;
        }

        /** Makes an axis-aligned box that of the node; returns it. */
        internal function writeBox(box:Box):Box
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
