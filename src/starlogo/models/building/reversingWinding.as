package starlogo.models.building
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * The steps that reverse the winding of a mirror image's triangles, so that they still face outwards.
     *
     * @param triangles three indices of vertices each; complete
     * @param first the first triangle that is reversed; all after it are, too
     *
     * @private
     */
    public function reversingWinding(triangles:Vector.<uint>, first:int):Steps
    {
        const TRIANGLES_PER_STEP:int = 10000;
        return new StepSequence().slices(triangles.length / 3 - first, TRIANGLES_PER_STEP, function(from:int, end:int):void
            {
                for (var i:int = 3 * (first + from); i < 3 * (first + end); i += 3)
                {
                    var second:uint = triangles[i + 1];
                    triangles[i + 1] = triangles[i + 2];
                    triangles[i + 2] = second;
                }
            });
    }
}
