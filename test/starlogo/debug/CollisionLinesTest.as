package starlogo.debug
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.collision.BinCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.queries.LevelCollider;
    import starlogo.queries.LevelShapes;
    import starlogo.terrain.Terrain;
    import support.EachCollider;
    import support.agentAt;
    import support.assertThrows;

    public class CollisionLinesTest
    {
        [Test]
        public function anAgentThatCollidesWithNothingHasNone():void
        {
            var land:GreatLand = new GreatLand();
            var lines:CollisionLines = new CollisionLines(land);
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                land.expect("late");
                assertEquals(name + ", loading", 0, lines.linesOf(agentAt("late", 1, 2, 3), EachCollider.make(name, land)).length);
                var cube:Model = BuiltInModel.cube();
                land.addModel(new Model("late", cube.vertices, cube.triangles));
                land.expectNoMore("late");
                assertTrue(name + ", loaded", lines.linesOf(agentAt("late", 1, 2, 3), EachCollider.make(name, land)).length > 0);
                land.removeModel("late");
                assertEquals(name + ", removed", 0, lines.linesOf(agentAt("late", 1, 2, 3), EachCollider.make(name, land)).length);
            }
        }

        [Test]
        public function aLevelColliderHasItsOwnShapes():void
        {
            var shapes:LevelShapes = new LevelShapes();
            shapes.addModel(BuiltInModel.cube());
            shapes.addStructure("ball", new Sphere(new Vector3D(), 0.5));
            var lines:CollisionLines = new CollisionLines(new GreatLand());
            var level:LevelCollider = new LevelCollider(shapes);
            var cube:Agent = agentAt("cube", 0, 0, 0);
            var ball:Agent = agentAt("ball", 0, 0, 0);
            assertEquals(0.5, lines.linesOf(ball, level)[0]);
            var boxes:int = lines.linesOf(cube, level).length;
            shapes.exact = true;
            var triangles:Vector.<Number> = lines.linesOf(cube, level);
            assertEquals(Wireframes.ofTriangles(BuiltInModel.cube().vertices, BuiltInModel.cube().triangles).length, triangles.length);
            assertTrue(boxes != triangles.length);
            shapes.addStructure("ball", new Sphere(new Vector3D(), 2));
            assertEquals("replaced", 2, lines.linesOf(ball, level)[0]);
            assertThrows(ArgumentError, /no model and no structure "bal"/, lines.linesOf, agentAt("bal", 0, 0, 0), level);
        }

        [Test]
        public function anAgentIsNeeded():void
        {
            assertThrows(ArgumentError, /agent must (not be|be an Agent, not) null$/, new CollisionLines(new GreatLand()).linesOf, null, new BinCollider());
        }

        [Test]
        public function aColliderWithoutModelsShowsSpheresOfAnyShape():void
        {
            assertTrue(new CollisionLines(new GreatLand()).linesOf(agentAt("no model", 0, 0, 0), new BinCollider()).length > 0);
            assertEquals("the ground", 0, new CollisionLines(new GreatLand()).linesOf(new Terrain(3, 3, 1, 0, 0).agent, new BinCollider()).length);
        }
    }
}
