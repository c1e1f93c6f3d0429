package starlogo.search
{
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * A sphere and a capsule around a structure. A collider tests them first, because their tests are cheaper (thesis §7.5).
     *
     * @private
     */
    public final class OuterStructures
    {
        internal var sphere:Sphere;
        internal var capsule:Capsule;

        /** For a model: copies the two, and makes the copies slightly wider. */
        public function OuterStructures(sphere:Sphere, capsule:Capsule)
        {
            this.sphere = sphere.clone() as Sphere;
            this.capsule = capsule.clone() as Capsule;
            this.sphere.radius *= Tolerances.OUTER;
            this.capsule.radius *= Tolerances.OUTER;
        }

        /** Sets both to a model's sphere and capsule, placed where an agent is and wider by a margin. */
        public function place(model:OuterStructures, placement:Placement, margin:Number):void
        {
            model.sphere.place(placement, sphere);
            sphere.widen(margin);
            model.capsule.place(placement, capsule);
            capsule.widen(margin);
        }
    }
}
