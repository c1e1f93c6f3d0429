package starlogo.search
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collider;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.assertThrows;
    import support.landOf;

    use namespace engine;

    /** What stands for a model stays, the same for all that have it, until that model is another. */
    public class ModelShapesTest
    {
        private var _land:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube());
        private var _shapes:ModelShapes = new ModelShapes(new TightestFits(_land));
        private var _ball:Agent = new Agent("sphere");
        private var _cube:Agent = new Agent("cube");

        [Before]
        public function makeShapes():void
        {
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
        public function isFoundAmongManyModels():void
        {
            var shapes:Vector.<ModelShape> = new Vector.<ModelShape>();
            var agents:Vector.<Agent> = new Vector.<Agent>();
            var cube:Model = BuiltInModel.cube();
            for (var i:int = 0; i < 40; i++)
            {
                var name:String = i == 0 ? "hasOwnProperty" : i == 1 ? "__proto__" : "m" + i;
                _land.addModel(new Model(name, cube.vertices, cube.triangles));
                agents.push(new Agent(name));
                agents[i].collideAs = i % 3 == 0 ? Agent.SPHERE : Agent.TIGHTEST;
                shapes.push(_shapes.shapeOf(agents[i]));
            }
            for (var k:int = 0; k < 400; k++)
            {
                i = k * k * 7 % 40;
                assertTrue(_shapes.shapeOf(agents[i]) === shapes[i]);
            }
            _land.removeModel("m7");
            assertTrue(_shapes.forgetReplaced());
            for (i = 0; i < 40; i++)
            {
                assertTrue(i == 7 || _shapes.shapeOf(agents[i]) === shapes[i]);
            }
            assertThrows(ArgumentError, /there is no model "m7"/, _shapes.shapeOf, agents[7]);
        }

        [Test]
        public function aStructureOutsideTheWorldIsRefused():void
        {
            for each (var far:Number in [2e9, 1e69])
            {
                for each (var structure:BoundingStructure in [new Sphere(new Vector3D(0, 0, far), 1), new Sphere(new Vector3D(), far)])
                {
                    var collider:Collider = new Collider(new OneStructure(structure));
                    assertThrows(RangeError, /its model's structure must be between/, collider.findCollisions, new <Agent>[_ball, _cube]);
                }
            }
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

import starlogo.agents.Agent;
import starlogo.bounding.BoundingStructure;
import starlogo.search.ModelShape;
import starlogo.search.ShapeChoice;

/** The same structure for every model. */
internal class OneStructure extends ShapeChoice
{
    private var _structure:BoundingStructure;

    public function OneStructure(structure:BoundingStructure)
    {
        super(null, false);
        _structure = structure;
    }

    override public function bind(shape:ModelShape, agent:Agent):void
    {
        shape.setStructure(_structure);
    }
}
