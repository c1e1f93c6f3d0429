package starlogo.away3d
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Placement;

    /**
     * A rotation as it is on the other side: with y and z swapped, which takes the engine's space to Away3D's and back.
     *
     * <p>Both turn about x first, then about y, then about z. The mirror makes
     * <code>Rz(heading) Ry(pitch) Rx(roll)</code> the same as <code>Ry(-heading) Rz(-pitch) Rx(-roll)</code>, which is taken
     * apart into angles in the order of before.</p>
     */
    internal final class SwappedTurn
    {
        /** On the other side: degrees about z, the last turn. */
        public var heading:Number = 0;

        /** On the other side: degrees about y. */
        public var pitch:Number = 0;

        /** On the other side: degrees about x, the first turn. */
        public var roll:Number = 0;

        /** A point that was turned, on this side. */
        public var x:Number = 0;

        /** @copy #x */
        public var y:Number = 0;

        /** @copy #x */
        public var z:Number = 0;

        private var _placement:Placement = new Placement();
        private var _swapped:Placement = new Placement();
        private var _angles:Vector3D = new Vector3D();

        /** No turn. */
        public function SwappedTurn()
        {
        }

        /** Sets the rotation by its angles on this side, in degrees. */
        public function setAngles(heading:Number, pitch:Number, roll:Number):void
        {
            _placement.setRotation(heading, pitch, roll);
            // a game's agents mostly turn one way: these angles are taken over as they are, full turns included
            if (heading == 0 || pitch == 0 && roll == 0)
            {
                this.heading = 0 - pitch;
                this.pitch = 0 - heading;
                this.roll = 0 - roll;
                return;
            }
            readRotation();
        }

        /** Turns a point of this side. */
        public function turn(fromX:Number, fromY:Number, fromZ:Number):void
        {
            x = _placement.r00 * fromX + _placement.r01 * fromY + _placement.r02 * fromZ;
            y = _placement.r10 * fromX + _placement.r11 * fromY + _placement.r12 * fromZ;
            z = _placement.r20 * fromX + _placement.r21 * fromY + _placement.r22 * fromZ;
        }

        // Rows and columns 1 and 2 are swapped.
        private function readRotation():void
        {
            _swapped.r00 = _placement.r00;
            _swapped.r01 = _placement.r02;
            _swapped.r02 = _placement.r01;
            _swapped.r10 = _placement.r20;
            _swapped.r11 = _placement.r22;
            _swapped.r12 = _placement.r21;
            _swapped.r20 = _placement.r10;
            _swapped.readAngles(_angles);
            heading = _angles.z;
            pitch = _angles.y;
            roll = _angles.x;
        }
    }
}
