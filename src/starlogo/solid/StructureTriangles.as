package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.LeafTest;
    import starlogo.hierarchy.RelativePose;
    import starlogo.intersection.ClosestTriangles;
    import starlogo.intersection.TriangleBox;

    use namespace engine;

    /** Decides whether a triangle of a model's leaf touches a solid sphere, capsule or box. */
    internal final class StructureTriangles extends LeafTest
    {
        private var _pose:RelativePose;
        private var _solid:Solid;

        // The structure in the space of the model, by kind; its extents there, wider by what still touches: least x, greatest x, least y, ...
        private var _moved:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3);
        private var _structure:BoundingStructure;
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // The middles of the ends of a sphere or capsule, as a triangle.
        private var _core:Vector.<Number> = new Vector.<Number>(9, true);
        private var _closest:ClosestTriangles = new ClosestTriangles();
        private var _box:TriangleBox = new TriangleBox();

        /**
         * @param pose where the structure's space is in that of the model
         */
        public function StructureTriangles(pose:RelativePose)
        {
            _pose = pose;
        }

        /**
         * Prepares for a model and a structure that the pose relates.
         *
         * @return whether the model has triangles; otherwise nothing else may be asked
         */
        public function prepare(model:SolidHierarchy, structure:BoundingStructure):Boolean
        {
            if (!model.hasTriangles)
            {
                return false;
            }
            _solid = model.solid;
            var touching:Number = _pose.gap + Tolerances.SURFACES * model.root.radius;
            _moved[structure.kind] = structure.place(_pose.placement, _moved[structure.kind]);
            _structure = _moved[structure.kind];
            _structure.extentsInto(_extents);
            for (var i:int = 0; i < 6; i += 2)
            {
                _extents[i] -= touching;
                _extents[int(i + 1)] += touching;
            }
            if (structure.kind == BoundingStructure.BOX)
            {
                _box.box = Box(_structure);
                _box.tolerance = touching;
            }
            else if (structure.kind == BoundingStructure.CAPSULE)
            {
                var capsule:Capsule = Capsule(_structure);
                setCore(capsule.start, capsule.end, capsule.radius + touching);
            }
            else
            {
                var sphere:Sphere = Sphere(_structure);
                setCore(sphere.center, sphere.center, sphere.radius + touching);
            }
            return true;
        }

        /** @inheritDoc */
        override public function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            var extents:Vector.<Number> = _solid.extents;
            var corners:Vector.<Number> = _solid.corners;
            var isBox:Boolean = _structure.kind == BoundingStructure.BOX;
            for (var i:int = a.first; i < a.end; i++)
            {
                var at:int = 6 * i;
                if (extents[at] > _extents[1] || extents[int(at + 3)] < _extents[0] || extents[int(at + 1)] > _extents[3]
                        || extents[int(at + 4)] < _extents[2] || extents[int(at + 2)] > _extents[5] || extents[int(at + 5)] < _extents[4])
                {
                    continue;
                }
                if (isBox ? _box.touches(corners, 9 * i) : _closest.areWithin(corners, 9 * i, _core, 0))
                {
                    time = 0;
                    return true;
                }
            }
            return false;
        }

        private function setCore(start:Vector3D, end:Vector3D, reach:Number):void
        {
            _core[0] = start.x;
            _core[1] = start.y;
            _core[2] = start.z;
            _core[3] = _core[6] = end.x;
            _core[4] = _core[7] = end.y;
            _core[5] = _core[8] = end.z;
            _closest.reach = reach;
        }
    }
}
