package away3d.core.base
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;

    /** What has a place in its parent. */
    public class Object3D
    {
        public function Object3D()
        {
        }

        /** The position in the parent. */
        public function get x():Number
        {
            return NaN;
        }

        public function set x(value:Number):void
        {
        }

        /** The position in the parent. */
        public function get y():Number
        {
            return NaN;
        }

        public function set y(value:Number):void
        {
        }

        /** The position in the parent. */
        public function get z():Number
        {
            return NaN;
        }

        public function set z(value:Number):void
        {
        }

        /** Degrees about x, the first turn. */
        public function get rotationX():Number
        {
            return NaN;
        }

        public function set rotationX(value:Number):void
        {
        }

        /** Degrees about y, the second turn. */
        public function get rotationY():Number
        {
            return NaN;
        }

        public function set rotationY(value:Number):void
        {
        }

        /** Degrees about z, the third turn. */
        public function get rotationZ():Number
        {
            return NaN;
        }

        public function set rotationZ(value:Number):void
        {
        }

        /** The scale along x, before the turns. */
        public function get scaleX():Number
        {
            return NaN;
        }

        public function set scaleX(value:Number):void
        {
        }

        /** The scale along y, before the turns. */
        public function get scaleY():Number
        {
            return NaN;
        }

        public function set scaleY(value:Number):void
        {
        }

        /** The scale along z, before the turns. */
        public function get scaleZ():Number
        {
            return NaN;
        }

        public function set scaleZ(value:Number):void
        {
        }

        /** The point that the turns are about. */
        public function get pivotPoint():Vector3D
        {
            return null;
        }

        public function set pivotPoint(value:Vector3D):void
        {
        }

        /** Takes the object's own space to its parent's. */
        public function get transform():Matrix3D
        {
            return null;
        }

        public function set transform(value:Matrix3D):void
        {
        }

        /** Sets the position. */
        public function moveTo(dx:Number, dy:Number, dz:Number):void
        {
        }

        /** Sets the turns, in degrees. */
        public function rotateTo(ax:Number, ay:Number, az:Number):void
        {
        }
    }
}
