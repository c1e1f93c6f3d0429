package benchmark
{
    import evaluation.Table;
    import flash.utils.ByteArray;
    import headless.Host;
    import soak.LargeFiles;
    import starlogo.models.GltfModel;
    import starlogo.models.ObjModel;
    import starlogo.models.StlModel;

    /** What it takes to read a bumpy sphere of 200,000 triangles from each format, beside OBJ: the least of three times. */
    public class ReadingBenchmark
    {
        private static const TRIANGLES:int = 200000;
        private static const RUNS:int = 3;

        /** The table. */
        public function run():String
        {
            var obj:String = String(LargeFiles.make("OBJ " + TRIANGLES));
            var glb:ByteArray = ByteArray(LargeFiles.make("GLB " + TRIANGLES));
            var stl:ByteArray = ByteArray(LargeFiles.make("STL " + TRIANGLES));
            var readers:Object = {
                    OBJ: function():void
                    {
                        new ObjModel("a", obj);
                    },
                    GLB: function():void
                    {
                        GltfModel.fromBytes("a", glb);
                    },
                    STL: function():void
                    {
                        StlModel.fromBytes("a", stl);
                    }
                };
            var table:Table = new Table(TRIANGLES + " triangles", "ms", "of OBJ's");
            var ofObj:Number = 0;
            for each (var format:String in ["OBJ", "GLB", "STL"])
            {
                var least:Number = Infinity;
                for (var i:int = 0; i < RUNS; i++)
                {
                    var start:Number = Host.now;
                    readers[format]();
                    least = Math.min(least, Host.now - start);
                }
                ofObj ||= least;
                table.add(format, least.toFixed(0), (least / ofObj).toFixed(3));
            }
            return String(table);
        }
    }
}
