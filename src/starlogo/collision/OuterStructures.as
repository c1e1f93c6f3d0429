package starlogo.collision
{
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Placement;

    /** A sphere and a capsule around an agent's structure, which are tried first (thesis §7.5). */
    internal final class OuterStructures
    {
        private static const WIDENED:Number = 1 + 1e-12;

        /** The sphere in the world. */
        public var worldSphere:Sphere;

        /** The capsule in the world. */
        public var worldCapsule:Capsule;

        private var _sphere:Sphere;
        private var _capsule:Capsule;

        /**
         * @param sphere around the model, in its space
         * @param capsule likewise
         */
        public function OuterStructures(sphere:Sphere, capsule:Capsule)
        {
            _sphere = sphere.clone() as Sphere;
            _capsule = capsule.clone() as Capsule;
            // they must not tell structures apart that touch
            _sphere.radius *= WIDENED;
            _capsule.radius *= WIDENED;
            worldSphere = sphere.clone() as Sphere;
            worldCapsule = capsule.clone() as Capsule;
        }

        /** Puts both into the world. */
        public function place(placement:Placement):void
        {
            _sphere.place(placement, worldSphere);
            _capsule.place(placement, worldCapsule);
        }
    }
}
