package starlogo.collision
{
    /** What the agents of a breed do when they collide with those of another. */
    internal final class CollisionHandler
    {
        /** The breed of the collider. */
        public var breed:String;

        /** The breed of the collidee. */
        public var otherBreed:String;

        /** function(collider:Agent, collidee:Agent):void */
        public var handler:Function;

        /** Whether it was taken away, while others ran perhaps: then it is not called any more. */
        public var isRemoved:Boolean = false;

        /** A handler of a pair of breeds. */
        public function CollisionHandler(breed:String, otherBreed:String, handler:Function)
        {
            this.breed = breed;
            this.otherBreed = otherBreed;
            this.handler = handler;
        }
    }
}
