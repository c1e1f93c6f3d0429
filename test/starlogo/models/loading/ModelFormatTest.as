package starlogo.models.loading
{
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.models.ObjModel;
    import starlogo.models.building.ModelBuilder;
    import starlogo.models.files.ModelFile;
    import support.Collada;
    import support.Gltf;

    public class ModelFormatTest
    {
        private static const OBJ:String = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
        private static const STL:String = "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid\n";

        [Test]
        public function theProgressOfEachFormatGoesFromZeroToOne():void
        {
            for each (var bytes:ByteArray in [binaryStl(), Gltf.tetrahedron().toBinary(), new GreatLand().cook(new ObjModel("a", OBJ))])
            {
                checkProgress(bytes, null);
            }
            var collada:String = Collada.document(Collada.geometry("a", "0 0 0 1 0 0 1 1 0", Collada.triangles("0 1 2")));
            for each (var text:String in [OBJ, STL, collada, Gltf.tetrahedron().toText()])
            {
                checkProgress(null, text);
            }
        }

        private static function checkProgress(bytes:ByteArray, text:String):void
        {
            var file:ModelFile = new ModelFile("a", bytes, text);
            var builder:ModelBuilder = ModelFormat.readerOf(file, "z", "footprint", null).building();
            var progress:Array = [builder.progress];
            var isLeft:Boolean = true;
            while (isLeft)
            {
                isLeft = builder.step();
                progress.push(builder.progress);
                assertTrue(builder + ": " + progress, progress[progress.length - 1] >= progress[progress.length - 2]);
            }
            assertEquals(String(builder), 0, progress[0]);
            assertEquals(String(builder), 1, builder.progress);
        }

        private static function binaryStl():ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.endian = Endian.LITTLE_ENDIAN;
            bytes.length = 134;
            bytes[80] = 1;
            bytes.position = 96;
            for each (var number:Number in [0, 0, 0, 1, 0, 0, 1, 1, 0])
            {
                bytes.writeFloat(number);
            }
            return bytes;
        }
    }
}
