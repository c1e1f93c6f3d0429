package starlogo.search
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;

    use namespace engine;

    /** What stands for a model stays, the same for all that have it, until that model is another. */
    public class ModelShapesTest
    {
        private var _land:GreatLand;
        private var _shapes:ModelShapes;
        private var _ball:Agent;
        private var _cube:Agent;

        [Before]
        public function makeShapes():void
        {
            _land = new GreatLand();
            _land.addModel(BuiltInModel.sphere());
            _land.addModel(BuiltInModel.cube());
            _shapes = new ModelShapes(new TightestFits(_land));
            _ball = new Agent("sphere");
            _cube = new Agent("cube");
            _shapes.forgetReplaced();
        }

        [Test]
        public function isOneForAllThatHaveTheModel():void
        {
            assertTrue(_shapes.shapeOf(_ball) === _shapes.shapeOf(new Agent("sphere", "others")));
            assertFalse("another model", _shapes.shapeOf(_ball) === _shapes.shapeOf(_cube));
            var tightest:ModelShape = _shapes.shapeOf(_cube);
            _cube.collideAs = Agent.SPHERE;
            assertFalse("another kind", _shapes.shapeOf(_cube) === tightest);
            _cube.collideAs = Agent.TIGHTEST;
            assertTrue("and back", _shapes.shapeOf(_cube) === tightest);
        }

        [Test]
        public function staysWhileNothingIsReplaced():void
        {
            var ball:ModelShape = _shapes.shapeOf(_ball);
            assertFalse(_shapes.forgetReplaced());
            var cube:Model = BuiltInModel.cube();
            _land.addModel(new Model("new", cube.vertices, cube.triangles));
            assertFalse("a new one", _shapes.forgetReplaced());
            assertTrue(_shapes.shapeOf(_ball) === ball);
            assertFalse(ball.isVoid);
        }

        [Test]
        public function thoseOfOtherModelsStay():void
        {
            var ball:ModelShape = _shapes.shapeOf(_ball);
            var cube:ModelShape = _shapes.shapeOf(_cube);
            _cube.collideAs = Agent.SPHERE;
            var around:ModelShape = _shapes.shapeOf(_cube);
            _land.addModel(BuiltInModel.cube());
            assertTrue(_shapes.forgetReplaced());
            assertFalse("once", _shapes.forgetReplaced());
            assertEquals("of the cube both kinds", "false,true,true", [ball.isVoid, cube.isVoid, around.isVoid].join());
            assertTrue("the ball's stays", _shapes.shapeOf(_ball) === ball);
            assertFalse("the cube's is another", _shapes.shapeOf(_cube) === around);
            _cube.collideAs = Agent.TIGHTEST;
            assertFalse("of both kinds", _shapes.shapeOf(_cube) === cube);
        }

        [Test]
        public function whatWasRemovedIsVoid():void
        {
            var ball:ModelShape = _shapes.shapeOf(_ball);
            var cube:ModelShape = _shapes.shapeOf(_cube);
            _land.removeModel("sphere");
            assertTrue(_shapes.forgetReplaced());
            assertEquals("true,false", [ball.isVoid, cube.isVoid].join());
        }
    }
}
