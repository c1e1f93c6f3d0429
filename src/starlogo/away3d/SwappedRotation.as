package starlogo.away3d
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * Converts a rotation between the engine's space and Away3D's. Their y and z axes are swapped.
     *
     * <p>Both sides turn about x first, then about y, then about z. The swap mirrors, so <code>Rz(heading) Ry(pitch) Rx(roll)</code>
     * becomes <code>Ry(-heading) Rz(-pitch) Rx(-roll)</code>. The result is then expressed as three angles in the usual order.</p>
     */
    internal final class SwappedRotation
    {
        private var _placement:Placement = new Placement();
        private var _swapped:Placement = new Placement();
        private var _angles:Vector3D = new Vector3D();
        private var _point:Vector3D = new Vector3D();

        /**
         * Sets the rotation by its angles on one side, in degrees. Returns the angles on the other side: about x, y and z. The next call
         * overwrites them.
         */
        public function setAngles(aboutZ:Number, aboutY:Number, aboutX:Number):Vector3D
        {
            _placement.setRotation(aboutZ, aboutY, aboutX);
            // Most agents turn about one axis only. Then the angles are copied exactly, including full turns.
            if (aboutZ == 0 || aboutY == 0 && aboutX == 0)
            {
                _angles.setTo(0 - aboutX, 0 - aboutZ, 0 - aboutY);
            }
            else
            {
                // the matrix with rows and columns 1 and 2 swapped
                _swapped.r00 = _placement.r00;
                _swapped.r01 = _placement.r02;
                _swapped.r02 = _placement.r01;
                _swapped.r10 = _placement.r20;
                _swapped.r11 = _placement.r22;
                _swapped.r12 = _placement.r21;
                _swapped.r20 = _placement.r10;
                _swapped.readAngles(_angles);
            }
            return _angles;
        }

        /** Rotates a point, which is in the space that the angles came from. The next call overwrites the result. */
        public function rotate(x:Number, y:Number, z:Number):Vector3D
        {
            _point.setTo(x, y, z);
            _placement.rotate(_point, _point);
            return _point;
        }
    }
}
