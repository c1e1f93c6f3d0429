package starlogo.collision
{
    import starlogo.engine;

    use namespace engine;

    /** The collision system of a Collision. Its collider belongs to this Collision until another system takes its place. */
    internal final class OwnedSystem
    {
        /** The system as the game has given it. */
        public var given:CollisionSystem = null;

        /** The same as a BaseCollider. */
        public var system:BaseCollider = null;

        private var _owner:Collision;

        // The system of the frame under way, or null. Its collider stays reserved until the frame's end.
        private var _updating:BaseCollider = null;

        /** @param owner the Collision */
        public function OwnedSystem(owner:Collision)
        {
            _owner = owner;
        }

        /**
         * Takes another system.
         *
         * @throws ArgumentError if its collider belongs to another Collision. Nothing has changed then
         */
        public function exchange(value:CollisionSystem):void
        {
            var next:BaseCollider = BaseCollider.wrap(value);
            if (next.innerCollider != null)
            {
                next.innerCollider.giveTo(_owner);
            }
            var before:BaseCollider = system;
            given = value;
            system = next;
            release(before);
        }

        /** Whether a frame is under way. */
        public function get isUpdating():Boolean
        {
            return _updating != null;
        }

        /** Begins a frame, and returns its system. The frame keeps it, whatever is given meanwhile. */
        public function beginFrame():BaseCollider
        {
            _updating = system;
            return system;
        }

        /** Ends the frame. */
        public function endFrame():void
        {
            var updated:BaseCollider = _updating;
            _updating = null;
            if (updated.innerCollider != null)
            {
                updated.innerCollider.endFrame();
            }
            release(updated);
        }

        // Lets another Collision have a system's collider, unless this one still needs it.
        private function release(before:BaseCollider):void
        {
            var collider:Collider = before == null ? null : before.innerCollider;
            if (collider != null && collider !== system.innerCollider && (_updating == null || collider !== _updating.innerCollider))
            {
                collider.giveTo(null);
            }
        }
    }
}
