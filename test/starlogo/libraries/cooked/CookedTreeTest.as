package starlogo.libraries.cooked
{
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.VarInt;
    import starlogo.steps.finish;
    import support.ChainOfNodes;

    use namespace engine;

    /** Trees that are read from bytes. */
    public class CookedTreeTest
    {
        private static const BELOW:int = ChainOfNodes.BELOW;

        [Test]
        public function aChainBelowTheLeavesIsRefused():void
        {
            assertFalse(ChainOfNodes.read(100000, 10, BELOW, true).isMade);
        }

        [Test]
        public function aChainThatEndsEarlyIsRead():void
        {
            // 60 levels of one item each, then what is left
            var tree:BoxTree = ChainOfNodes.read(60, 10, BELOW, true);
            assertTrue(tree.isMade);
            assertEquals(60, levelsOf(tree));
            assertFalse("too many by one", ChainOfNodes.read(67, 10, BELOW, true).isMade);
        }

        [Test]
        public function theThesissLevelsHaveTheLimitOfTheLibrary():void
        {
            assertEquals(2000, levelsOf(ChainOfNodes.read(2000, 2000, 0, true)));
            assertFalse(ChainOfNodes.read(2000, 1999, 0, true).isMade);
        }

        [Test]
        public function stepsAfterARefusalDoNothing():void
        {
            var bytes:ByteArray = CookedFile.newBytes();
            // the item 1 is missing; then a root that is not divided
            bytes.writeByte(0);
            bytes.writeByte(0);
            VarInt.write(0, bytes);
            bytes.position = 0;
            var tree:BoxTree = new BoxTree(new <Number>[0, 0, 0, 1, 0, 0], null);
            var reader:CookedTree = new CookedTree(bytes, tree, 10);
            finish(reader);
            for (var i:int = 0; i < 10; i++)
            {
                assertFalse(reader.step());
            }
            assertFalse(tree.isMade);
        }

        [Test]
        public function aPartWithoutItemsIsRefused():void
        {
            for (var items:int = 0; items <= 3; items++)
            {
                var bytes:ByteArray = CookedFile.newBytes();
                bytes.writeByte(0);
                bytes.writeByte(1);
                // so many of the two items are in the first part, and no part is divided
                VarInt.write(1 + 6 * items, bytes);
                VarInt.write(0, bytes);
                VarInt.write(0, bytes);
                bytes.position = 0;
                var tree:BoxTree = new BoxTree(new <Number>[0, 0, 0, 1, 0, 0], null);
                finish(new CookedTree(bytes, tree, 10));
                assertEquals(items + " items", items == 1, tree.isMade);
            }
        }

        private static function levelsOf(tree:BoxTree):int
        {
            return tree.levelOf(tree.left.length - 1);
        }
    }
}
