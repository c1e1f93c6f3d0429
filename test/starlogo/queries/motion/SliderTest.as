package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.collision.TightestFitCollider;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.SeenAgents;
    import support.agentAt;
    import support.landOf;

    use namespace engine;

    /** What a motion says about itself, and nothing of an earlier one. */
    public class SliderTest
    {
        [Test]
        public function aSlideWithoutAMotionHasMetNoFloorAndNoWall():void
        {
            var seen:SeenAgents = new SeenAgents(new TightestFitCollider(landOf(BuiltInModel.cube())));
            var slider:Slider = new Slider();
            var agent:Agent = agentAt("cube", 0, 0, 1.5);
            seen.update(new <Agent>[agent, agentAt("cube", 0.2, 0, 0)]);
            var body:MovingBody = new MovingBody(seen);
            var from:Vector3D = new Vector3D(0, 0, 1.5);
            body.setToAgent(agent);
            new NearRows(seen).findWithin(body, 1, 0, 0, null);
            var result:MotionResult = slider.slide(body, body.rows, from, new Vector3D(0, 0, -1));
            assertTrue("it met the cube below: " + result.contact.normalZ, Math.abs(result.contact.normalZ - 1) < 1e-9);
            result = slider.slide(body, body.rows, from, new Vector3D());
            assertEquals(-1, result.row);
            assertEquals(-1, result.wallRow);
        }

        /** A fall goes on from the result of its last drop, and a walk keeps a slide's result while it goes straight down. */
        [Test]
        public function aMotionMayBeginAtThePlaceOfAResult():void
        {
            var seen:SeenAgents = new SeenAgents(new TightestFitCollider(landOf(BuiltInModel.cube())));
            var slider:Slider = new Slider();
            var agent:Agent = agentAt("cube", 0, 0, 3);
            seen.update(new <Agent>[agent, agentAt("cube", 0.2, 0, 0), agentAt("cube", 1.5, 0, 3)]);
            var body:MovingBody = new MovingBody(seen);
            body.setToAgent(agent);
            new NearRows(seen).findWithin(body, 4, 0, 0, null);
            var slid:Vector3D = slider.slide(body, body.rows, body.from, new Vector3D(-0.5, 0.1, 0)).place;
            var expected:Vector3D = slid.clone();
            var dropped:Vector3D = slider.moveVertically(body, slid, -1).place;
            assertTrue("the slide's result has changed: " + slid, slid.equals(expected));
            expected = new Slider().moveVertically(body, dropped, -5).place;
            var landed:Vector3D = slider.moveVertically(body, dropped, -5).place;
            assertTrue("it landed elsewhere: " + landed, landed.equals(expected) && landed.z > 1);
            expected = new Slider().slide(body, body.rows, slid, new Vector3D(0.2, 0, 0)).place;
            slid = slider.slide(body, body.rows, slid, new Vector3D(0.2, 0, 0)).place;
            assertTrue("it slid elsewhere: " + slid, slid.equals(expected));
        }

        /** A push out of what is very large may be long, but not where nothing large is near. */
        [Test]
        public function whatIsLargeAndFarAwayBringsNoRowsNearer():void
        {
            var seen:SeenAgents = new SeenAgents(new TightestFitCollider(landOf(BuiltInModel.cube())));
            var body:MovingBody = new MovingBody(seen);
            var agent:Agent = agentAt("cube", 0, 0, 0);
            var large:Agent = agentAt("cube", 0, 0, -2e6);
            large.size = 1e6;
            seen.update(new <Agent>[agent, large, agentAt("cube", 1.5, 0, 0), agentAt("cube", 2.5, 0, 0)]);
            body.setToAgent(agent);
            new NearRows(seen).findWithin(body, 1, 0, 0, null);
            assertEquals(1, body.rows.count);
            large.moveTo(0, 0, -1e6 - 0.5);
            seen.update(new <Agent>[agent, large, agentAt("cube", 1.5, 0, 0), agentAt("cube", 2.5, 0, 0)]);
            new NearRows(seen).findWithin(body, 1, 0, 0, null);
            assertEquals(3, body.rows.count);
        }

        [Test]
        public function aLevelSlideStaysLevelInADeepOverlap():void
        {
            var seen:SeenAgents = new SeenAgents(new TightestFitCollider(landOf(BuiltInModel.sphere())));
            var slider:Slider = new Slider();
            var agent:Agent = agentAt("sphere", 1.2, 0, 0);
            var rock:Agent = agentAt("sphere", 2, 0.1, -0.9);
            rock.size = 2;
            seen.update(new <Agent>[agent, rock]);
            var body:MovingBody = new MovingBody(seen);
            body.setToAgent(agent);
            new NearRows(seen).findWithin(body, 1, 0, 0, null);
            var motion:Vector3D = new Vector3D(0.5, 0, 0);
            var rises:Number = slider.slide(body, body.rows, body.from, motion).place.z;
            assertTrue("the rock leads it up by " + rises, Math.abs(rises) > 1e-9);
            var result:MotionResult = slider.slideLevel(body, body.from, motion);
            assertTrue("it rises by " + result.place.z, Math.abs(result.place.z) < 1e-9);
        }
    }
}
