package starlogo.solid.interior
{
    import flash.utils.ByteArray;
    import starlogo.data.zeroedInts;

    /**
     * The properties of a model's surface as a whole: its components, its shells, and which of these are closed. An Interior's steps find
     * them, and a cooked file stores them.
     *
     * @private
     */
    public final class SurfaceTopology
    {
        /** In shellStates: the shell is closed and has two sides: it is orientable. A point is inside if the shell winds around it. */
        public static const ORIENTABLE:int = -1;

        /** In shellStates: the shell is closed and has one side only. A point is inside if the shell winds around it an odd number of times. */
        public static const NON_ORIENTABLE:int = -2;

        /** In shellStates: the shell is not closed, and has no inside; or it copies another one. */
        public static const OPEN:int = -3;

        // The number of components, the number of shells, and the widest seam.
        private static const HEAD_LENGTH:int = 16;

        /** For each component, the number of one of its triangles. Triangles that share vertices are in one component. */
        public var componentTriangles:Vector.<int> = new Vector.<int>();

        /**
         * For each triangle, in the model's order, one more than the number of its shell, or 0 for a triangle with two corners at one place. Shells are
         * connected over edges. The number is negative for triangles that have to be reversed, so that all of the shell have the same orientation.
         */
        public var orientedShells:Vector.<int>;

        /**
         * For each shell, ORIENTABLE, NON_ORIENTABLE or OPEN; for an orientable one that bounds a cavity, the number of the shell in which the cavity is.
         * A point is inside of the surface if it is inside of a closed shell that bounds no cavity, and not in a cavity of that shell. So shells may
         * overlap, whatever their orientation.
         */
        public var shellStates:Vector.<int> = new Vector.<int>();

        /** The largest distance of two corners that were welded. */
        public var widestSeam:Number = 0;

        /**
         * @param triangleCount the number of triangles
         */
        public function SurfaceTopology(triangleCount:int)
        {
            orientedShells = zeroedInts(triangleCount);
        }

        /** The shell of a triangle, by the triangle's number; -1 if two of its corners are at one place. */
        public function shellOf(triangle:int):int
        {
            return Math.abs(orientedShells[triangle]) - 1;
        }

        /** Whether a triangle, by its number, has to be reversed, so that all of its shell have the same orientation. */
        public function isReversed(triangle:int):Boolean
        {
            return orientedShells[triangle] < 0;
        }

        /** Whether a shell bounds a cavity in another one. */
        public function boundsCavity(shell:int):Boolean
        {
            return shellStates[shell] >= 0;
        }

        /** Whether at least one shell of the surface is closed, so that the surface has an inside. */
        public function get hasClosedShell():Boolean
        {
            for each (var state:int in shellStates)
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
            var components:int = bytes.readInt();
            var shells:int = bytes.readInt();
            surface.widestSeam = bytes.readDouble();
            if (!(shells >= 0 && shells <= triangleCount && components >= Math.min(1, triangleCount) && components <= triangleCount
                        && surface.widestSeam >= 0 && surface.widestSeam < Infinity))
            {
                return null;
            }
            surface.componentTriangles.length = components;
            surface.shellStates.length = shells;
            var isRead:Boolean = readRuns(bytes, surface.shellStates, OPEN, shells - 1) && readRuns(bytes, surface.componentTriangles, 0, triangleCount - 1)
                && readRuns(bytes, surface.orientedShells, -shells, shells);
            return isRead ? surface : null;
        }

        /**
         * Writes the surface: the numbers of components and shells, the widest seam, and runs of equal numbers of the lists.
         */
        public function writeTo(out:ByteArray):void
        {
            out.writeInt(componentTriangles.length);
            out.writeInt(shellStates.length);
            out.writeDouble(widestSeam);
            writeRuns(out, shellStates);
            writeRuns(out, componentTriangles);
            writeRuns(out, orientedShells);
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
