package starlogo.solid
{
    import flash.utils.ByteArray;

    /**
     * The properties of a model's surface as a whole: its parts, its pieces, and which of these are closed. A SurfaceBuilder, a
     * CavityFinder and a SolidBuilder compute them, and a cooked file stores them.
     *
     * @private
     */
    public final class SurfaceTopology
    {
        /** In pieceStates: the piece is closed, and a point is inside if the piece winds around it. */
        public static const SOLID:int = -1;

        /** In pieceStates: the piece is closed and has one side only. A point is inside if the piece winds around it an odd number of times. */
        public static const ONE_SIDED:int = -2;

        /** In pieceStates: the piece is not closed, and has no inside. */
        public static const OPEN:int = -3;

        // The number of parts, the number of pieces, and the widest seam.
        private static const HEAD_LENGTH:int = 16;

        /** Greater than any part's number. */
        public var partNumberEnd:int = 0;

        /**
         * For each triangle, the number of its part. At first, triangles that share vertices are one part. The SolidBuilder joins parts
         * that overlap.
         */
        public var parts:Vector.<int>;

        /**
         * For each triangle, one more than the number of its piece, or 0 for a triangle with two corners at one place. Pieces are connected over edges. The
         * number is negative for triangles that have to be reversed, so that all of the piece have the same orientation.
         */
        public var signedPieces:Vector.<int>;

        /**
         * For each piece, SOLID, ONE_SIDED or OPEN. For a piece that bounds a cavity in another one, it is the number of that one. A
         * point is inside of the surface if it is inside of a solid piece and not in a cavity of that piece. So pieces may overlap, whatever
         * their orientation.
         */
        public var pieceStates:Vector.<int> = new Vector.<int>();

        /** The largest distance of two corners that were welded. */
        public var widestSeam:Number = 0;

        /**
         * @param triangleCount the number of triangles
         */
        public function SurfaceTopology(triangleCount:int)
        {
            parts = new Vector.<int>(triangleCount, true);
            signedPieces = new Vector.<int>(triangleCount, true);
        }

        /** Whether a piece of the surface is closed, so that the surface has an inside. */
        public function get isClosed():Boolean
        {
            for each (var state:int in pieceStates)
            {
                if (state != OPEN)
                {
                    return true;
                }
            }
            return false;
        }

        /**
         * Reads a surface that <code>writeTo()</code> wrote.
         *
         * @param bytes read from its position on
         * @param triangleCount the model's number of triangles
         * @return null if the bytes do not describe a surface of so many triangles
         */
        public static function read(bytes:ByteArray, triangleCount:int):SurfaceTopology
        {
            if (bytes.bytesAvailable < HEAD_LENGTH)
            {
                return null;
            }
            var surface:SurfaceTopology = new SurfaceTopology(triangleCount);
            surface.partNumberEnd = bytes.readInt();
            var pieces:int = bytes.readInt();
            surface.widestSeam = bytes.readDouble();
            if (!(pieces >= 0 && pieces <= triangleCount && surface.partNumberEnd <= triangleCount
                        && surface.widestSeam >= 0 && surface.widestSeam < Infinity))
            {
                return null;
            }
            surface.pieceStates.length = pieces;
            return readRuns(bytes, surface.pieceStates, OPEN, pieces - 1) && readRuns(bytes, surface.parts, 0, surface.partNumberEnd - 1)
                && readRuns(bytes, surface.signedPieces, -pieces, pieces) ? surface : null;
        }

        /** Writes the surface: the numbers of parts and pieces, the widest seam, and runs of equal numbers of the lists. */
        public function writeTo(out:ByteArray):void
        {
            out.writeInt(partNumberEnd);
            out.writeInt(pieceStates.length);
            out.writeDouble(widestSeam);
            writeRuns(out, pieceStates);
            writeRuns(out, parts);
            writeRuns(out, signedPieces);
        }

        private static function writeRuns(out:ByteArray, numbers:Vector.<int>):void
        {
            var first:int = 0;
            for (var i:int = 1; i <= numbers.length; i++)
            {
                if (i == numbers.length || numbers[i] != numbers[first])
                {
                    out.writeInt(numbers[first]);
                    out.writeInt(i);
                    first = i;
                }
            }
        }

        private static function readRuns(bytes:ByteArray, numbers:Vector.<int>, least:int, most:int):Boolean
        {
            var at:int = 0;
            while (at < numbers.length && bytes.bytesAvailable >= 8)
            {
                var number:int = bytes.readInt();
                var end:int = bytes.readInt();
                if (number < least || number > most || end <= at || end > numbers.length)
                {
                    return false;
                }
                while (at < end)
                {
                    numbers[at++] = number;
                }
            }
            return at == numbers.length;
        }
    }
}
