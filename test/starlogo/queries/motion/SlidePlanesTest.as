package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import starlogo.convex.ContactPoint;

    public class SlidePlanesTest
    {
        [Test]
        public function aPlaneThatIsMetAgainForgetsNoOther():void
        {
            var planes:SlidePlanes = new SlidePlanes();
            planes.begin(new Vector3D(1, 1, 0), new SlideLimits());
            assertEquals(0, planes.add(planeAgainst(1, 0), 5));
            assertEquals(1, planes.add(planeAgainst(0, 1), 6));
            assertEquals("the first again, of another row", 0, planes.add(planeAgainst(1, 0), 7));
            assertEquals("7,6 of 2", planes.rows.slice(0, 2).join() + " of " + planes.count);
            planes.project();
            assertEquals("no way between the two", 0, planes.length);
            planes.remove(1);
            planes.project();
            assertEquals("along the first", 1, planes.motion.y);
        }

        // The contact with a wall that stands across a direction on the ground plane.
        private static function planeAgainst(x:Number, y:Number):ContactPoint
        {
            var contact:ContactPoint = new ContactPoint();
            contact.normalX = -x;
            contact.normalY = -y;
            contact.normalZ = 0;
            return contact;
        }
    }
}
