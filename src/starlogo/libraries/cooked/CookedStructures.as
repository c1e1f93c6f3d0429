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
    import starlogo.geometry.vertices.VertexBounds;
    import starlogo.models.cooked.CookedFile;

    use namespace engine;

    /**
     * Writes bounding structures into a section of a cooked file, and reads them. A section has a bit for each kind, whether there is a
     * structure, and then the numbers of the structures. A hull's numbers come after their count.
     *
     * @private
     */
    public final class CookedStructures
    {
        // A structure's numbers are at most this factor times the model's largest coordinate. Numbers up to 1 are always allowed.
        private static const LARGEST_FACTOR:Number = 10;

        /** Writes structures. @param structures at most one of each kind, in the order of their kinds; null entries are left out */
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
                var numbers:Vector.<Number> = structure.toNumbers();
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
            out.position = 0;
            return out;
        }

        /**
         * Reads what <code>write()</code> has written.
         *
         * @param bytes the section; null for none
         * @param lastKind the last kind that there may be
         * @param vertices the model's
         * @return a structure, or null, for each kind up to the last one. Null if there is no section, or if it has no structure, one that cannot
         * exist, or one much larger than the model
         */
        public static function read(bytes:ByteArray, lastKind:int, vertices:Vector.<Number>):Vector.<BoundingStructure>
        {
            if (bytes == null || bytes.length < 4)
            {
                return null;
            }
            var all:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(lastKind + 1);
            var limit:Number = Math.max(1, LARGEST_FACTOR * VertexBounds.of(vertices).largest);
            var kinds:int = bytes.readInt();
            for (var kind:int = 0; kind <= lastKind; kind++)
            {
                if ((kinds >> kind & 1) == 1)
                {
                    all[kind] = structureIn(bytes, kind, limit);
                    if (all[kind] == null)
                    {
                        return null;
                    }
                }
            }
            return kinds > 0 && kinds >> all.length == 0 && bytes.bytesAvailable == 0 ? all : null;
        }

        // Reads a structure. Null if the bytes do not have its numbers, or one is larger than a limit or NaN, or they make no structure.
        private static function structureIn(bytes:ByteArray, kind:int, limit:Number):BoundingStructure
        {
            var structure:BoundingStructure = emptyOf(kind);
            var numbers:Vector.<Number> = new Vector.<Number>();
            var count:int = kind == BoundingStructure.HULL ? (bytes.bytesAvailable < 4 ? 0 : bytes.readInt()) : structure.toNumbers().length;
            var areValid:Boolean = count > 0 && bytes.bytesAvailable / 8 >= count;
            for (var i:int = 0; i < count && areValid; i++)
            {
                numbers.push(bytes.readDouble());
                areValid = Math.abs(numbers[i]) <= limit;
            }
            return areValid && areNumbersOf(structure, numbers) ? structure : null;
        }

        // Sets a structure's numbers. Returns whether they make one. Constructors refuse some numbers: that of a hull, or those that clone() calls.
        // A box's constructor makes its axes perpendicular unit vectors. If it changes more than their last bits, the numbers are wrong.
        private static function areNumbersOf(structure:BoundingStructure, numbers:Vector.<Number>):Boolean
        {
            try
            {
                structure.setFromNumbers(numbers);
                var made:Vector.<Number> = structure.clone().toNumbers();
            }
            catch (error:Error)
            {
                return false;
            }
            var areValid:Boolean = made.length == numbers.length;
            for (var i:int = 0; i < numbers.length && areValid; i++)
            {
                areValid = Math.abs(made[i] - numbers[i]) <= 100 * Tolerances.ROUNDING;
            }
            return areValid;
        }

        // A structure of a kind that is a point.
        private static function emptyOf(kind:int):BoundingStructure
        {
            var o:Vector3D = new Vector3D();
            switch (kind)
            {
                case BoundingStructure.SPHERE:
                    return new Sphere(o, 0);
                case BoundingStructure.CAPSULE:
                    return new Capsule(o, o, 0);
                case BoundingStructure.BOX:
                    return new Box(o, Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
                default:
                    return new Hull(new <Number>[0, 0, 0]);
            }
        }
    }
}
