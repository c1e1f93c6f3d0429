package starlogo.steps
{
    /** Does all steps that are left of some work. */
    public function finish(work:Steps):void
    {
        var hasMore:Boolean = true;
        while (hasMore)
        {
            hasMore = work.step();
        }
    }
}
