package support
{
    import starlogo.agents.Agent;

    /** A handler that does nothing. */
    public function ignore(collider:Agent, collidee:Agent):void
    {
    }
}
