package starlogo.handlers
{
    /**
     * What the agents of a breed do when they collide with those of another.
     *
     * @private
     */
    public final class CollisionHandler
    {
        /** Called in the first frame of a touch. */
        public static const START:int = 0;

        /** Called in every frame of a touch; in its first frame, after the handlers for starts. */
        public static const COLLISION:int = 1;

        /** Called in the first frame in which the two do not touch any more. */
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

        /** Whether it takes a contact, or may look at one though it does not say so: see mayTakeMore. */
        public var mayTakeContact:Boolean;

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
            mayTakeContact = takesContact || mayTakeMore(handler);
        }
    }
}
