package starlogo.search
{
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Sphere;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.collision.Collider;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.LevelChoice;
    import support.assertThrows;
    import support.create;
    import support.landOf;

    /** The structure that stands for a model has to be there, of a kind that is collided, and within the world. */
    public class BaseShapeChoiceTest
    {
        [Test]
        public function aColliderNeedsAChoice():void
        {
            assertThrows(ArgumentError, /choice must (not be|be a BaseShapeChoice, not) null/, create, Collider, null);
        }

        [Test]
        public function aStructureOutsideTheWorldIsRefused():void
        {
            for each (var far:Number in [2e9, 1e69])
            {
                for each (var structure:BoundingStructure in [new Sphere(new Vector3D(0, 0, far), 1), new Sphere(new Vector3D(), far)])
                {
                    var collider:Collider = new Collider(new OneStructure(structure));
                    assertThrows(RangeError, /its model's structure must be a finite number between/, collider.findCollisions, new <Agent>[new Agent("sphere"), new Agent("cube")]);
                }
            }
        }

        [Test]
        public function aStructureThatIsNotCollidedIsRefused():void
        {
            var cylinder:Cylinder = new Cylinder(new Vector3D(), new Vector3D(0, 0, 1), 0.5);
            for each (var structure:BoundingStructure in [cylinder, null])
            {
                assertRefused(new OneStructure(structure), /(a sphere, box, capsule or hull is needed|must be .*Hull), not/);
            }
            assertRefused(new OneStructure(null, false), /^agent \d+ .*: its model has no shape/);
        }

        [Test]
        public function aColliderOfShapesWithoutTestsIsRefused():void
        {
            assertThrows(ArgumentError, /a Collider needs a ShapeChoice, not/, colliderOf, new LevelChoice());
        }

        [Test]
        public function eachChoiceOfTheEngineBringsTheTestsOfItsShapes():void
        {
            var land:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube());
            for each (var choice:BaseShapeChoice in [new SphereChoice(land), new TightestFitChoice(land), new TreeChoice(land), new TreeChoice(land, new TightestFitChoice(land))])
            {
                assertTrue(colliderOf(choice).areColliding(new Agent("sphere"), new Agent("cube")));
            }
        }

        [Test]
        public function whatBindsAShapeMustNotNeedAnother():void
        {
            for each (var isOwn:Boolean in [false, true])
            {
                var choice:AskingChoice = new AskingChoice();
                var first:Agent = new Agent("first");
                choice.asks = isOwn ? first : new Agent("second");
                choice.collider = new Collider(choice);
                assertThrows(IllegalOperationError, /^bind\(\) must not ask about agent/, choice.collider.findCollisions,
                        new <Agent>[first, new Agent("third")]);
                choice.asks = null;
                assertEquals(2, choice.collider.findCollisions(new <Agent>[first, new Agent("third")]).length);
            }
        }

        private static function colliderOf(choice:BaseShapeChoice):Collider
        {
            return new Collider(choice);
        }

        private static function assertRefused(choice:BaseShapeChoice, message:RegExp):void
        {
            var collider:Collider = new Collider(choice);
            var sphere:Agent = new Agent("sphere");
            var cube:Agent = new Agent("cube");
            for (var i:int = 0; i < 2; i++)
            {
                assertThrows(ArgumentError, message, collider.findCollisions, new <Agent>[sphere, cube]);
                assertThrows(ArgumentError, message, collider.areColliding, sphere, cube);
            }
        }
    }
}

import flash.geom.Vector3D;
import starlogo.agents.Agent;
import starlogo.bounding.BoundingStructure;
import starlogo.bounding.Sphere;
import starlogo.collision.Collider;
import starlogo.search.ModelShape;
import starlogo.search.ShapeChoice;

/** The same structure for every model. */
internal class OneStructure extends ShapeChoice
{
    private var _structure:BoundingStructure;
    private var _isSet:Boolean;

    public function OneStructure(structure:BoundingStructure, isSet:Boolean = true)
    {
        super(null, false);
        _structure = structure;
        _isSet = isSet;
    }

    override public function bind(shape:ModelShape, agent:Agent):void
    {
        if (_isSet)
        {
            shape.setStructure(_structure);
        }
    }
}

/** A sphere for every model. While it binds one, it asks about an agent, if there is one. */
internal class AskingChoice extends ShapeChoice
{
    public var collider:Collider;
    public var asks:Agent;

    public function AskingChoice()
    {
        super(null, false);
    }

    override public function bind(shape:ModelShape, agent:Agent):void
    {
        if (asks != null)
        {
            collider.areColliding(asks, new Agent("fourth"));
        }
        shape.setStructure(new Sphere(new Vector3D(), 0.5));
    }
}
