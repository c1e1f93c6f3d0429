package evaluation.literal
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;

    /**
     * A node of a hierarchy as the thesis builds it (§4.4): the axis-aligned box of some vertices. It is split halfway along its longest
     * axis. A node with at most five vertices, or on the tenth level, is a leaf.
     */
    public final class LiteralHierarchyNode
    {
        private static const MIN_VERTICES_TO_SPLIT:int = 5;
        private static const MAX_DEPTH:int = 10;

        /** The vertices' axis-aligned box. */
        public var box:Box;

        /** The half below the middle; null for a leaf. */
        public var left:LiteralHierarchyNode;

        /** The other half; null for a leaf. */
        public var right:LiteralHierarchyNode;

        // of each kind, when it was first needed
        private var _ofKind:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3);
        private var _points:Vector.<Vector3D>;

        /** The root around all vertices. @param vertices x, y, z each */
        public static function of(vertices:Vector.<Number>):LiteralHierarchyNode
        {
            var points:Vector.<Vector3D> = new Vector.<Vector3D>();
            for (var i:int = 0; i < vertices.length; i += 3)
            {
                points.push(new Vector3D(vertices[i], vertices[i + 1], vertices[i + 2]));
            }
            return new LiteralHierarchyNode(points, 1);
        }

        /** Creates a node and all nodes below it. The root has level 1. */
        public function LiteralHierarchyNode(points:Vector.<Vector3D>, level:int)
        {
            var min:Vector3D = points[0].clone();
            var max:Vector3D = points[0].clone();
            for each (var point:Vector3D in points)
            {
                min.x = Math.min(min.x, point.x);
                min.y = Math.min(min.y, point.y);
                min.z = Math.min(min.z, point.z);
                max.x = Math.max(max.x, point.x);
                max.y = Math.max(max.y, point.y);
                max.z = Math.max(max.z, point.z);
            }
            var center:Vector3D = min.add(max);
            center.scaleBy(0.5);
            var half:Vector3D = max.subtract(center);
            box = new Box(center, Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, half.x, half.y, half.z);
            _points = points;
            if (points.length > MIN_VERTICES_TO_SPLIT && level < MAX_DEPTH && half.lengthSquared > 0)
            {
                split(points, level);
            }
        }

        /** Whether it has no children. */
        public function get isLeaf():Boolean
        {
            return left == null;
        }

        /** The box, a sphere around the box's centre, or a capsule along the box's longest axis, as small as the vertices allow (§7.7). */
        public function ofKind(kind:int):BoundingStructure
        {
            if (kind == BoundingStructure.BOX)
            {
                return box;
            }
            if (_ofKind[kind] == null)
            {
                var vertices:Vector.<Number> = new Vector.<Number>();
                var radius:Number = 0;
                for each (var point:Vector3D in _points)
                {
                    vertices.push(point.x, point.y, point.z);
                    radius = Math.max(radius, point.subtract(box.center).length);
                }
                _ofKind[kind] = kind == BoundingStructure.SPHERE ? new Sphere(box.center, radius) : grownCapsule(vertices, box);
            }
            return _ofKind[kind];
        }

        private function split(points:Vector.<Vector3D>, level:int):void
        {
            var axis:String = box.halfX >= box.halfY && box.halfX >= box.halfZ ? "x" : box.halfY >= box.halfZ ? "y" : "z";
            var low:Vector.<Vector3D> = new Vector.<Vector3D>();
            var high:Vector.<Vector3D> = new Vector.<Vector3D>();
            for each (var point:Vector3D in points)
            {
                (point[axis] < box.center[axis] ? low : high).push(point);
            }
            if (low.length > 0 && high.length > 0)
            {
                left = new LiteralHierarchyNode(low, level + 1);
                right = new LiteralHierarchyNode(high, level + 1);
            }
        }
    }
}
