package starlogo.solid.interior
{
    import starlogo.steps.StepSequence;

    /** Finds the components of a surface, in steps: sets of triangles that are connected over vertices. */
    internal final class ComponentFinder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        /**
         * @param surface receives the components
         * @param triangles three vertex indices each
         * @param welded for each vertex, the first one at its place
         */
        public function ComponentFinder(surface:SurfaceTopology, triangles:Vector.<uint>, welded:Vector.<int>)
        {
            // of vertices that are connected. And for the representative of a set, whether a triangle of its component is found
            var sets:DisjointSets = new DisjointSets(welded.length);
            var isFound:Vector.<Boolean> = new Vector.<Boolean>(welded.length, true);
            slices(triangles.length / 3, TRIANGLES_PER_STEP, function(first:int, end:int):void
                {
                    for (var corner:int = 3 * first; corner < 3 * end; corner += 3)
                    {
                        sets.join(welded[triangles[corner]], welded[triangles[int(corner + 1)]]);
                        sets.join(welded[triangles[corner]], welded[triangles[int(corner + 2)]]);
                    }
                }).slices(triangles.length / 3, TRIANGLES_PER_STEP, function(first:int, end:int):void
                {
                    for (var triangle:int = first; triangle < end; triangle++)
                    {
                        var root:int = sets.rootOf(welded[triangles[3 * triangle]]);
                        if (!isFound[root])
                        {
                            isFound[root] = true;
                            surface.componentTriangles.push(triangle);
                        }
                    }
                });
        }
    }
}
