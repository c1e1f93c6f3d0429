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
    internal class StructureTriangles extends LeafTest
    {
        protected var solid:Solid;

        /** How far apart a triangle and the structure may be and still touch. */
        protected var touching:Number = 0;

        /** The structure's extents, enlarged by <code>touching</code>: least x, greatest x, least y, ... */
        protected var extents:Vector.<Number> = new Vector.<Number>(6, true);

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
            solid = model.solid;
            touching = gap + Tolerances.SURFACES * model.root.radius;
            structure.extentsInto(extents);
            for (var i:int = 0; i < 6; i += 2)
            {
                extents[i] -= touching;
                extents[int(i + 1)] += touching;
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
            for (var i:int = a.first; i < a.end; i++)
            {
                if (isNear(i) && touches(i))
                {
                    time = 0;
                    return true;
                }
            }
            return false;
        }

        /** Whether the extents of a triangle overlap the structure's extents. */
        protected final function isNear(triangle:int):Boolean
        {
            var of:Vector.<Number> = solid.extents;
            var at:int = 6 * triangle;
            return of[at] <= extents[1] && of[int(at + 3)] >= extents[0] && of[int(at + 1)] <= extents[3] && of[int(at + 4)] >= extents[2]
                && of[int(at + 2)] <= extents[5] && of[int(at + 5)] >= extents[4];
        }

        /** Whether a triangle touches the standing structure. */
        protected final function touches(triangle:int):Boolean
        {
            return _isBox ? _box.touches(solid.corners, 9 * triangle) : _closest.areWithin(solid.corners, 9 * triangle, _core, 0);
        }

        /** The gap across which a box touches. */
        protected final function set tolerance(value:Number):void
        {
            _box.tolerance = value;
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
