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
    import starlogo.intersection.ClosestTriangles;
    import starlogo.intersection.TriangleBox;

    use namespace engine;

    /** Decides whether a triangle in a model's leaf touches a solid sphere, capsule or box. */
    internal final class StructureTriangles extends LeafTest
    {
        private var _solid:Solid;

        // The structure's extents, enlarged by the gap that still counts as touching: minX, maxX, minY, maxY, minZ, maxZ.
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // A sphere's centre or the ends of a capsule's axis, as a triangle.
        private var _core:Vector.<Number> = new Vector.<Number>(9, true);
        private var _closest:ClosestTriangles = new ClosestTriangles();
        private var _box:TriangleBox = new TriangleBox();
        private var _isBox:Boolean;

        /** Creates a test without a model. */
        public function StructureTriangles()
        {
        }

        /**
         * Begins with a model that has triangles.
         *
         * @param model the model's hierarchy
         * @param structure in the model's space
         * @param gap the largest gap that still counts as touching, in addition to the model's rounding
         */
        public function begin(model:SolidHierarchy, structure:BoundingStructure, gap:Number):void
        {
            _solid = model.solid;
            var touching:Number = gap + Tolerances.SURFACES * model.root.radius;
            structure.extentsInto(_extents);
            for (var i:int = 0; i < 6; i += 2)
            {
                _extents[i] -= touching;
                _extents[int(i + 1)] += touching;
            }
            _isBox = structure.kind == BoundingStructure.BOX;
            if (_isBox)
            {
                _box.box = Box(structure);
                _box.tolerance = touching;
            }
            else if (structure.kind == BoundingStructure.CAPSULE)
            {
                var capsule:Capsule = Capsule(structure);
                setCore(capsule.start, capsule.end, capsule.radius + touching);
            }
            else
            {
                var sphere:Sphere = Sphere(structure);
                setCore(sphere.center, sphere.center, sphere.radius + touching);
            }
        }

        /** @inheritDoc */
        override public function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            var extents:Vector.<Number> = _solid.extents;
            var corners:Vector.<Number> = _solid.corners;
            for (var i:int = a.first; i < a.end; i++)
            {
                var at:int = 6 * i;
                if (extents[at] > _extents[1] || extents[int(at + 3)] < _extents[0] || extents[int(at + 1)] > _extents[3]
                        || extents[int(at + 4)] < _extents[2] || extents[int(at + 2)] > _extents[5] || extents[int(at + 5)] < _extents[4])
                {
                    continue;
                }
                if (_isBox ? _box.touches(corners, 9 * i) : _closest.areWithin(corners, 9 * i, _core, 0))
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
