package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collider;
    import support.assertThrows;

    /** The structure that stands for a model has to be within the world. */
    public class ModelShapesTest
    {
        [Test]
        public function aStructureOutsideTheWorldIsRefused():void
        {
            for each (var far:Number in [2e9, 1e69])
            {
                for each (var structure:BoundingStructure in [new Sphere(new Vector3D(0, 0, far), 1), new Sphere(new Vector3D(), far)])
                {
                    var collider:Collider = new Collider(new OneStructure(structure));
                    assertThrows(RangeError, /its model's structure must be between/, collider.findCollisions, new <Agent>[new Agent("sphere"), new Agent("cube")]);
                }
            }
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
