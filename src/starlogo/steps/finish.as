package starlogo.steps
{
    /** Does all remaining steps of some work. */
    public function finish(work:Steps):void
    {
        var hasMore:Boolean = true;
        while (hasMore)
        {
            hasMore = work.step();
        }
    }
}
