package starlogo.solid
{
    import flash.utils.ByteArray;

    /**
     * What a model's triangles are as a whole: whether they close, and how many parts they come in. A SurfaceBuilder and a PartFinder find it out;
     * a cooked file has it written down.
     *
     * @private
     */
    public final class Surface
    {
        // Flags, how many parts there are, and the widest seam.
        private static const HEAD_LENGTH:int = 16;
        private static const CLOSED:int = 1;
        private static const ORIENTED:int = 2;
        private static const TURNED:int = 4;

        /**
         * Whether the surface separates an inside from the outside: along every edge as many triangles run in one
         * direction as in the other, or, where they are not turned consistently, an even number of them meet. A surface
         * may close in several pieces, which may run into each other.
         */
        public var isClosed:Boolean = true;

        /**
         * Whether it closes with its triangles turned consistently, once those that isTurned says are turned round. Then a
         * point is inside where the surface winds around it; otherwise where a ray from it crosses the surface an odd number
         * of times.
         */
        public var isOriented:Boolean = true;

        /** For each triangle, whether it must be turned round for the surface to be oriented; null if none must. */
        public var isTurned:Vector.<Boolean> = null;

        /** The numbers of the parts are less than this. */
        public var partCount:int = 0;

        /**
         * For each triangle, the part that it is of. At first a part is a connected piece: pieces that touch but share no vertex are several. The
         * PartFinder joins them.
         */
        public var parts:Vector.<int>;

        /** The largest distance of two corners that were taken for one. */
        public var widestSeam:Number = 0;

        /**
         * @param triangleCount how many triangles it has
         */
        public function Surface(triangleCount:int)
        {
            parts = new Vector.<int>(triangleCount, true);
        }

        /**
         * Reads what <code>writeTo()</code> wrote.
         *
         * @param bytes read from its position on
         * @param triangleCount how many triangles the model has
         * @return null if the bytes do not describe a surface of so many triangles
         */
        public static function read(bytes:ByteArray, triangleCount:int):Surface
        {
            if (bytes.bytesAvailable < HEAD_LENGTH)
            {
                return null;
            }
            var surface:Surface = new Surface(triangleCount);
            var flags:int = bytes.readInt();
            surface.isClosed = (flags & CLOSED) != 0;
            surface.isOriented = (flags & ORIENTED) != 0;
            surface.partCount = bytes.readInt();
            surface.widestSeam = bytes.readDouble();
            var isSound:Boolean = surface.partCount > 0 && surface.partCount <= triangleCount && surface.widestSeam >= 0 && surface.widestSeam < Infinity
                && surface.readParts(bytes) && ((flags & TURNED) == 0 || surface.readTurned(bytes));
            return isSound ? surface : null;
        }

        /** Writes it: flags, how many parts there are, the seam; runs of triangles of one part; a bit a triangle if some are turned. */
        public function writeTo(out:ByteArray):void
        {
            out.writeInt((isClosed ? CLOSED : 0) | (isOriented ? ORIENTED : 0) | (isTurned == null ? 0 : TURNED));
            out.writeInt(partCount);
            out.writeDouble(widestSeam);
            var first:int = 0;
            for (var i:int = 1; i <= parts.length; i++)
            {
                if (i == parts.length || parts[i] != parts[first])
                {
                    out.writeInt(parts[first]);
                    out.writeInt(i);
                    first = i;
                }
            }
            for (i = 0; isTurned != null && i < isTurned.length; i += 8)
            {
                var bits:int = 0;
                for (var bit:int = 0; bit < 8; bit++)
                {
                    bits |= i + bit < isTurned.length && isTurned[i + bit] ? 1 << bit : 0;
                }
                out.writeByte(bits);
            }
        }

        private function readParts(bytes:ByteArray):Boolean
        {
            var at:int = 0;
            while (at < parts.length && bytes.bytesAvailable >= 8)
            {
                var part:int = bytes.readInt();
                var end:int = bytes.readInt();
                if (part < 0 || part >= partCount || end <= at || end > parts.length)
                {
                    return false;
                }
                while (at < end)
                {
                    parts[at] = part;
                    at++;
                }
            }
            return at == parts.length;
        }

        private function readTurned(bytes:ByteArray):Boolean
        {
            if (bytes.bytesAvailable < Math.ceil(parts.length / 8))
            {
                return false;
            }
            isTurned = new Vector.<Boolean>(parts.length, true);
            var bits:int = 0;
            for (var i:int = 0; i < parts.length; i++)
            {
                if (i % 8 == 0)
                {
                    bits = bytes.readUnsignedByte();
                }
                isTurned[i] = (bits >>> i % 8 & 1) != 0;
            }
            return true;
        }
    }
}
