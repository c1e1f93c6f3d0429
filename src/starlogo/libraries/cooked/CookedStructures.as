package starlogo.libraries.cooked
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.models.cooked.CookedFile;

    use namespace engine;

    /**
     * Writes the bounding structures of a model into a section of a cooked file, and reads them.
     *
     * @private
     */
    public final class CookedStructures
    {
        // A structure's numbers are at most this factor times the model's largest coordinate. Numbers up to 1 are always allowed.
        private static const LARGEST_FACTOR:Number = 10;

        /**
         * Writes structures: first a bit for each kind, whether there is a structure; then the numbers of the structures. A hull's numbers
         * come after their count.
         *
         * @param structures at most one of each kind, in the order of their kinds; null entries are left out
         */
        public static function write(structures:Vector.<BoundingStructure>):ByteArray
        {
            var out:ByteArray = CookedFile.newBytes();
            var kinds:int = 0;
            out.writeInt(0);
            for each (var structure:BoundingStructure in structures)
            {
                if (structure == null)
                {
                    continue;
                }
                kinds |= 1 << structure.kind;
                var numbers:Vector.<Number> = structure.numbers();
                if (structure.kind == BoundingStructure.HULL)
                {
                    out.writeInt(numbers.length);
                }
                for each (var number:Number in numbers)
                {
                    out.writeDouble(number);
                }
            }
            out.position = 0;
            out.writeInt(kinds);
            return out;
        }

        /**
         * Reads structures.
         *
         * @param bytes what <code>write()</code> has written; null for none
         * @param last the last kind that there may be
         * @param size the largest coordinate of the model
         * @return the structure of each kind, or null. Null if the bytes have none, one that cannot be, or one much larger than the model
         */
        public static function read(bytes:ByteArray, last:int, size:Number):Vector.<BoundingStructure>
        {
            var limit:Number = Math.max(1, LARGEST_FACTOR * size);
            var o:Vector3D = new Vector3D();
            var read:Vector.<BoundingStructure> = new <BoundingStructure>[new Sphere(o, 0), new Capsule(o, o, 0),
                    new Box(o, Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0), new Hull(new <Number>[0, 0, 0])];
            var kinds:int = bytes == null || bytes.length < 4 ? 0 : bytes.readInt();
            read.length = last + 1;
            for (var kind:int = 0; kind <= last; kind++)
            {
                if ((kinds >> kind & 1) == 0)
                {
                    read[kind] = null;
                }
                else if (!readNumbers(read[kind], bytes, limit))
                {
                    return null;
                }
            }
            return kinds > 0 && kinds >> read.length == 0 && bytes.bytesAvailable == 0 ? read : null;
        }

        // Returns whether the bytes have the numbers of such a structure.
        private static function readNumbers(structure:BoundingStructure, bytes:ByteArray, limit:Number):Boolean
        {
            var numbers:Vector.<Number> = new Vector.<Number>();
            var count:int = structure.kind == BoundingStructure.HULL ? (bytes.bytesAvailable < 4 ? 0 : bytes.readInt()) : structure.numbers().length;
            var areRight:Boolean = count > 0 && bytes.bytesAvailable / 8 >= count;
            for (var i:int = 0; i < count && areRight; i++)
            {
                numbers.push(bytes.readDouble());
                areRight = Math.abs(numbers[i]) <= limit;
            }
            if (!areRight)
            {
                return false;
            }
            try
            {
                // Numbers that make no structure are refused: by a hull's setNumbers(), by the constructors that clone() calls, or below, if a
                // box's constructor has made its axes perpendicular and unit vectors, and has changed more than their last bits.
                structure.setNumbers(numbers);
                var made:Vector.<Number> = structure.clone().numbers();
            }
            catch (error:Error)
            {
                return false;
            }
            for (i = 0; i < count && areRight; i++)
            {
                areRight = made.length == count && Math.abs(made[i] - numbers[i]) <= 100 * Tolerances.ROUNDING;
            }
            return areRight;
        }
    }
}
