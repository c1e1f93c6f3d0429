package growth
{
    import flash.utils.ByteArray;
    import soak.HostileFiles;
    import starlogo.GreatLand;
    import starlogo.models.ColladaModel;
    import starlogo.models.CookedModel;
    import starlogo.models.GltfModel;
    import starlogo.models.Model;
    import starlogo.models.ModelError;
    import starlogo.models.ObjModel;
    import starlogo.models.StlModel;

    /** Model files: they are read, and the default structures are computed of the models. The files are those of `./antw limits`. */
    public final class FileRows
    {
        private static const LEAST:int = 500;
        private static const MOST:int = 4000000;

        // These repeat something. At this size what every file may repeat is used up, and what it may repeat for each byte decides.
        private static const REPEATING:Array = ["COLLADA: a polygon with many holes", "COLLADA: many meshes of one source", "glTF: accessors of one view",
                "glTF: indices of one view", "glTF: skinned primitives of one accessor"];
        private static const USED_UP:int = 32000;

        /** A row for each hostile file, of n characters. */
        public static function get all():Array
        {
            var rows:Array = [];
            for each (var name:String in HostileFiles.names)
            {
                rows.push(rowOf(name));
            }
            return rows;
        }

        private static function rowOf(name:String):GrowthRow
        {
            var row:GrowthRow = new GrowthRow(name, "characters", LEAST, MOST, function(n:int, row:GrowthRow):Function
                {
                    var file:Object = HostileFiles.make(name, n);
                    row.bytes = HostileFiles.lengthOf(name, file);
                    return function():Object
                    {
                        return read(name.split(":")[0], file);
                    };
                });
            row = REPEATING.indexOf(name) < 0 ? row : row.from(USED_UP);
            return HostileFiles.isDeclared(name) ? row.staying() : row;
        }

        /** Reads a file as a game does. Returns the game's models, or the error. */
        private static function read(format:String, file:Object):Object
        {
            var greatLand:GreatLand = new GreatLand();
            try
            {
                greatLand.addModel(modelOf(format, file as ByteArray, file as String));
            }
            catch (error:ModelError)
            {
                return error;
            }
            return greatLand;
        }

        private static function modelOf(format:String, bytes:ByteArray, text:String):Model
        {
            switch (format)
            {
                case "glTF":
                    return GltfModel.fromBytes("a", bytes || bytesOf(text));
                case "STL":
                    return StlModel.fromBytes("a", bytes || bytesOf(text));
                case "cooked":
                    return CookedModel.fromBytes("a", bytes);
                case "OBJ":
                    return new ObjModel("a", text);
                case "UTF-16":
                    return ObjModel.fromBytes("a", bytes);
                default:
                    return bytes == null ? new ColladaModel("a", text) : ColladaModel.fromBytes("a", bytes);
            }
        }

        private static function bytesOf(text:String):ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.writeUTFBytes(text);
            return bytes;
        }
    }
}
