package starlogo.handlers
{
    import starlogo.agents.Breeds;
    import starlogo.engine;

    use namespace engine;

    /**
     * A handler function, with the two breeds and the phase for which the game has added it.
     *
     * @private
     */
    public final class CollisionHandler
    {
        /** When handlers are called: in the first frame of a touch. Each phase of a touch is a bit, so that phases can be added up. */
        public static const START:int = 1;

        /** When handlers are called: in every frame of a touch; in its first frame, after the handlers for starts. */
        public static const EVERY_FRAME:int = 2;

        /** When handlers are called: in the first frame after a touch. */
        public static const END:int = 4;

        // The names of the phases, as games give them: in the order of the bits.
        private static const PHASE_NAMES:Array = ["start", "collision", "end"];

        /** When it is called: START, EVERY_FRAME or END. */
        public var phase:int;

        /** The number of the collider's breed; Breeds.ANY_NUMBER for any breed. */
        public var colliderBreed:int;

        /** The number of the collidee's breed; Breeds.ANY_NUMBER for any breed. */
        public var collideeBreed:int;

        /** function(collider:Agent, collidee:Agent):void, or with a third argument, the contact. */
        public var callback:Function;

        /** Whether it takes a contact, or may read one: see mayTakeContact. */
        public var takesContact:Boolean;

        /** The revision of the HandlerTable at which it was added. */
        public var addedAt:int;

        /** Whether it was removed, perhaps by another handler. A removed handler is not called. */
        public var isRemoved:Boolean = false;

        public function CollisionHandler(breed:String, otherBreed:String, callback:Function, phase:int, addedAt:int)
        {
            this.phase = phase;
            this.callback = callback;
            this.addedAt = addedAt;
            colliderBreed = Breeds.NAMES.numberOf(breed);
            collideeBreed = Breeds.NAMES.numberOf(otherBreed);
            takesContact = mayTakeContact(callback);
        }

        /** The phase if the handler takes the contact of a touch; otherwise 0. A touch that has ended has none. */
        public function get contactPhase():int
        {
            return takesContact ? phase & ~END : 0;
        }

        /** The phase with a name; all phases for null. @throws ArgumentError if there is no such phase */
        public static function phasesNamed(name:String):int
        {
            var index:int = PHASE_NAMES.indexOf(name);
            if (name != null && index < 0)
            {
                throw new ArgumentError("kind must be \"collision\", \"start\", \"end\" or null, not \"" + name + "\"");
            }
            return name == null ? START | EVERY_FRAME | END : 1 << index;
        }
    }
}
