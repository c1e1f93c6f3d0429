package away3d.containers
{
    import away3d.core.base.Object3D;

    /** What has children. */
    public class ObjectContainer3D extends Object3D
    {
        public function ObjectContainer3D()
        {
        }

        /** How many children there are. */
        public function get numChildren():uint
        {
            return 0;
        }

        /** The child of a number, from 0. */
        public function getChildAt(index:uint):ObjectContainer3D
        {
            return null;
        }
    }
}
