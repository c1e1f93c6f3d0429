package support
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;

    /** What every fit has to pass. */
    public final class FitChecks
    {
        /** The vertices that a structure leaves out, by their numbers; "" if there are none. */
        public static function outside(structure:BoundingStructure, vertices:Vector.<Number>):String
        {
            var missed:Array = [];
            var point:Vector3D = new Vector3D();
            for (var i:int = 0; i < vertices.length; i += 3)
            {
                point.setTo(vertices[i], vertices[i + 1], vertices[i + 2]);
                if (!structure.contains(point))
                {
                    missed.push(i / 3);
                }
            }
            return missed.join();
        }
    }
}
