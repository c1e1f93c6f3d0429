package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * A sphere and a capsule around a structure, which are tried first (thesis §7.5).
     *
     * @private
     */
    public final class OuterStructures
    {
        internal var sphere:Sphere = new Sphere(new Vector3D(), 0);
        internal var capsule:Capsule = new Capsule(new Vector3D(), new Vector3D(), 0);

        /** Points at the origin. */
        public function OuterStructures()
        {
        }

        /** Sets them to those of a model, placed where an agent is and wider by a margin. */
        public function place(model:OuterStructures, placement:Placement, margin:Number):void
        {
            model.sphere.place(placement, sphere);
            sphere.widen(margin);
            model.capsule.place(placement, capsule);
            capsule.widen(margin);
        }
    }
}
