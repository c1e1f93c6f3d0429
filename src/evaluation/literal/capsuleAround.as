package evaluation.literal
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;

    /** The capsule around a box along its longest axis, for a preliminary test (thesis §7.5). A capsule is its own. */
    public function capsuleAround(structure:BoundingStructure):Capsule
    {
        return structure is Capsule ? structure as Capsule : grownCapsule(verticesOf(structure as Box), structure as Box);
    }
}

import evaluation.literal.cornersOf;
import flash.geom.Vector3D;
import starlogo.bounding.Box;

function verticesOf(box:Box):Vector.<Number>
{
    var vertices:Vector.<Number> = new Vector.<Number>();
    for each (var corner:Vector3D in cornersOf(box))
    {
        vertices.push(corner.x, corner.y, corner.z);
    }
    return vertices;
}
