package support
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ConvexShape;
    import starlogo.engine;

    use namespace engine;

    /** Draws convex shapes of all kinds, in families of difficulty. */
    public final class RandomConvex
    {
        /** Kinds: sphere, capsule, box, triangle, hull. */
        public static const KINDS:int = 5;

        /** Families: similar extents; extents of all scales; needles; without extents; on a lattice of integers, with axes along the coordinates. */
        public static const PLAIN:int = 0;
        public static const SCALES:int = 1;
        public static const NEEDLES:int = 2;
        public static const FLAT:int = 3;
        public static const LATTICE:int = 4;
        public static const FAMILIES:int = 5;

        private static const AXES:Vector.<Vector3D> = new <Vector3D>[Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS];

        private var _random:SeededRandom;
        private var _structures:RandomStructures;

        /** @param random gives the random numbers */
        public function RandomConvex(random:SeededRandom)
        {
            _random = random;
            _structures = new RandomStructures(random);
        }

        /** A shape of a kind and a family with its middle at a place. */
        public function shape(kind:int, family:int, at:Vector3D):ConvexShape
        {
            var shape:ConvexShape = new ConvexShape();
            var axes:Vector.<Vector3D> = family == LATTICE ? AXES : _structures.frame();
            var extents:Array = [extent(family), extent(family), extent(family)];
            switch (kind)
            {
                case 0:
                    new Sphere(at, extents[0]).setShape(shape);
                    break;
                case 1:
                    new Capsule(along(at, axes, [-extents[0], 0, 0]), along(at, axes, [extents[0], 0, 0]), extents[1]).setShape(shape);
                    break;
                case 2:
                    new Box(at, axes[0], axes[1], axes[2], extents[0], extents[1], extents[2]).setShape(shape);
                    break;
                case 3:
                    var corners:Vector.<Number> = new Vector.<Number>();
                    for (var i:int = 0; i < 3; i++)
                    {
                        var corner:Vector3D = along(at, axes, [part(family) * extents[0], part(family) * extents[1], 0]);
                        corners.push(corner.x, corner.y, corner.z);
                    }
                    shape.setTriangle(corners, 0);
                    break;
                default:
                    drawHull(shape, at, axes, extents, family);
            }
            return shape;
        }

        /** The same shape elsewhere. */
        public static function moved(shape:ConvexShape, x:Number, y:Number, z:Number):ConvexShape
        {
            var out:ConvexShape = new ConvexShape();
            out.origin.x = shape.origin.x + x;
            out.origin.y = shape.origin.y + y;
            out.origin.z = shape.origin.z + z;
            out.radius = shape.radius;
            out.margin = shape.margin;
            out.boundingRadius = shape.boundingRadius;
            out.points = shape.points;
            out.pointsEnd = shape.pointsEnd;
            out.faces = shape.faces;
            out.edges = shape.edges;
            out.coreKind = shape.coreKind;
            return out;
        }

        /** How far a shape extends along a direction, seen from the origin of the world. */
        public static function support(shape:ConvexShape, direction:Vector3D):Number
        {
            var most:Number = -Infinity;
            for (var i:int = 0; i < shape.pointsEnd; i += 3)
            {
                most = Math.max(most, direction.x * (shape.origin.x + shape.points[i]) + direction.y * (shape.origin.y + shape.points[i + 1]) + direction.z * (shape.origin.z + shape.points[i + 2]));
            }
            return most + shape.radius * direction.length;
        }

        /** How far a point is outside of a shape, along the normals of its faces and some other directions. */
        public function outside(shape:ConvexShape, point:Vector3D):Number
        {
            var most:Number = -Infinity;
            var p:Vector.<Number> = shape.points;
            for (var f:int = 0; f < shape.faces.length; f += 3)
            {
                var from:Vector3D = pointOf(p, shape.faces[f]);
                var normal:Vector3D = pointOf(p, shape.faces[f + 1]).subtract(from).crossProduct(pointOf(p, shape.faces[f + 2]).subtract(from));
                if (normal.normalize() > 1e-150)
                {
                    most = Math.max(most, beyond(shape, point, normal));
                    normal.negate();
                    most = Math.max(most, beyond(shape, point, normal));
                }
            }
            for (var i:int = 0; i < 12; i++)
            {
                most = Math.max(most, beyond(shape, point, _structures.direction()));
            }
            return most;
        }

        private static function beyond(shape:ConvexShape, point:Vector3D, direction:Vector3D):Number
        {
            // relative to the shape's origin, to be as precise far away
            var most:Number = -Infinity;
            for (var i:int = 0; i < shape.pointsEnd; i += 3)
            {
                most = Math.max(most, direction.x * shape.points[i] + direction.y * shape.points[i + 1] + direction.z * shape.points[i + 2]);
            }
            return direction.x * (point.x - shape.origin.x) + direction.y * (point.y - shape.origin.y) + direction.z * (point.z - shape.origin.z) - most - shape.radius;
        }

        private function drawHull(shape:ConvexShape, at:Vector3D, axes:Vector.<Vector3D>, extents:Array, family:int):void
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var i:int = _random.integer(5, 20); i > 0; i--)
            {
                var corner:Vector3D = along(new Vector3D(), axes, [part(family) * extents[0], part(family) * extents[1], part(family) * extents[2]]);
                points.push(corner.x, corner.y, corner.z);
            }
            setHull(shape, at, points);
        }

        private function extent(family:int):Number
        {
            switch (family)
            {
                case SCALES:
                    return _random.logBetween(1e-6, 1e6);
                case NEEDLES:
                    return _random.chance() ? _random.logBetween(1e-9, 1e-2) : _random.between(0.1, 1);
                case FLAT:
                    return _random.chance() ? 0 : _random.between(0.1, 1);
                case LATTICE:
                    return _random.integer(1, 3);
                default:
                    return _random.between(0.1, 1);
            }
        }

        // A part of an extent, from -1 to 1.
        private function part(family:int):Number
        {
            return family == LATTICE ? _random.integer(-1, 1) : _random.between(-1, 1);
        }

        private static function along(at:Vector3D, axes:Vector.<Vector3D>, by:Array):Vector3D
        {
            return new Vector3D(at.x + by[0] * axes[0].x + by[1] * axes[1].x + by[2] * axes[2].x, at.y + by[0] * axes[0].y + by[1] * axes[1].y + by[2] * axes[2].y,
                    at.z + by[0] * axes[0].z + by[1] * axes[1].z + by[2] * axes[2].z);
        }

        private static function pointOf(points:Vector.<Number>, at:int):Vector3D
        {
            return new Vector3D(points[at], points[at + 1], points[at + 2]);
        }
    }
}
