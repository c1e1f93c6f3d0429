package starlogo.collision
{
    import starlogo.agents.Agent;

    /**
     * Returns a Contact that FrameContacts.contactOf computes when the handler reads it. ActionScript's handlers declare their parameters, so
     * here it is null. The ES module has its own version.
     *
     * @private
     */
    public function contactWhenAsked(contacts:Object, pair:int, first:Agent, second:Agent, isBack:Boolean):Object
    {
        return null;
    }
}
