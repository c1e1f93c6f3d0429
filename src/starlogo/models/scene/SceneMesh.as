package starlogo.models.scene
{
    import starlogo.models.building.TriangleLabels;
    import starlogo.steps.StepSequence;

    /**
     * A mesh of a scene, in its own space: points, and primitives with triangles. The format adds the steps that read it. All instances share it.
     *
     * @private
     */
    public class SceneMesh extends StepSequence
    {
        /** x, y, z of each point. */
        public var points:Vector.<Number> = new Vector.<Number>();

        /** The triangles of all primitives: three points each, by their indices. */
        public var corners:Vector.<uint> = new Vector.<uint>();

        /** The material of each primitive, as the file calls it: see labelOf(). */
        public var materials:Vector.<String> = new Vector.<String>();

        /** The first triangle of each primitive. */
        public var firstTriangles:Vector.<int> = new Vector.<int>();

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

        /** Begins a primitive, whose triangles are added next. @param material its material, as the file calls it */
        public function beginPrimitive(material:String):void
        {
            materials.push(material);
            firstTriangles.push(corners.length / 3);
        }

        /**
         * The label of a primitive's material in an instance of the mesh; -1 for none. A format with materials overrides it.
         *
         * @param material as the file calls it
         * @param instance the instance's place in the file
         * @param labels the model's materials, which may get one more
         */
        public function labelOf(material:String, instance:Object, labels:TriangleLabels):int
        {
            return -1;
        }
    }
}
