package starlogo.collision
{
    import starlogo.agents.Agent;

    /**
     * A Contact that is computed when it is looked at. ActionScript's handlers say what they take, so that nothing is handed to others; the ES
     * module has its own of these.
     *
     * @private
     */
    internal final class ContactWhenAsked
    {
        /** Nothing is asked. */
        public function ContactWhenAsked()
        {
        }

        /** The contact of a pair, as FrameContacts.contactOf computes it; null for none. */
        public function of(source:FrameContacts, pair:int, first:Agent, second:Agent, isBack:Boolean):Contact
        {
            return null;
        }
    }
}
