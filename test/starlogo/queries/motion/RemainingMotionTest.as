package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import starlogo.convex.ContactPoint;

    public class RemainingMotionTest
    {
        [Test]
        public function aPlaneThatIsMetAgainForgetsNoOther():void
        {
            var rest:RemainingMotion = new RemainingMotion();
            var planes:ContactList = new ContactList();
            rest.begin(new Vector3D(1, 1, 0), Infinity, 0);
            assertEquals(0, planes.add(planeAgainst(1, 0), 5));
            assertEquals(1, planes.add(planeAgainst(0, 1), 6));
            assertEquals("the first again, of another row", 0, planes.add(planeAgainst(1, 0), 7));
            assertEquals("7,6 of 2", planes.rows.slice(0, 2).join() + " of " + planes.count);
            rest.project(planes);
            assertEquals("no way between the two", 0, rest.motion.length);
            planes.remove(1);
            rest.project(planes);
            assertEquals("along the first", 1, rest.motion.y);
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
