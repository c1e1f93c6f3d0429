package away3d.entities
{
    import away3d.bounds.BoundingVolumeBase;
    import away3d.containers.ObjectContainer3D;

    /** What is drawn. */
    public class Entity extends ObjectContainer3D
    {
        public function Entity()
        {
        }

        /** The volume that decides whether it is in view. */
        protected function getDefaultBoundingVolume():BoundingVolumeBase
        {
            return null;
        }
    }
}
