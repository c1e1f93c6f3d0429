package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.intersects;
    import starlogo.intersection.sweep.findTimeOfImpact;

    use namespace engine;

    /**
     * A structure as a tree of one node, the box around it along its own axes. If the structure is a box, its node decides like any other. If
     * it is not, this test compares it with a node's box, by the kernel of the two.
     *
     * @private
     */
    public final class StructureLeaf extends LeafTest
    {
        /** The tree of one node, in the space of the structure's own axes. Its level is 0. */
        public var tree:BoxTree = BoxTree.ofOneNode();

        /** That space's pose in the first model's space, and the structure's motion from there. */
        public var pose:RelativePose = new RelativePose();

        /** The structure in the first model's space, enlarged by the gap across which shapes touch. */
        public var moved:BoundingStructure = null;

        // A structure for each kind, and the axis of a capsule.
        private var _placed:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(BoundingStructure.KIND_COUNT, true);
        private var _axis:Vector3D = new Vector3D();
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);

        /**
         * Begins with a structure.
         *
         * @param structure in its model's space
         * @param models that model's pose in the first model's space
         */
        public function begin(structure:BoundingStructure, models:RelativePose):void
        {
            var kind:int = structure.kind;
            var placed:BoundingStructure = structure.place(models.placement, _placed[kind]);
            // Writing an object to a field costs Adobe's VM more than comparing it first.
            if (moved !== placed)
            {
                moved = _placed[kind] = placed;
            }
            if (pose.motion !== models.motion)
            {
                pose.motion = models.motion;
            }
            models.widen(placed);
            pose.gap = models.gap;
            pose.placement.size = models.placement.size;
            if (kind == BoundingStructure.BOX)
            {
                beginBox(Box(structure), Box(placed));
            }
            else if (kind > BoundingStructure.BOX)
            {
                beginExtents(structure, models.placement);
            }
            else if (kind == BoundingStructure.SPHERE)
            {
                var sphere:Sphere = Sphere(structure);
                var placedSphere:Sphere = Sphere(placed);
                setMiddle(placedSphere.center);
                setAxis(0, 0, 1);
                setExtents(sphere.radius, 0);
            }
            else
            {
                beginCapsule(Capsule(structure), Capsule(placed));
            }
        }

        /** The test that decides about the leaves of the first model: this, or null if the node's box decides. */
        public function get decider():LeafTest
        {
            return moved.kind == BoundingStructure.BOX ? null : this;
        }

        /** @inheritDoc */
        override public function touch(treeA:BoxTree, a:int, treeB:BoxTree, b:int):Boolean
        {
            var motion:RelativeMotion = pose.motion;
            treeA.writeBox(a, _box);
            if (motion === RelativeMotion.NONE)
            {
                return intersects(_box, moved);
            }
            findTimeOfImpact(moved, _box, motion);
            if (!(motion.time <= least))
            {
                return false;
            }
            least = motion.time;
            return true;
        }

        private function beginBox(box:Box, placed:Box):void
        {
            var relative:Placement = pose.placement;
            setMiddle(placed.center);
            relative.r00 = placed.axisX.x;
            relative.r10 = placed.axisX.y;
            relative.r20 = placed.axisX.z;
            relative.r01 = placed.axisY.x;
            relative.r11 = placed.axisY.y;
            relative.r21 = placed.axisY.z;
            relative.r02 = placed.axisZ.x;
            relative.r12 = placed.axisZ.y;
            relative.r22 = placed.axisZ.z;
            var distance:Number = Math.abs(box.center.x) + Math.abs(box.center.y) + Math.abs(box.center.z);
            var margin:Number = Tolerances.ROUNDING * (box.halfX + box.halfY + box.halfZ + distance);
            tree.setOnlyBox(box.halfX + margin, box.halfY + margin, box.halfZ + margin);
        }

        // The node is the box around the extents in the structure's model's space.
        private function beginExtents(structure:BoundingStructure, placement:Placement):void
        {
            var extents:Vector.<Number> = _extents;
            structure.extentsInto(extents);
            _axis.setTo((extents[0] + extents[1]) / 2, (extents[2] + extents[3]) / 2, (extents[4] + extents[5]) / 2);
            placement.place(_axis, _axis);
            setMiddle(_axis);
            pose.placement.copyRotation(placement);
            pose.placement.isIdentity = false;
            tree.setOnlyBox((extents[1] - extents[0]) / 2, (extents[3] - extents[2]) / 2, (extents[5] - extents[4]) / 2);
        }

        private function beginCapsule(capsule:Capsule, placed:Capsule):void
        {
            var start:Vector3D = placed.start;
            var end:Vector3D = placed.end;
            var x:Number = end.x - start.x;
            var y:Number = end.y - start.y;
            var z:Number = end.z - start.z;
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            _axis.setTo((start.x + end.x) / 2, (start.y + end.y) / 2, (start.z + end.z) / 2);
            setMiddle(_axis);
            if (length > 0)
            {
                setAxis(x / length, y / length, z / length);
            }
            else
            {
                setAxis(0, 0, 1);
            }
            setExtents(capsule.radius, length / 2 / pose.placement.size);
        }

        private function setMiddle(middle:Vector3D):void
        {
            pose.placement.x = middle.x;
            pose.placement.y = middle.y;
            pose.placement.z = middle.z;
        }

        // Sets the node's z axis to a unit vector, and the other two to any that are perpendicular to it (Duff and others, "Building an
        // orthonormal basis, revisited", 2017).
        private function setAxis(x:Number, y:Number, z:Number):void
        {
            var relative:Placement = pose.placement;
            var sign:Number = z < 0 ? -1 : 1;
            var share:Number = -1 / (sign + z);
            relative.r00 = 1 + sign * x * x * share;
            relative.r10 = sign * x * y * share;
            relative.r20 = -sign * x;
            relative.r01 = x * y * share;
            relative.r11 = sign + y * y * share;
            relative.r21 = -y;
            relative.r02 = x;
            relative.r12 = y;
            relative.r22 = z;
        }

        // Sets the extents of a sphere or capsule with half of its axis' length. The kernels find a touch a little beyond the radius.
        private function setExtents(radius:Number, half:Number):void
        {
            var reach:Number = radius + Tolerances.EXTENTS * (radius + half);
            tree.setOnlyBox(reach, reach, reach + half);
        }
    }
}
