package starlogo.solid
{
    import flash.utils.ByteArray;

    /**
     * What takes longest to find out of a surface, noted down: which of its triangles must be turned round, and which touch where
     * two of its pieces do.
     *
     * @private
     */
    public final class SurfaceNotes
    {
        private static const HEAD_LENGTH:int = 8;
        private static const JOIN_LENGTH:int = 8;

        /** For each triangle, whether it must be turned round; null if none must. */
        public var isTurned:Vector.<Boolean> = null;

        /** Two triangles that touch, by their indices in the hierarchy's order, for each time that two pieces turned out to be of one part. */
        public var joins:Vector.<int> = new Vector.<int>();

        /** Of a surface that needs none. */
        public function SurfaceNotes()
        {
        }

        /**
         * Reads what writeTo wrote.
         *
         * @param bytes read from its position on
         * @param triangleCount how many triangles there are
         * @return null if that is none of so many triangles
         */
        public static function read(bytes:ByteArray, triangleCount:int):SurfaceNotes
        {
            var notes:SurfaceNotes = new SurfaceNotes();
            if (bytes.bytesAvailable < HEAD_LENGTH)
            {
                return null;
            }
            var turnedLength:int = bytes.readInt();
            var joinCount:int = bytes.readInt();
            var isLong:Boolean = turnedLength != 0;
            if (isLong && turnedLength != lengthFor(triangleCount) || joinCount < 0 || joinCount >= triangleCount
                    || bytes.bytesAvailable < turnedLength + joinCount * JOIN_LENGTH)
            {
                return null;
            }
            if (isLong)
            {
                notes.readTurned(bytes, triangleCount);
            }
            for (var i:int = 0; i < 2 * joinCount; i++)
            {
                var triangle:int = bytes.readInt();
                if (triangle < 0 || triangle >= triangleCount)
                {
                    return null;
                }
                notes.joins.push(triangle);
            }
            return notes;
        }

        /** Writes it, in a multiple of four bytes. */
        public function writeTo(out:ByteArray):void
        {
            out.writeInt(isTurned == null ? 0 : lengthFor(isTurned.length));
            out.writeInt(joins.length / 2);
            for (var i:int = 0; isTurned != null && i < 8 * lengthFor(isTurned.length); i += 32)
            {
                var bits:int = 0;
                for (var bit:int = 0; bit < 32; bit++)
                {
                    bits |= i + bit < isTurned.length && isTurned[i + bit] ? 1 << bit : 0;
                }
                out.writeInt(bits);
            }
            for each (var triangle:int in joins)
            {
                out.writeInt(triangle);
            }
        }

        private function readTurned(bytes:ByteArray, triangleCount:int):void
        {
            isTurned = new Vector.<Boolean>(triangleCount, true);
            var bits:int = 0;
            for (var i:int = 0; i < triangleCount; i++)
            {
                if (i % 32 == 0)
                {
                    bits = bytes.readInt();
                }
                isTurned[i] = (bits >>> i % 32 & 1) != 0;
            }
        }

        private static function lengthFor(triangleCount:int):int
        {
            return 4 * Math.ceil(triangleCount / 32);
        }
    }
}
