package starlogo.convex
{
    import org.flexunit.asserts.assertEquals;

    /** What is left of an edge or a face that is clipped to a face. Sides of the faces are in whole numbers. */
    public class ContactFeatureTest
    {
        // A square, counter-clockwise around z.
        private static const SQUARE:Array = [0, 0, 4, 0, 4, 4, 0, 4];

        [Test]
        public function whatTwoFacesShareIsLeft():void
        {
            assertEquals("2,1 2,3 4,1 4,3", clipped([2, 1, 6, 1, 6, 3, 2, 3], SQUARE));
            assertEquals("a triangle's tip", "3,2 4,1 4,3", clipped([3, 2, 7, -2, 7, 6], SQUARE));
            assertEquals("an edge", "0,1 4,1", clipped([-3, 1, 9, 1], SQUARE));
        }

        [Test]
        public function ofAFaceThatIsOutsideOfAnEdgeTheNearestPartIsLeft():void
        {
            assertEquals("a side", "6,1 6,3", clipped([6, 1, 9, 1, 9, 3, 6, 3], SQUARE));
            assertEquals("a corner", "6,2", clipped([6, 2, 9, 1, 9, 3], SQUARE));
            assertEquals("a side that is longer than the face", "6,0 6,4", clipped([6, -2, 9, -2, 9, 7, 6, 7], SQUARE));
            assertEquals("beyond a corner", "6,7", clipped([6, 7, 9, 7, 9, 9, 6, 9], SQUARE));
            assertEquals("of a triangle's side", "3,-2 5,-2", clipped([3, -4, 5, -4, 5, -2, 3, -2], [0, 0, 8, 0, 4, 6]));
        }

        // The corners that are left, in the order of their coordinates. Of those in one place up to rounding, one counts.
        private static function clipped(corners:Array, face:Array):String
        {
            var contact:ContactPoint = new ContactPoint();
            contact.setNormal(0, 0, 1);
            var feature:ContactFeature = featureOf(corners);
            feature.clip(featureOf(face), contact);
            var left:Array = [];
            for (var i:int = 0; i < feature.length; i += 3)
            {
                var corner:String = Math.round(1e9 * feature.points[i]) / 1e9 + "," + Math.round(1e9 * feature.points[i + 1]) / 1e9;
                if (left.indexOf(corner) < 0)
                {
                    left.push(corner);
                }
            }
            return left.sort().join(" ");
        }

        private static function featureOf(corners:Array):ContactFeature
        {
            var feature:ContactFeature = new ContactFeature();
            for (var i:int = 0; i < corners.length; i += 2)
            {
                feature.points.push(corners[i], corners[i + 1], 0);
            }
            feature.length = feature.points.length;
            return feature;
        }
    }
}
