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
    import starlogo.intersection.TriangleAxes;
    import starlogo.intersection.triangleTriangle;

    use namespace engine;

    /** Decides whether a triangle of a model's leaf touches a solid sphere, capsule or box. */
    internal final class StructureTriangles extends LeafTest
    {
        // The corners of the triangles of a box: bit 0 of a corner's number says on which side along the box's x axis it is, and so on.
        private static const FACES:Vector.<int> = new <int>[0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6,
                1, 3, 5, 3, 7, 5];

        private var _pose:RelativePose;
        private var _solid:Solid;
        private var _touching:Number;
        private var _closest:ClosestTriangles = new ClosestTriangles();

        // The structure in the space of the model, by kind; its extents there, wider by what still touches: least x, greatest x, least y, ...
        private var _moved:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3);
        private var _structure:BoundingStructure;
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // Of a sphere or capsule the middles of its ends, as a triangle, and the squared distance at which it touches; of a box its faces.
        private var _core:Vector.<Number> = new Vector.<Number>(9, true);
        private var _radius:Number = 0;
        private var _reach:Number;
        private var _axes:TriangleAxes = new TriangleAxes();
        private var _faces:Vector.<Number> = new Vector.<Number>(108, true);

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
            _touching = _pose.gap + Tolerances.SURFACES * model.root.radius;
            _axes.tolerance = _touching;
            _moved[structure.kind] = structure.place(_pose.placement, _moved[structure.kind]);
            _structure = _moved[structure.kind];
            _structure.extentsInto(_extents);
            for (var i:int = 0; i < 6; i += 2)
            {
                _extents[i] -= _touching;
                _extents[int(i + 1)] += _touching;
            }
            if (structure.kind == BoundingStructure.BOX)
            {
                setFaces(Box(_structure));
            }
            else if (structure.kind == BoundingStructure.CAPSULE)
            {
                var capsule:Capsule = Capsule(_structure);
                _radius = capsule.radius;
                setCore(capsule.start, capsule.end);
            }
            else
            {
                var sphere:Sphere = Sphere(_structure);
                _radius = sphere.radius;
                setCore(sphere.center, sphere.center);
            }
            return true;
        }

        /** @inheritDoc */
        override public function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            var extents:Vector.<Number> = _solid.extents;
            for (var i:int = a.first; i < a.end; i++)
            {
                var at:int = 6 * i;
                if (extents[at] > _extents[1] || extents[int(at + 3)] < _extents[0] || extents[int(at + 1)] > _extents[3]
                        || extents[int(at + 4)] < _extents[2] || extents[int(at + 2)] > _extents[5] || extents[int(at + 5)] < _extents[4])
                {
                    continue;
                }
                if (_structure.kind == BoundingStructure.BOX ? touchesBox(9 * i) : touchesCore(9 * i))
                {
                    time = 0;
                    return true;
                }
            }
            return false;
        }

        private function touchesCore(at:int):Boolean
        {
            _closest.begin();
            _closest.add(_solid.corners, at, _core, 0);
            return _closest.squared <= _reach;
        }

        // A triangle that meets no face of the box is inside of it as a whole, or outside.
        private function touchesBox(at:int):Boolean
        {
            var corners:Vector.<Number> = _solid.corners;
            var box:Box = Box(_structure);
            var x:Number = corners[at] - box.center.x;
            var y:Number = corners[int(at + 1)] - box.center.y;
            var z:Number = corners[int(at + 2)] - box.center.z;
            if (Math.abs(x * box.axisX.x + y * box.axisX.y + z * box.axisX.z) <= box.halfX
                    && Math.abs(x * box.axisY.x + y * box.axisY.y + z * box.axisY.z) <= box.halfY
                    && Math.abs(x * box.axisZ.x + y * box.axisZ.y + z * box.axisZ.z) <= box.halfZ)
            {
                return true;
            }
            for (var face:int = 0; face < 108; face += 9)
            {
                if (triangleTriangle(corners, at, _faces, face, _axes))
                {
                    return true;
                }
            }
            return false;
        }

        private function setCore(start:Vector3D, end:Vector3D):void
        {
            _core[0] = start.x;
            _core[1] = start.y;
            _core[2] = start.z;
            _core[3] = _core[6] = end.x;
            _core[4] = _core[7] = end.y;
            _core[5] = _core[8] = end.z;
            _reach = (_radius + _touching) * (_radius + _touching);
        }

        private function setFaces(box:Box):void
        {
            for (var i:int = 0; i < 36; i++)
            {
                var corner:int = FACES[i];
                var alongX:Number = box.halfX * (2 * (corner & 1) - 1);
                var alongY:Number = box.halfY * ((corner & 2) - 1);
                var alongZ:Number = box.halfZ * ((corner & 4) / 2 - 1);
                _faces[3 * i] = box.center.x + box.axisX.x * alongX + box.axisY.x * alongY + box.axisZ.x * alongZ;
                _faces[int(3 * i + 1)] = box.center.y + box.axisX.y * alongX + box.axisY.y * alongY + box.axisZ.y * alongZ;
                _faces[int(3 * i + 2)] = box.center.z + box.axisX.z * alongX + box.axisY.z * alongY + box.axisZ.z * alongZ;
            }
        }
    }
}
