package starlogo.models.scene
{
    import starlogo.steps.StepSequence;

    /**
     * A mesh of a scene, in its own space: points, and the triangles of primitives. The reader of the format adds the steps that read it. All instances
     * share it.
     *
     * @private
     */
    public class SceneMesh extends StepSequence
    {
        /** x, y, z of each point. */
        public var points:Vector.<Number> = new Vector.<Number>();

        /** Three indices of points for each triangle, of one primitive after the other. */
        public var triangles:Vector.<uint> = new Vector.<uint>();

        /** The first triangle of each primitive. */
        public var firstTriangles:Vector.<int> = new Vector.<int>();

        /** The material of each primitive, as the file calls it: see MeshInstance. */
        public var materials:Vector.<String> = new Vector.<String>();

        /** Adds points. They are copied at once if they are the first, because that is quick. */
        public function addPoints(more:Vector.<Number>):void
        {
            if (points.length == 0)
            {
                points = more.slice();
                return;
            }
            for each (var number:Number in more)
            {
                points.push(number);
            }
        }

        /** Begins the next primitive. Triangles that come next are its triangles. */
        public function beginPrimitive(material:String):void
        {
            firstTriangles.push(triangles.length / 3);
            materials.push(material);
        }
    }
}
