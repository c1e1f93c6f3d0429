package starlogo.handlers
{
    import starlogo.agents.Breeds;
    import starlogo.engine;

    use namespace engine;

    /**
     * A handler function, with the two breeds and the moment for which the game has added it.
     *
     * @private
     */
    public final class CollisionHandler
    {
        /** When handlers are called: in the first frame of a touch. Each moment is a bit, so that moments can be added up. */
        public static const START:int = 1;

        /** When handlers are called: in every frame of a touch; in its first frame, after the handlers for starts. */
        public static const COLLISION:int = 2;

        /** When handlers are called: in the first frame after a touch. */
        public static const END:int = 4;

        // The names of the moments, as games give them: in the order of the bits.
        private static const MOMENT_NAMES:Array = ["start", "collision", "end"];

        /** When it is called: START, COLLISION or END. */
        public var moment:int;

        /** The number of the collider's breed; Breeds.ANY for any breed. */
        public var colliderBreed:int;

        /** The number of the collidee's breed; Breeds.ANY for any breed. */
        public var collideeBreed:int;

        /** function(collider:Agent, collidee:Agent):void, or with a third argument, the contact. */
        public var callback:Function;

        /** Whether it takes a contact, or may read one: see mayTakeContact. */
        public var takesContact:Boolean;

        /** When it was added, by the clock of the HandlerTable. */
        public var serial:int;

        /** Whether it was removed, perhaps by another handler. A removed handler is not called. */
        public var isRemoved:Boolean = false;

        public function CollisionHandler(breed:String, otherBreed:String, callback:Function, moment:int, serial:int)
        {
            this.moment = moment;
            this.callback = callback;
            this.serial = serial;
            colliderBreed = Breeds.NAMES.numberOf(breed);
            collideeBreed = Breeds.NAMES.numberOf(otherBreed);
            takesContact = mayTakeContact(callback);
        }

        /** The moment with a name; all moments for null. @throws ArgumentError if there is no such moment */
        public static function momentsNamed(name:String):int
        {
            var index:int = MOMENT_NAMES.indexOf(name);
            if (name != null && index < 0)
            {
                throw new ArgumentError("kind must be \"collision\", \"start\", \"end\" or null, not \"" + name + "\"");
            }
            return name == null ? START | COLLISION | END : 1 << index;
        }

        /** Whether its calls need a contact. At the end of a touch there is none. */
        public function get needsContact():Boolean
        {
            return takesContact && moment != END;
        }
    }
}
