package starlogo.models.building
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * The steps that remove the vertices that no triangle uses and close the gaps. If there are no triangles, all vertices stay.
     *
     * @param vertices x, y, z, ...; changed in place
     * @param triangles indices of vertices; changed to the new indices. Both lists need to be complete only when the first step is done
     *
     * @private
     */
    public function removingUnusedVertices(vertices:Vector.<Number>, triangles:Vector.<uint>):Steps
    {
        const VERTICES_PER_STEP:int = 4000;
        const CORNERS_PER_STEP:int = 20000;
        // by vertex: 1 if a triangle uses it, otherwise 0; then its new index
        var newIndices:Vector.<int>;
        var count:int = 0;
        var marking:Function = function():Steps
        {
            newIndices = new Vector.<int>(vertices.length / 3);
            return triangles.length == 0 ? null : new StepSequence().slices(triangles.length, CORNERS_PER_STEP, function(first:int, end:int):void
                {
                    for (var i:int = first; i < end; i++)
                    {
                        newIndices[triangles[i]] = 1;
                    }
                });
        };
        var closing:Function = function():Steps
        {
            // mostly all vertices are used
            return triangles.length == 0 || newIndices.indexOf(0) < 0 ? null : new StepSequence()
                .slices(newIndices.length, VERTICES_PER_STEP, function(first:int, end:int):void
                    {
                        for (var i:int = first; i < end; i++)
                        {
                            if (newIndices[i] != 0)
                            {
                                vertices[3 * count] = vertices[3 * i];
                                vertices[3 * count + 1] = vertices[3 * i + 1];
                                vertices[3 * count + 2] = vertices[3 * i + 2];
                                newIndices[i] = count++;
                            }
                        }
                    }).call(function():void
                    {
                        vertices.length = 3 * count;
                    }).slices(triangles.length, CORNERS_PER_STEP, function(first:int, end:int):void
                    {
                        for (var i:int = first; i < end; i++)
                        {
                            triangles[i] = newIndices[triangles[i]];
                        }
                    });
        };
        return new StepSequence().begin(marking).begin(closing);
    }
}
