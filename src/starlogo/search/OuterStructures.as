package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * A sphere and a capsule around an agent's structure, in the world, which are tried first (thesis §7.5).
     *
     * @private
     */
    public final class OuterStructures
    {
        /** The sphere. */
        public var sphere:Sphere = new Sphere(new Vector3D(), 0);

        /** The capsule. */
        public var capsule:Capsule = new Capsule(new Vector3D(), new Vector3D(), 0);

        /** Not placed yet. */
        public function OuterStructures()
        {
        }

        /**
         * Puts both where the agent is.
         *
         * @param shape has them
         * @param placement where its model stands
         * @param margin by how much they are to be wider
         */
        public function place(shape:ModelShape, placement:Placement, margin:Number):void
        {
            shape.outerSphere.place(placement, sphere);
            sphere.widen(margin);
            shape.outerCapsule.place(placement, capsule);
            capsule.widen(margin);
        }
    }
}
