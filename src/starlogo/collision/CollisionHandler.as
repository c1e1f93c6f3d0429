package starlogo.collision
{
    /** What the agents of a breed do when they collide with those of another. */
    internal final class CollisionHandler
    {
        /** Called in every frame of a touch. */
        public static const COLLISION:int = 0;

        /** Called in the first. */
        public static const START:int = 1;

        /** Called in the first frame without it. */
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

        /** Whether it was taken away, while others ran perhaps: then it is not called any more. */
        public var isRemoved:Boolean = false;

        /** A handler of a pair of breeds. */
        public function CollisionHandler(kind:int, breed:String, otherBreed:String, handler:Function)
        {
            this.kind = kind;
            this.breed = breed;
            this.otherBreed = otherBreed;
            this.handler = handler;
            takesContact = handler.length == 3;
        }
    }
}
