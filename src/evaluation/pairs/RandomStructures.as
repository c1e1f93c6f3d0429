package evaluation.pairs
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;

    /** Draws structures of any orientation. Sizes and positions are multiples of the given ones. */
    public final class RandomStructures
    {
        private var _random:SeededRandom;

        /** Creates a source of structures. @param random gives the random numbers */
        public function RandomStructures(random:SeededRandom)
        {
            _random = random;
        }

        /** A structure of a kind. Its extents are 0.2 to 1 of size, and its middle is in a cube with half-edge spread. */
        public function ofKind(kind:int, size:Number, spread:Number):BoundingStructure
        {
            switch (kind)
            {
                case BoundingStructure.SPHERE:
                    return sphere(size, spread);
                case BoundingStructure.CAPSULE:
                    return capsule(size, spread);
                case BoundingStructure.BOX:
                    return box(size, spread);
                case BoundingStructure.HULL:
                    return hull(size, spread);
                default:
                    throw new ArgumentError("no such kind: " + kind);
            }
        }

        /** A sphere. Its radius is 0.2 to 1 of size, and its centre is in a cube with half-edge spread. */
        public function sphere(size:Number, spread:Number):Sphere
        {
            return new Sphere(position(spread), extent(size));
        }

        /**
         * A capsule. Half its segment is 0.2 to 1 of size, its radius is half of another such number, and its middle is in a cube with
         * half-edge spread.
         */
        public function capsule(size:Number, spread:Number):Capsule
        {
            var middle:Vector3D = position(spread);
            var half:Vector3D = direction();
            half.scaleBy(extent(size));
            return new Capsule(middle.subtract(half), middle.add(half), extent(size) / 2);
        }

        /** A box. Its half-extents are 0.2 to 1 of size, and its centre is in a cube with half-edge spread. */
        public function box(size:Number, spread:Number):Box
        {
            var axes:Vector.<Vector3D> = frame();
            return new Box(position(spread), axes[0], axes[1], axes[2], extent(size), extent(size), extent(size));
        }

        /** A hull of 8 to 16 points on an ellipsoid. Its half-axes are 0.2 to 1 of size, and its centre is in a cube with half-edge spread. */
        public function hull(size:Number, spread:Number):Hull
        {
            var middle:Vector3D = position(spread);
            var axes:Vector.<Vector3D> = frame();
            var points:Vector.<Number> = new Vector.<Number>();
            for each (var axis:Vector3D in axes)
            {
                axis.scaleBy(extent(size));
            }
            for (var i:int = _random.integer(8, 16); i > 0; i--)
            {
                var at:Vector3D = direction();
                points.push(middle.x + at.x * axes[0].x + at.y * axes[1].x + at.z * axes[2].x,
                        middle.y + at.x * axes[0].y + at.y * axes[1].y + at.z * axes[2].y,
                        middle.z + at.x * axes[0].z + at.y * axes[1].z + at.z * axes[2].z);
            }
            return new Hull(points);
        }

        /** A point, uniformly distributed in a cube. */
        public function position(spread:Number):Vector3D
        {
            var x:Number = _random.between(-spread, spread);
            var y:Number = _random.between(-spread, spread);
            return new Vector3D(x, y, _random.between(-spread, spread));
        }

        /** A direction, uniformly distributed on the unit sphere. */
        public function direction():Vector3D
        {
            var vector:Vector3D = new Vector3D(_random.normal(), _random.normal(), _random.normal());
            vector.normalize();
            return vector;
        }

        /** Three unit vectors at right angles, uniformly distributed among all orientations. */
        public function frame():Vector.<Vector3D>
        {
            var x:Vector3D = direction();
            var z:Vector3D = x.crossProduct(direction());
            z.normalize();
            return Vector.<Vector3D>([x, z.crossProduct(x), z]);
        }

        private function extent(size:Number):Number
        {
            return _random.between(0.2 * size, size);
        }
    }
}
