package evaluation.pairs
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;

    /** Draws structures of any orientation; sizes and positions are multiples of the given ones. */
    public final class RandomStructures
    {
        private var _random:SeededRandom;

        /** Structures from the numbers that random gives. */
        public function RandomStructures(random:SeededRandom)
        {
            _random = random;
        }

        /** A structure of a kind: its extents 0.2 to 1 of size, its middle in a cube of half-edge spread. */
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
                default:
                    throw new ArgumentError("no such kind: " + kind);
            }
        }

        /** A sphere: its radius 0.2 to 1 of size, its centre in a cube of half-edge spread. */
        public function sphere(size:Number, spread:Number):Sphere
        {
            return new Sphere(position(spread), extent(size));
        }

        /** A capsule: half its segment 0.2 to 1 of size, its radius half of such a number, its middle in a cube of half-edge spread. */
        public function capsule(size:Number, spread:Number):Capsule
        {
            var middle:Vector3D = position(spread);
            var half:Vector3D = direction();
            half.scaleBy(extent(size));
            return new Capsule(middle.subtract(half), middle.add(half), extent(size) / 2);
        }

        /** A box: its half-extents 0.2 to 1 of size, its centre in a cube of half-edge spread. */
        public function box(size:Number, spread:Number):Box
        {
            var axes:Vector.<Vector3D> = frame();
            return new Box(position(spread), axes[0], axes[1], axes[2], extent(size), extent(size), extent(size));
        }

        /** A point evenly in a cube. */
        public function position(spread:Number):Vector3D
        {
            var x:Number = _random.between(-spread, spread);
            var y:Number = _random.between(-spread, spread);
            return new Vector3D(x, y, _random.between(-spread, spread));
        }

        /** A direction evenly on the unit sphere. */
        public function direction():Vector3D
        {
            var vector:Vector3D = new Vector3D(_random.normal(), _random.normal(), _random.normal());
            vector.normalize();
            return vector;
        }

        /** Three unit vectors at right angles, evenly among all orientations. */
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
