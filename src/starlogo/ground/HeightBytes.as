package starlogo.ground
{
    import flash.utils.ByteArray;
    import starlogo.geometry.isInWorld;

    /**
     * The surface of the ground in a snapshot. The bytes are: the number of columns; the number of rows; the width of a cell; its place; whether
     * the surface is blocks; then the heights; then the holes, a bit for each, as numbers of 32 bits. After a number of 0 comes the count of numbers
     * that are 0 from there on, and only the first of them is written.
     */
    internal final class HeightBytes
    {
        /** Writes the surface of a grid. */
        public static function write(bytes:ByteArray, grid:HeightGrid):void
        {
            bytes.writeInt(grid.columns);
            bytes.writeInt(grid.rows);
            bytes.writeDouble(grid.cellWidth);
            bytes.writeDouble(grid.x);
            bytes.writeDouble(grid.y);
            bytes.writeBoolean(grid.isBlocky);
            writeNumbers(bytes, grid.heights, bytes.writeDouble);
            var holes:Vector.<int> = grid.holes;
            var numbers:Vector.<Number> = new Vector.<Number>(holes.length, true);
            for (var i:int = 0; i < numbers.length; i++)
            {
                numbers[i] = holes[i];
            }
            writeNumbers(bytes, numbers, bytes.writeInt);
        }

        /** Reads a surface: see HeightGrid.readFrom. */
        public static function read(bytes:ByteArray, grid:HeightGrid):HeightGrid
        {
            var columns:int = bytes.readInt();
            var rows:int = bytes.readInt();
            var cellWidth:Number = bytes.readDouble();
            var x:Number = bytes.readDouble();
            var y:Number = bytes.readDouble();
            if (columns != grid.columns || rows != grid.rows || cellWidth != grid.cellWidth || x != grid.x || y != grid.y)
            {
                throw new ArgumentError("bytes are no snapshot with this ground, but with " + columns + " by " + rows + " heights from (" + x + ", " + y
                        + ") on, in cells " + cellWidth + " wide");
            }
            var flag:int = bytes.readUnsignedByte();
            var heights:Vector.<Number> = readNumbers(bytes, columns * rows, bytes.readDouble);
            var bits:Vector.<Number> = readNumbers(bytes, grid.holes.length, bytes.readInt);
            check(flag <= 1);
            for (var i:int = 0; i < heights.length; i++)
            {
                check(isInWorld(heights[i], 0, 0));
            }
            var found:HeightGrid = new HeightGrid(columns, rows, cellWidth, x, y);
            for (i = 0; i < bits.length; i++)
            {
                found.holes[i] = bits[i];
            }
            found.setSurface(flag == 1, heights, found.holes);
            return found;
        }

        // Writes each number by a method of the bytes.
        private static function writeNumbers(bytes:ByteArray, numbers:Vector.<Number>, write:Function):void
        {
            var count:int;
            for (var at:int = 0; at < numbers.length; at += count)
            {
                count = 1;
                write(numbers[at]);
                if (numbers[at] == 0)
                {
                    while (at + count < numbers.length && numbers[at + count] == 0)
                    {
                        count++;
                    }
                    bytes.writeInt(count);
                }
            }
        }

        private static function check(isSurface:Boolean):void
        {
            if (!isSurface)
            {
                throw new RangeError("bytes are no surface of a ground");
            }
        }

        // Reads each number by a method of the bytes. Fails if there are not so many numbers.
        private static function readNumbers(bytes:ByteArray, length:int, read:Function):Vector.<Number>
        {
            var numbers:Vector.<Number> = new Vector.<Number>(length, true);
            var count:uint;
            for (var at:uint = 0; at < length; at += count)
            {
                numbers[at] = read();
                count = numbers[at] == 0 ? bytes.readUnsignedInt() : 1;
                check(count > 0 && count <= length - at);
            }
            return numbers;
        }
    }
}
