package starlogo.libraries.cooked
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertNotNull;
    import org.flexunit.asserts.assertNull;
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.solid.SolidHierarchy;
    import support.ChainOfNodes;

    use namespace engine;

    /** Trees that are read from bytes. */
    public class TreeReaderTest
    {
        private static const BELOW:int = ChainOfNodes.BELOW;

        [Test]
        public function aChainBelowTheLeavesIsRefused():void
        {
            assertNull(ChainOfNodes.read(100000, 10, BELOW, true).root);
        }

        [Test]
        public function aChainThatEndsEarlyIsRead():void
        {
            // 60 levels of one item each, then what is left
            var hierarchy:SolidHierarchy = ChainOfNodes.read(60, 10, BELOW, true);
            assertNotNull(hierarchy.root);
            assertEquals(60, levelsOf(hierarchy));
            assertNull("too many by one", ChainOfNodes.read(67, 10, BELOW, true).root);
        }

        [Test]
        public function theThesissLevelsHaveTheLimitOfTheLibrary():void
        {
            assertEquals(2000, levelsOf(ChainOfNodes.read(2000, 2000, 0, true)));
            assertNull(ChainOfNodes.read(2000, 1999, 0, true).root);
        }

        private static function levelsOf(hierarchy:SolidHierarchy):int
        {
            var node:HierarchyNode = hierarchy.root;
            while (node.high != null)
            {
                node = node.high;
            }
            return node.level;
        }
    }
}
