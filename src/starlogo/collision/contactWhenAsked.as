package starlogo.collision
{
    import starlogo.agents.Agent;

    /**
     * A Contact that is computed when it is looked at, by FrameContacts.contactOf. ActionScript's handlers say what they take, so here it is null. The
     * ES module has its own answer.
     *
     * @private
     */
    public function contactWhenAsked(contacts:Object, pair:int, first:Agent, second:Agent, isBack:Boolean):Object
    {
        return null;
    }
}
