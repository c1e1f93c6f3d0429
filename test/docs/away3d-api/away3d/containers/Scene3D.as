package away3d.containers
{
    /** As CubeGeometry here. */
    public class Scene3D
    {
        public function Scene3D()
        {
        }

        public function addChild(child:ObjectContainer3D):ObjectContainer3D
        {
            return child;
        }
    }
}
