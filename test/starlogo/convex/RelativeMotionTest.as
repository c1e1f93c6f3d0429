package starlogo.convex
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Box;
    import starlogo.collision.Collider;
    import starlogo.collision.Collision;
    import starlogo.intersection.intersects;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.EachCollider;
    import support.agentAt;
    import support.landOf;

    public class RelativeMotionTest
    {
        [Test]
        public function noTestChangesTheMotionOfWhatStands():void
        {
            var land:GreatLand = landOf(BuiltInModel.cube());
            var tilted:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 1, 1);
            var other:Box = new Box(new Vector3D(1.5, 0, 0), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 1, 1);
            var turn:Matrix3D = new Matrix3D();
            turn.appendRotation(1e-9, new Vector3D(1, 1, 1));
            tilted.rotate(turn);
            assertTrue(intersects(tilted, other));
            other.translate(new Vector3D(9, 0, 0));
            assertTrue(!intersects(tilted, other));
            for each (var name:String in EachCollider.NAMES)
            {
                var collider:Collider = EachCollider.make(name, land);
                var collision:Collision = new Collision(collider);
                collision.terrain = new Terrain(11, 11, 1, -5, -5);
                collision.bounds = new WorldBounds(-3, -3, -3, 3, 3, 3);
                var calls:int = 0;
                var note:Function = function(a:Agent, b:Agent, contact:Object):void
                {
                    calls++;
                };
                collision.onCollision("turtles", Collision.TERRAIN, note);
                collision.onCollision("turtles", Collision.EDGE, note);
                collision.onCollision("turtles", "turtles", note);
                collision.update(new <Agent>[agentAt("cube", 0, 0, -0.1), agentAt("cube", 0.6, 0.3, 0), agentAt("cube", 2.8, 0, 1)]);
                assertTrue(name + ": " + calls, calls >= 4);
                var none:RelativeMotion = RelativeMotion.NONE;
                assertEquals(name, "0,0,0,0,0,0,0,0,1", [none.x, none.y, none.z, none.startX, none.startY, none.startZ, none.time, none.earliestTime, none.latestTime].join());
            }
        }
    }
}
