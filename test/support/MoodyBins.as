package support
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Contact;

    /** A game's own bins, which may refuse to compute contacts. */
    public class MoodyBins extends BinCollider
    {
        /** Whether contactOf throws. */
        public var refuses:Boolean = false;

        /** @param greatLand the models */
        public function MoodyBins(greatLand:GreatLand)
        {
            super(greatLand);
        }

        override public function contactOf(collider:Agent, collidee:Agent, out:Contact = null):Contact
        {
            if (refuses)
            {
                throw new Error("no contact");
            }
            return super.contactOf(collider, collidee, out);
        }
    }
}
