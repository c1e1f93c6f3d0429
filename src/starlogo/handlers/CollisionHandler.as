package starlogo.handlers
{
    import starlogo.agents.Agent;

    /**
     * What the agents of a breed do when they collide with those of another.
     *
     * @private
     */
    public final class CollisionHandler
    {
        /** Called in the first frame of a contact. */
        public static const START:int = 0;

        /** Called in every frame of a contact, after those of its start. */
        public static const COLLISION:int = 1;

        /** Called in the first frame without the contact. */
        public static const END:int = 2;

        /** When it is called: one of the constants. */
        public var kind:int;

        /** The breed of the collider. */
        public var breed:String;

        /** The breed of the collidee. */
        public var otherBreed:String;

        /** function(collider:Agent, collidee:Agent):void, or with a third argument, the contact. */
        public var handler:Function;

        /** Whether it takes a contact. */
        public var takesContact:Boolean;

        /** Whether it may look at a third argument, though it does not say so: see mayTakeMore. */
        public var maySeeContact:Boolean;

        /** Whether it was removed, perhaps by another handler: then it is not called any more. */
        public var isRemoved:Boolean = false;

        /** A handler of a pair of breeds. */
        public function CollisionHandler(kind:int, breed:String, otherBreed:String, handler:Function)
        {
            this.kind = kind;
            this.breed = breed;
            this.otherBreed = otherBreed;
            this.handler = handler;
            takesContact = handler.length >= 3;
            maySeeContact = !takesContact && mayTakeMore(handler);
        }

        /**
         * Calls it, with the contact if it takes one.
         *
         * @param first the collider
         * @param second the collidee
         * @param isBack whether the two are the other way round
         * @param contact how they touch, or null
         */
        public function call(first:Agent, second:Agent, isBack:Boolean, contact:Object):void
        {
            // not as a method of this
            var toCall:Function = handler;
            var collider:Agent = isBack ? second : first;
            var collidee:Agent = isBack ? first : second;
            if (takesContact || contact != null)
            {
                toCall(collider, collidee, contact);
            }
            else
            {
                toCall(collider, collidee);
            }
        }
    }
}
