package support
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;

    /** Makes zip archives for tests. */
    public final class Zip
    {
        /**
         * An archive.
         *
         * @param files pairs of a path and a text, or a ByteArray that is already packed
         * @param isDeflated whether they are packed
         * @param claimedSize what an archive says of the size that packed bytes have unpacked
         */
        public static function of(files:Array, isDeflated:Boolean = true, claimedSize:uint = 0):ByteArray
        {
            var archive:ByteArray = littleEndian();
            var directory:ByteArray = littleEndian();
            for (var i:int = 0; i < files.length; i += 2)
            {
                add(archive, directory, files[i], files[i + 1], isDeflated, claimedSize);
            }
            var start:int = archive.length;
            archive.writeBytes(directory);
            archive.writeUnsignedInt(0x06054B50);
            archive.writeUnsignedInt(0);
            archive.writeShort(files.length / 2);
            archive.writeShort(files.length / 2);
            archive.writeUnsignedInt(directory.length);
            archive.writeUnsignedInt(start);
            archive.writeShort(0);
            return archive;
        }

        private static function add(archive:ByteArray, directory:ByteArray, path:String, file:Object, isDeflated:Boolean,
                claimedSize:uint):void
        {
            var content:ByteArray = file as ByteArray;
            var size:uint = claimedSize;
            if (content == null)
            {
                content = new ByteArray();
                content.writeUTFBytes(String(file));
                size = content.length;
                if (isDeflated)
                {
                    content.deflate();
                }
            }
            var header:ByteArray = littleEndian(); // what both headers have in common
            header.writeShort(20);
            header.writeShort(0);
            header.writeShort(isDeflated ? 8 : 0);
            header.writeUnsignedInt(0);
            header.writeUnsignedInt(0);
            header.writeUnsignedInt(content.length);
            header.writeUnsignedInt(size);
            header.writeShort(path.length);
            header.writeShort(0);

            directory.writeUnsignedInt(0x02014B50);
            directory.writeShort(20);
            directory.writeBytes(header);
            directory.writeShort(0);
            directory.writeShort(0);
            directory.writeShort(0);
            directory.writeUnsignedInt(0);
            directory.writeUnsignedInt(archive.length);
            directory.writeUTFBytes(path);

            archive.writeUnsignedInt(0x04034B50);
            archive.writeBytes(header);
            archive.writeUTFBytes(path);
            archive.writeBytes(content);
        }

        private static function littleEndian():ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.endian = Endian.LITTLE_ENDIAN;
            return bytes;
        }
    }
}
