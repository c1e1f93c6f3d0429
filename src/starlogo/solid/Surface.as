package starlogo.solid
{
    import flash.utils.ByteArray;

    /**
     * The properties of a model's surface as a whole: whether it is closed, and its parts. A SurfaceBuilder and a PartFinder compute them,
     * and a cooked file stores them.
     *
     * @private
     */
    public final class Surface
    {
        // The flags, the number of parts, and the widest seam.
        private static const HEAD_LENGTH:int = 16;
        private static const CLOSED:int = 1;
        private static const ORIENTED:int = 2;
        private static const TURNED:int = 4;

        /**
         * Whether the surface separates an inside from the outside. It does if along every edge as many triangles run in one direction as
         * in the other. If the triangles are not oriented consistently, an even number of them must meet at every edge. A surface may
         * consist of several closed pieces, which may overlap.
         */
        public var isClosed:Boolean = true;

        /**
         * Whether the surface is closed and its triangles are oriented consistently, after those in isTurned are reversed. If so, a point
         * is inside if the surface winds around it. If not, a point is inside if a ray from it crosses the surface an odd number of times.
         */
        public var isOriented:Boolean = true;

        /** For each triangle, whether it must be reversed to orient the surface. Null if none must. */
        public var isTurned:Vector.<Boolean> = null;

        /** Greater than any part's number. */
        public var partCount:int = 0;

        /**
         * For each triangle, the number of its part. At first, each connected piece is a part. The PartFinder joins pieces that touch
         * without sharing a vertex.
         */
        public var parts:Vector.<int>;

        /** The largest distance of two corners that were welded. */
        public var widestSeam:Number = 0;

        /**
         * @param triangleCount the number of triangles
         */
        public function Surface(triangleCount:int)
        {
            parts = new Vector.<int>(triangleCount, true);
        }

        /**
         * Reads a surface that <code>writeTo()</code> wrote.
         *
         * @param bytes read from its position on
         * @param triangleCount the model's number of triangles
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

        /**
         * Writes the surface: the flags, the number of parts and the widest seam; runs of triangles with the same part; a bit for each
         * triangle if some must be reversed.
         */
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
