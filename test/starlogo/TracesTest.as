package starlogo
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ModelEvent;
    import starlogo.queries.Footing;
    import starlogo.queries.RayHit;
    import starlogo.queries.ShapeHit;
    import starlogo.terrain.Terrain;
    import support.landOf;

    /** What trace() shows of things that a game gets. */
    public class TracesTest
    {
        [Test]
        public function modelsAndTheirEvents():void
        {
            assertEquals("model \"wall\" (24 vertices, 12 triangles)", String(BuiltInModel.box(2, 1, 3, "wall")));
            assertEquals("[ModelEvent type=\"modelLoaded\" model=model \"wall\" (24 vertices, 12 triangles)]",
                    String(new ModelEvent(ModelEvent.LOADED, BuiltInModel.box(2, 1, 3, "wall"))));
        }

        [Test]
        public function contactsAndFootings():void
        {
            var contact:Contact = new Contact();
            contact.depth = 0.5;
            assertEquals("contact at " + new Vector3D() + ", normal " + new Vector3D(0, 0, 1) + ", depth 0.5, time 1", String(contact));
            var footing:Footing = new Footing();
            assertEquals("footing in the air, part 1, pushed 0", String(footing));
            footing.stands = true;
            footing.on = new Agent("cube", "floors");
            footing.part = 0.25;
            assertEquals("footing on " + footing.on + ", normal " + new Vector3D(0, 0, 1) + ", part 0.25, pushed 0", String(footing));
        }

        [Test]
        public function hits():void
        {
            var wall:Agent = new Agent("cube", "walls");
            var zeros:String = " at " + new Vector3D() + ", normal " + new Vector3D();
            var ofRay:RayHit = new RayHit();
            ofRay.agent = wall;
            ofRay.distance = 2.5;
            assertEquals("ray hit of " + wall + zeros + ", distance 2.5", String(ofRay));
            var ofShape:ShapeHit = new ShapeHit();
            ofShape.agent = wall;
            ofShape.time = 0.25;
            assertEquals("hit of " + wall + zeros + ", time 0.25", String(ofShape));
        }

        [Test]
        public function terrainsAndCollisions():void
        {
            assertEquals("terrain of 101 by 11 heights, 2 apart, from (-50, -5)", String(new Terrain(101, 11, 2, -50, -5)));
            var collision:Collision = new Collision(new BinCollider(landOf(BuiltInModel.sphere())));
            collision.update(new <Agent>[new Agent("sphere"), new Agent("sphere")]);
            assertTrue(String(collision), /^Collision: 2 agents, 0 candidates, 0 collisions, 0 calls of handlers, \d+/.test(String(collision)));
        }
    }
}
