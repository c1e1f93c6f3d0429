package support
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;

    /** How far a point is from a structure's surface, inside or outside. */
    public final class SurfaceDistance
    {
        /** The distance, in the unit of both. */
        public static function of(structure:BoundingStructure, point:Vector3D):Number
        {
            switch (structure.kind)
            {
                case BoundingStructure.SPHERE:
                    return Math.abs(Vector3D.distance(point, Sphere(structure).center) - Sphere(structure).radius);
                case BoundingStructure.BOX:
                    var box:Box = Box(structure);
                    var from:Vector3D = point.subtract(box.center);
                    return fromFaces(Math.abs(from.dotProduct(box.axisX)) - box.halfX, Math.abs(from.dotProduct(box.axisY)) - box.halfY,
                            Math.abs(from.dotProduct(box.axisZ)) - box.halfZ);
                case BoundingStructure.CAPSULE:
                    var capsule:Capsule = Capsule(structure);
                    return Math.abs(Vector3D.distance(point, nearestOfSegment(capsule.start, capsule.end, point)) - capsule.radius);
                case BoundingStructure.HULL:
                    return fromHull(Hull(structure), point);
                default:
                    return fromCylinder(Cylinder(structure), point);
            }
        }

        private static function nearestOfSegment(start:Vector3D, end:Vector3D, point:Vector3D):Vector3D
        {
            var axis:Vector3D = end.subtract(start);
            var along:Number = axis.lengthSquared == 0 ? 0 : point.subtract(start).dotProduct(axis) / axis.lengthSquared;
            axis.scaleBy(Math.max(0, Math.min(1, along)));
            return start.add(axis);
        }

        private static function fromHull(hull:Hull, point:Vector3D):Number
        {
            var here:Vector.<Number> = new <Number>[point.x, point.y, point.z, point.x, point.y, point.z, point.x, point.y, point.z];
            var least:Number = Infinity;
            for (var i:int = 0; i < hull.faces.length; i += 3)
            {
                var face:Vector.<Number> = new Vector.<Number>();
                for (var k:int = i; k < i + 3; k++)
                {
                    var at:int = 3 * hull.faces[k];
                    face.push(hull.corners[at], hull.corners[at + 1], hull.corners[at + 2]);
                }
                least = Math.min(least, PlainDistance.ofTriangles(here, 0, face, 0));
            }
            return least;
        }

        private static function fromCylinder(cylinder:Cylinder, point:Vector3D):Number
        {
            var axis:Vector3D = cylinder.end.subtract(cylinder.start);
            var half:Number = axis.length / 2;
            axis.normalize();
            var from:Vector3D = point.subtract(cylinder.start);
            var along:Number = from.dotProduct(axis);
            axis.scaleBy(along);
            return fromFaces(from.subtract(axis).length - cylinder.radius, Math.abs(along - half) - half, -Infinity);
        }

        // How far it is outside of each pair of faces, or inside if negative.
        private static function fromFaces(x:Number, y:Number, z:Number):Number
        {
            var outside:Number = new Vector3D(Math.max(0, x), Math.max(0, y), Math.max(0, z)).length;
            return outside > 0 ? outside : -Math.max(x, y, z);
        }
    }
}
