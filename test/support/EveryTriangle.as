package support
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.models.Model;

    use namespace engine;

    /** The triangles of a model where an agent has them. */
    public final class EveryTriangle
    {
        /** Writes the corners of all triangles of a model where it stands, nine numbers each. */
        public static function place(placement:Placement, model:Model, out:Vector.<Number>):void
        {
            out.length = 0;
            for (var i:int = 0; i < model.triangles.length; i++)
            {
                var at:int = 3 * model.triangles[i];
                var x:Number = placement.size * model.vertices[at];
                var y:Number = placement.size * model.vertices[at + 1];
                var z:Number = placement.size * model.vertices[at + 2];
                out.push(placement.r00 * x + placement.r01 * y + placement.r02 * z + placement.x,
                        placement.r10 * x + placement.r11 * y + placement.r12 * z + placement.y,
                        placement.r20 * x + placement.r21 * y + placement.r22 * z + placement.z);
            }
        }
    }
}
