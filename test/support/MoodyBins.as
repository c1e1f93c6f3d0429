package support
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Contact;

    /** A game's own bins, which count the contacts that they compute, and may refuse to. */
    public class MoodyBins extends BinCollider
    {
        /** Whether contactOf throws. */
        public var refuses:Boolean = false;

        /** The number of calls of contactOf. */
        public var contactCount:int = 0;

        /** @param greatLand the models */
        public function MoodyBins(greatLand:GreatLand)
        {
            super(greatLand);
        }

        override public function contactOf(collider:Agent, collidee:Agent, out:Contact = null):Contact
        {
            contactCount++;
            if (refuses)
            {
                throw new Error("no contact");
            }
            return super.contactOf(collider, collidee, out);
        }
    }
}
