package starlogo.models.scene
{
    import starlogo.steps.StepSequence;

    /**
     * A mesh of a scene, in its own space: points, and primitives with triangles. The reader of the format adds the steps that read it. All instances
     * share it.
     *
     * @private
     */
    public class SceneMesh extends StepSequence
    {
        /** x, y, z of each point. */
        public var points:Vector.<Number> = new Vector.<Number>();

        /** The number of triangles. Read only. */
        public var triangleCount:Number = 0;

        /** The material of each primitive, as the file calls it: see MeshInstance. Read only. */
        public var materials:Vector.<String> = new Vector.<String>();

        /** For each primitive, the function that adds its triangles: see addPrimitive(). Read only. */
        public var primitives:Vector.<Function> = new Vector.<Function>();

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

        /**
         * Adds a primitive.
         *
         * @param material its material, as the file calls it
         * @param count the number of its triangles
         * @param adding <code>function(firstVertex:int, triangles:Vector.&lt;uint&gt;):Steps</code>; returns the steps that add its triangles to those of a
         * model, where the first point of the mesh has that index
         */
        public function addPrimitive(material:String, count:int, adding:Function):void
        {
            triangleCount += count;
            materials.push(material);
            primitives.push(adding);
        }
    }
}
