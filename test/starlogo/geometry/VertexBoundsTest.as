package starlogo.geometry
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;

    public class VertexBoundsTest
    {
        private static const VERTICES:Vector.<Number> = new <Number>[1, 2, 3, -4, 5, 6, 7, -8, 9.5];

        [Test]
        public function isAroundAllThatWereAdded():void
        {
            var bounds:VertexBounds = new VertexBounds();
            bounds.add(VERTICES, 0, 1);
            assertEquals("1,2,3,1,2,3", sides(bounds));
            assertEquals(0, bounds.extent);
            bounds.add(VERTICES, 1, 3);
            assertEquals("-4,-8,3,7,5,9.5", sides(bounds));
            assertEquals(13, bounds.extent);
            assertTrue(bounds.areFinite);
        }

        [Test]
        public function saysWhetherAllAreNumbers():void
        {
            for each (var wrong:Number in [NaN, Infinity, -Infinity])
            {
                for (var i:int = 0; i < 3; i++)
                {
                    var vertices:Vector.<Number> = VERTICES.concat();
                    vertices[3 + i] = wrong;
                    var bounds:VertexBounds = new VertexBounds();
                    bounds.add(vertices, 0, 1);
                    assertTrue(bounds.areFinite);
                    bounds.add(vertices, 1, 2);
                    bounds.add(vertices, 2, 3);
                    assertFalse(wrong + " at " + i, bounds.areFinite);
                }
            }
        }

        private static function sides(bounds:VertexBounds):String
        {
            return [bounds.minX, bounds.minY, bounds.minZ, bounds.maxX, bounds.maxY, bounds.maxZ].join();
        }
    }
}
